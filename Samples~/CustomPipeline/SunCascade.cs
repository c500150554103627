using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Samples.CustomPipeline
{
    /// <summary>
    /// One cascade as the engine computes it, converted for the library's shaders.
    /// <para>Spaces: world, metres; atlas UV, 0 to 1 over the whole map; depth as the map stores it.</para>
    /// </summary>
    internal struct SunCascade
    {
        internal Matrix4x4 view;
        internal Matrix4x4 projection;
        internal ShadowSplitData split;

        /// <summary>The cascade's rectangle in the map, in texels.</summary>
        internal Rect viewport;

        /// <summary>The matrix from world space to atlas UV and stored depth.</summary>
        internal Matrix4x4 worldToShadow;

        /// <summary>All of ShadowTile's scales: UV and depth per metre and the penumbra's.</summary>
        internal CascadeScales scales;

        /// <summary>xyz: centre of the split's sphere, w: its squared radius, 0 if the cascade has no map.</summary>
        internal Vector4 Sphere
        {
            get
            {
                Vector4 sphere = split.cullingSphere;
                float squaredRadius = scales.IsMapped ? sphere.w * sphere.w : 0.0f;
                return new Vector4(sphere.x, sphere.y, sphere.z, squaredRadius);
            }
        }

        internal Vector4 Scales =>
            new Vector4(scales.UvPerMetre, scales.DepthPerMetre, scales.DepthToRadial, scales.RadialToDepth);

        /// <summary>Computes the other fields from the engine's matrices.</summary>
        internal void Place(int index, in AtlasLayout layout, float angularDiameterDegrees, bool reversedDepth)
        {
            Vector4 tile = layout.Tile(index);
            viewport = new Rect(tile.x * layout.Width, tile.y * layout.Height, layout.TileResolution,
                                layout.TileResolution);
            worldToShadow = ToAtlas(tile, reversedDepth) * projection * view;
            scales = new CascadeScales(worldToShadow, layout, angularDiameterDegrees);
        }

        /// <summary>
        /// Converts the engine's projections, which lead to OpenGL's clip space, -1 to 1 in all three axes, on every
        /// device: to the tile's rectangle, and to depth from 0 at the near plane to 1, or from 1 to 0 if depth is
        /// reversed.
        /// </summary>
        internal static Matrix4x4 ToAtlas(Vector4 tile, bool reversedDepth)
        {
            float depth = reversedDepth ? -0.5f : 0.5f;
            float width = 0.5f * tile.z;
            float height = 0.5f * tile.w;
            return new Matrix4x4(new Vector4(width, 0.0f, 0.0f, 0.0f), new Vector4(0.0f, height, 0.0f, 0.0f),
                                 new Vector4(0.0f, 0.0f, depth, 0.0f),
                                 new Vector4(tile.x + width, tile.y + height, 0.5f, 1.0f));
        }
    }
}
