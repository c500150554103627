using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering.Universal;
using Object = UnityEngine.Object;

namespace Penumbra.Samples.FarShadows
{
    /// <summary>
    /// Builds a valley of four kilometres below its game object: a Terrain with a Far Shadow Ground, trees, a low sun
    /// and a camera; no asset is needed or created. Rebuilding removes only what was built before.
    /// </summary>
    [AddComponentMenu("Penumbra Samples/Far Shadows")]
    public sealed class ValleyScene : MonoBehaviour
    {
        private const string TerrainShader = "Universal Render Pipeline/Terrain/Lit";
        private const string LitShader = "Universal Render Pipeline/Lit";
        private const int Trees = 60;

        [HideInInspector] [SerializeField] private List<Object> built = new List<Object>();

        /// <summary>Everything that was created; empty before Build and after Remove.</summary>
        public IReadOnlyList<Object> Built => built;

        [ContextMenu("Build")]
        public void Build()
        {
            Remove();
            Material ground = Material(TerrainShader, "Ground", Color.white);
            Material bark = Material(LitShader, "Bark", new Color(0.36f, 0.27f, 0.2f, 1.0f));
            Material leaves = Material(LitShader, "Leaves", new Color(0.25f, 0.4f, 0.18f, 1.0f));
            AddTerrain(ground);
            AddTrees(bark, leaves);
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

        private void AddTerrain(Material material)
        {
            // The resolution comes first: setting it changes the size.
            var data = new TerrainData { name = "Penumbra Valley", heightmapResolution = ValleyHeights.Samples };
            data.size = new Vector3(ValleyHeights.SideMetres, ValleyHeights.TopMetres, ValleyHeights.SideMetres);
            data.SetHeights(0, 0, ValleyHeights.Sampled());
            built.Add(data);
            var item = new GameObject();
            const float half = 0.5f * ValleyHeights.SideMetres;
            Place(item, "Terrain", new Vector3(-half, 0.0f, -half));
            Terrain terrain = item.AddComponent<Terrain>();
            terrain.terrainData = data;
            terrain.materialTemplate = material;
            terrain.drawInstanced = true;
            item.AddComponent<FarShadowGround>().Terrain = terrain;
        }

        // The trees stand in rows beside the camera's way, so that near and far shadows meet behind them.
        private void AddTrees(Material bark, Material leaves)
        {
            for (int i = 0; i < Trees; ++i)
            {
                float x = (i % 2 == 0 ? -1.0f : 1.0f) * (8.0f + 3.0f * (i % 5));
                float z = -1480.0f + 9.0f * i;
                float foot = ValleyHeights.At(x, z);
                AddPiece(PrimitiveType.Cylinder, "Trunk", new Vector3(x, foot + 2.0f, z), new Vector3(0.5f, 2.5f, 0.5f), bark);
                AddPiece(PrimitiveType.Sphere, "Crown", new Vector3(x, foot + 6.0f, z), new Vector3(4.0f, 5.0f, 4.0f), leaves);
            }
        }

        private void AddPiece(PrimitiveType shape, string name, Vector3 centre, Vector3 scale, Material material)
        {
            GameObject item = GameObject.CreatePrimitive(shape);
            Place(item, name, centre);
            item.transform.localScale = scale;
            item.GetComponent<MeshRenderer>().sharedMaterial = material;
        }

        // The sun stands behind the ridge on the right, 12 degrees high: the left slope is lit above the ridge's
        // shadow.
        private void AddSun()
        {
            var item = new GameObject();
            Place(item, "Sun", new Vector3(0.0f, 100.0f, 0.0f));
            item.transform.localRotation = Quaternion.Euler(12.0f, 270.0f, 0.0f);
            Light light = item.AddComponent<Light>();
            light.type = LightType.Directional;
            light.intensity = 2.0f;
            light.shadows = LightShadows.Soft;
            // Contact-hardening filters need no normal bias.
            item.AddComponent<UniversalAdditionalLightData>().usePipelineSettings = false;
            light.shadowBias = 1.0f;
            light.shadowNormalBias = 0.0f;
            RenderSettings.sun = light;
        }

        private void AddCamera()
        {
            var item = new GameObject();
            Place(item, "Camera", new Vector3(0.0f, ValleyHeights.At(0.0f, -1550.0f) + 12.0f, -1550.0f));
            item.transform.localRotation = Quaternion.Euler(2.0f, 0.0f, 0.0f);
            Camera camera = item.AddComponent<Camera>();
            camera.fieldOfView = 60.0f;
            camera.nearClipPlane = 0.3f;
            camera.farClipPlane = 6000.0f;
        }

        private void Place(GameObject item, string name, Vector3 position)
        {
            item.name = name;
            item.transform.SetParent(transform, false);
            item.transform.localPosition = position;
            built.Add(item);
        }

        private Material Material(string shaderName, string name, Color color)
        {
            Shader shader = Shader.Find(shaderName);
            if (shader == null)
                throw new System.InvalidOperationException("there is no shader \"" + shaderName + "\": this scene needs " +
                                                           "URP, which this project does not use");
            var material = new Material(shader) { name = "Penumbra " + name };
            material.SetColor("_BaseColor", color);
            material.SetFloat("_Smoothness", 0.1f);
            built.Add(material);
            return material;
        }
    }
}
