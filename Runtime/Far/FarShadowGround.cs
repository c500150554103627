using System.Collections.Generic;
using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// The ground whose far shadows the feature draws: a Terrain, whose heights are read as they are drawn, or textures
    /// of `penumbra bake`. A camera uses the nearest enabled one of the scenes that are loaded; ground of others casts
    /// no far shadow on it. For several Terrains side by side, bake one height map of all.
    /// </summary>
    [ExecuteAlways]
    [AddComponentMenu("Rendering/Penumbra Far Shadow Ground")]
    [PackagePage("renderer-feature.md")]
    public sealed class FarShadowGround : MonoBehaviour
    {
        internal const string NoGround = "no Far Shadow Ground is enabled in the loaded scenes. Add Component > Rendering > " +
                                         "Penumbra Far Shadow Ground to the Terrain";
        internal const string NoHeights = "the Far Shadow Ground has neither a Terrain with data nor a height map. Add it to the " +
                                          "Terrain, or give the file of `penumbra bake heightfield` to Assign Bake";
        internal const string NoAngles = "the Far Shadow Ground lacks one of the two pictures of horizon angles. Give the " +
                                         "file of `penumbra bake horizon` to Assign Bake, or set Far Shadows to Height Map";
        internal const string NoSize = "the Far Shadow Ground has no Terrain, and no size. Copy size_metres of the bake's file";
        internal const string NoRange = "the highest height of the Far Shadow Ground is not above its lowest. Copy heights_metres of " +
                                        "the bake's file";

        private static readonly List<FarShadowGround> enabledOnes = new List<FarShadowGround>();

        [Tooltip("The Terrain that casts far shadows. Empty: that of this game object, if it has one. With a Terrain, its " +
                 "place and size are those of the horizon angles, too.")]
        [SerializeField] private Terrain terrain;

        [Tooltip("Without a Terrain: the picture of `penumbra bake heightfield`. Assign Bake sets it, and its import settings.")]
        [SerializeField] private Texture2D heightMap;

        [Tooltip("The first picture of `penumbra bake horizon`: 0 to 135 degrees from +Z towards +X. Assign Bake sets both, and " +
                 "their import settings.")]
        [SerializeField] private Texture2D horizonFirst;

        [Tooltip("The second picture of `penumbra bake horizon`: 180 to 315 degrees from +Z towards +X.")]
        [SerializeField] private Texture2D horizonSecond;

        [Tooltip("Without a Terrain: world x and z of the pictures' smallest corner in metres: corner_metres of the bake's " +
                 "file.")]
        [SerializeField] private Vector2 cornerMetres;

        [Tooltip("Without a Terrain: size along x and z in metres: size_metres of the bake's file.")]
        [SerializeField] private Vector2 sizeMetres = new Vector2(1000.0f, 1000.0f);

        [Tooltip("Without a Terrain: world heights of black and of white in metres: heights_metres of the bake's file.")]
        [SerializeField] private Vector2 heightsMetres = new Vector2(0.0f, 600.0f);

        private Terrain own;

        /// <summary>
        /// The Terrain that was assigned. If it is null, that of this game object is used, if it has one.
        /// </summary>
        public Terrain Terrain { get => terrain; set => terrain = value; }

        /// <summary>The height map of `penumbra bake heightfield`, for ground without a Terrain.</summary>
        public Texture2D HeightMap { get => heightMap; set => heightMap = value; }

        /// <summary>The first picture of `penumbra bake horizon`.</summary>
        public Texture2D HorizonFirst { get => horizonFirst; set => horizonFirst = value; }

        /// <summary>The second picture of `penumbra bake horizon`.</summary>
        public Texture2D HorizonSecond { get => horizonSecond; set => horizonSecond = value; }

        /// <summary>The smallest corner's world x and z, for ground without a Terrain.</summary>
        public Vector2 CornerMetres { get => cornerMetres; set => cornerMetres = value; }

        /// <summary>The size along x and z, for ground without a Terrain.</summary>
        public Vector2 SizeMetres { get => sizeMetres; set => sizeMetres = value; }

        /// <summary>The world heights that stored 0 and 1 mean, for ground without a Terrain.</summary>
        public Vector2 HeightsMetres { get => heightsMetres; set => heightsMetres = value; }

        private void OnEnable()
        {
            if (!enabledOnes.Contains(this)) enabledOnes.Add(this);
            TryGetComponent(out own);
        }

        private void OnDisable() => enabledOnes.Remove(this);

        /// <summary>
        /// The ground of a camera at `position`: the nearest that has what the mode needs. Returns null, or what is
        /// missing, as a message with its remedy.
        /// </summary>
        internal static string Find(FarShadowMode mode, Vector3 position, out FarGround ground)
        {
            ground = default;
            string problem = NoGround;
            float nearest = float.PositiveInfinity;
            for (int i = 0; i < enabledOnes.Count; ++i)
            {
                string lacks = enabledOnes[i].Lacks(mode, out FarGround found);
                float distance = SquaredDistance(found.area, position);
                if (lacks != null)
                {
                    if (problem != null) problem = lacks;
                    continue;
                }
                if (problem == null && !(distance < nearest)) continue;
                problem = null;
                nearest = distance;
                ground = found;
            }
            return problem;
        }

        // Returns null, or what the mode needs and this ground lacks.
        private string Lacks(FarShadowMode mode, out FarGround ground)
        {
            ground = default;
            Terrain used = terrain != null ? terrain : own;
            bool hasTerrain = used != null && TerrainHeights.TryGet(used, ref ground);
            if (!hasTerrain)
            {
                ground.area = new Vector4(cornerMetres.x, cornerMetres.y, sizeMetres.x, sizeMetres.y);
                ground.heightMap = heightMap;
                ground.channels = new Vector4(1.0f, 0.0f, 0.0f, 0.0f);
                ground.heights = new Vector4(heightsMetres.x, heightsMetres.y, heightMap != null ? heightMap.width : 0.0f,
                                             heightMap != null ? heightMap.height : 0.0f);
                if (!(sizeMetres.x > 0.0f && sizeMetres.y > 0.0f)) return NoSize;
            }
            if (mode == FarShadowMode.HorizonAngles)
            {
                ground.horizonFirst = horizonFirst;
                ground.horizonSecond = horizonSecond;
                return horizonFirst != null && horizonSecond != null ? null : NoAngles;
            }
            if (hasTerrain) return null;
            if (heightMap == null) return NoHeights;
            return heightsMetres.y > heightsMetres.x ? null : NoRange;
        }

        // The squared level distance from the area's rectangle; 0 over it.
        private static float SquaredDistance(Vector4 area, Vector3 position)
        {
            float x = Beside(position.x, area.x, area.z);
            float z = Beside(position.z, area.y, area.w);
            return x * x + z * z;
        }

        private static float Beside(float place, float corner, float size) =>
            Mathf.Max(Mathf.Max(corner - place, place - (corner + size)), 0.0f);
    }
}
