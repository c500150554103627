using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Penumbra.Samples.ShadowVolumes
{
    /// <summary>
    /// Builds a scene below its game object: boxes that touch and hover above the ground, an open sheet, a sun without
    /// shadow maps, and a camera that stands in the largest shadow. No asset is needed or created. Rebuilding removes
    /// only what was built before.
    /// </summary>
    [AddComponentMenu("Penumbra Samples/Shadow Volume Scene")]
    public sealed class ShadowVolumeScene : MonoBehaviour
    {
        private const string LitShader = "Universal Render Pipeline/Lit";
        private const string CountShader = "Penumbra Samples/Shadow Volume Count";
        private const string DarkenShader = "Penumbra Samples/Shadow Volume Darken";

        [HideInInspector] [SerializeField] private List<Object> built = new List<Object>();

        /// <summary>
        /// Game objects, meshes and materials of the built scene; empty before Build and after Remove.
        /// </summary>
        public IReadOnlyList<Object> Built => built;

        [ContextMenu("Build")]
        public void Build()
        {
            Remove();
            Material lit = Made(LitShader);
            Material count = Made(CountShader);
            Material darken = Made(DarkenShader);
            // The ground has no volume: nothing lies below it.
            Box("Ground", new Vector3(0.0f, -0.1f, 8.0f), new Vector3(40.0f, 0.2f, 40.0f), 0.0f, lit, null);
            Box("Roof", new Vector3(0.0f, 4.0f, 1.0f), new Vector3(5.0f, 0.2f, 5.0f), 0.0f, lit, count);
            Box("Block", new Vector3(-2.5f, 0.5f, 7.0f), new Vector3(1.0f, 1.0f, 1.0f), 25.0f, lit, count);
            Box("Hovering", new Vector3(0.5f, 1.5f, 8.0f), new Vector3(1.5f, 0.3f, 1.5f), 40.0f, lit, count);
            Box("Wall", new Vector3(4.0f, 1.0f, 9.0f), new Vector3(0.2f, 2.0f, 4.0f), -10.0f, lit, count);
            Sheet(new Vector3(-4.5f, 1.2f, 10.0f), lit, count);
            AddSun();
            AddCamera();
            Item("Darkening", Vector3.zero, Vector3.zero).AddComponent<ShadowVolumeDarkening>().Material = darken;
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

        private Material Made(string name)
        {
            Shader shader = Shader.Find(name);
            if (shader == null)
                throw new InvalidOperationException("there is no shader \"" + name + "\": this scene needs URP and the " +
                                                    "shaders of its sample");
            var material = new Material(shader) { name = name };
            built.Add(material);
            return material;
        }

        private GameObject Placed(GameObject item, string name, Vector3 position, Vector3 eulerDegrees)
        {
            item.name = name;
            item.transform.SetParent(transform, false);
            item.transform.localPosition = position;
            item.transform.localRotation = Quaternion.Euler(eulerDegrees.x, eulerDegrees.y, eulerDegrees.z);
            built.Add(item);
            return item;
        }

        private GameObject Item(string name, Vector3 position, Vector3 eulerDegrees) =>
            Placed(new GameObject(), name, position, eulerDegrees);

        private void Box(string name, Vector3 centre, Vector3 size, float turnDegrees, Material lit, Material count)
        {
            GameObject box = Placed(GameObject.CreatePrimitive(PrimitiveType.Cube), name, centre,
                                    new Vector3(0.0f, turnDegrees, 0.0f));
            box.transform.localScale = size;
            box.GetComponent<MeshRenderer>().sharedMaterial = lit;
            if (count != null) box.AddComponent<ShadowVolumeCaster>().Material = count;
        }

        // The sheet is an open mesh: two triangles with an edge in common, bent, and no other side.
        private void Sheet(Vector3 centre, Material lit, Material count)
        {
            var mesh = new Mesh { name = "Sheet" };
            mesh.SetVertices(new List<Vector3>
            {
                new Vector3(0.0f, 0.0f, -1.0f), new Vector3(0.0f, 0.0f, 1.0f), new Vector3(1.2f, 0.4f, 0.0f),
                new Vector3(-1.2f, 0.6f, 0.0f),
            });
            mesh.SetNormals(new List<Vector3> { Vector3.up, Vector3.up, Vector3.up, Vector3.up });
            mesh.SetTriangles(new List<int> { 0, 1, 2, 0, 3, 1 }, 0);
            mesh.RecalculateBounds();
            built.Add(mesh);
            GameObject sheet = Item("Sheet", centre, Vector3.zero);
            sheet.AddComponent<MeshFilter>().sharedMesh = mesh;
            sheet.AddComponent<MeshRenderer>().sharedMaterial = lit;
            sheet.AddComponent<ShadowVolumeCaster>().Material = count;
        }

        private void AddSun()
        {
            Light sun = Item("Sun", new Vector3(0.0f, 10.0f, 0.0f), new Vector3(50.0f, 30.0f, 0.0f))
                .AddComponent<Light>();
            sun.type = LightType.Directional;
            sun.intensity = 2.0f;
            sun.shadows = LightShadows.None;
            RenderSettings.sun = sun;
        }

        private void AddCamera()
        {
            Camera camera = Item("Camera", new Vector3(0.0f, 1.7f, 0.0f), new Vector3(8.0f, 0.0f, 0.0f))
                .AddComponent<Camera>();
            camera.fieldOfView = 60.0f;
            camera.nearClipPlane = 0.1f;
            camera.farClipPlane = 200.0f;
        }
    }
}
