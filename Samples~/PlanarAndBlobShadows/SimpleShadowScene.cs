using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Penumbra.Samples.PlanarAndBlobShadows
{
    /// <summary>
    /// Builds a scene below its game object: level ground, a sun, a camera, and two rows of shapes that rise from the
    /// ground, with planar shadows in front and blob shadows behind. Nothing casts into URP's shadow map. Rebuilding
    /// removes only what was built before.
    /// </summary>
    [AddComponentMenu("Penumbra Samples/Simple Shadow Scene")]
    public sealed class SimpleShadowScene : MonoBehaviour
    {
        private const string LitShader = "Universal Render Pipeline/Lit";

        /// <summary>Heights of the shapes' lowest points, in metres.</summary>
        internal static readonly float[] Gaps = { 0.0f, 0.1f, 0.5f, 1.5f, 3.0f };

        [HideInInspector] [SerializeField] private List<Object> built = new List<Object>();

        /// <summary>Game objects and materials of the built scene; empty before Build and after Remove.</summary>
        public IReadOnlyList<Object> Built => built;

        [ContextMenu("Build")]
        public void Build()
        {
            Remove();
            Material ground = Surface("Ground", new Color(0.62f, 0.6f, 0.56f, 1.0f));
            Material shape = Surface("Shape", new Color(0.75f, 0.42f, 0.3f, 1.0f));
            // Unity's plane is ten metres long.
            Add(PrimitiveType.Plane, "Ground", Vector3.zero, new Vector3(3.0f, 1.0f, 3.0f), ground);
            for (int i = 0; i < Gaps.Length; ++i)
            {
                float x = 2.2f * (i - 0.5f * (Gaps.Length - 1));
                Add(i % 2 == 0 ? PrimitiveType.Cube : PrimitiveType.Sphere, "Planar",
                    new Vector3(x, Gaps[i] + 0.5f, 0.0f), Vector3.one, shape).AddComponent<PlanarShadow>();
                Add(PrimitiveType.Sphere, "Blob", new Vector3(x, Gaps[i] + 0.5f, 4.0f), Vector3.one, shape)
                    .AddComponent<BlobShadow>();
            }
            AddSun();
            AddCamera();
        }

        [ContextMenu("Remove")]
        public void Remove()
        {
            foreach (Object item in built)
            {
                if (item == null) continue;
                if (Application.isPlaying) Destroy(item);
                else DestroyImmediate(item);
            }
            built.Clear();
        }

        private GameObject Add(PrimitiveType type, string name, Vector3 position, Vector3 scale, Material material)
        {
            GameObject item = GameObject.CreatePrimitive(type);
            item.name = name;
            item.transform.SetParent(transform, false);
            item.transform.localPosition = position;
            item.transform.localScale = scale;
            item.GetComponent<MeshRenderer>().sharedMaterial = material;
            built.Add(item);
            return item;
        }

        private void AddSun()
        {
            var item = new GameObject("Sun");
            item.transform.SetParent(transform, false);
            item.transform.localRotation = Quaternion.Euler(50.0f, 35.0f, 0.0f);
            Light sun = item.AddComponent<Light>();
            sun.type = LightType.Directional;
            sun.intensity = 2.0f;
            sun.shadows = LightShadows.None;
            RenderSettings.sun = sun;
            built.Add(item);
        }

        private void AddCamera()
        {
            var item = new GameObject("Camera");
            item.transform.SetParent(transform, false);
            item.transform.localPosition = new Vector3(0.0f, 5.0f, -9.0f);
            item.transform.localRotation = Quaternion.Euler(20.0f, 0.0f, 0.0f);
            Camera camera = item.AddComponent<Camera>();
            camera.fieldOfView = 60.0f;
            camera.nearClipPlane = 0.1f;
            camera.farClipPlane = 200.0f;
            built.Add(item);
        }

        private Material Surface(string name, Color color)
        {
            Shader shader = Shader.Find(LitShader);
            if (shader == null)
                throw new System.InvalidOperationException("there is no shader \"" + LitShader + "\": this scene needs URP, " +
                                                           "which this project does not use");
            var material = new Material(shader) { name = "Penumbra " + name };
            material.SetColor("_BaseColor", color);
            built.Add(material);
            return material;
        }
    }
}
