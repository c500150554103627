using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering.Universal;
using Object = UnityEngine.Object;

namespace Penumbra.Samples.Scenes
{
    /// <summary>Converts a description into game objects, and lists all objects that it creates.</summary>
    internal sealed class SceneConstruction
    {
        private const string LitShader = "Universal Render Pipeline/Lit";

        private readonly Transform parent;
        private readonly List<Object> built;
        private readonly Dictionary<SceneSurface, Material> materials = new Dictionary<SceneSurface, Material>();

        internal SceneConstruction(Transform parent, List<Object> built)
        {
            this.parent = parent;
            this.built = built;
        }

        internal void Build(SceneDescription scene)
        {
            foreach (ScenePiece piece in scene.Pieces) Add(piece);
            AddSun(scene.Sun);
            AddCamera(scene.View);
        }

        private void Add(in ScenePiece piece)
        {
            GameObject item = piece.mesh == null ? GameObject.CreatePrimitive(Primitive(piece.shape))
                                                 : FromMesh(piece.mesh);
            Place(item, piece.name, piece.centre, piece.eulerDegrees);
            if (piece.mesh == null) item.transform.localScale = PrimitiveScale(piece);
            item.GetComponent<MeshRenderer>().sharedMaterial = Material(piece.surface);
        }

        private GameObject FromMesh(SceneMesh description)
        {
            var mesh = new Mesh { name = description.Name };
            mesh.SetVertices(description.Vertices);
            mesh.SetNormals(description.Normals);
            mesh.SetTriangles(description.Triangles, 0);
            mesh.RecalculateBounds();
            built.Add(mesh);
            var item = new GameObject();
            item.AddComponent<MeshFilter>().sharedMesh = mesh;
            item.AddComponent<MeshRenderer>();
            return item;
        }

        private void AddSun(SceneSun sun)
        {
            var item = new GameObject();
            Place(item, "Sun", new Vector3(0.0f, 10.0f, 0.0f),
                  new Vector3(sun.elevationDegrees, sun.azimuthDegrees, 0.0f));
            Light light = item.AddComponent<Light>();
            light.type = LightType.Directional;
            light.intensity = 2.0f;
            light.shadows = LightShadows.Soft;
            // URP's normal bias would shrink thin casters, and contact-hardening filters need none.
            item.AddComponent<UniversalAdditionalLightData>().usePipelineSettings = false;
            light.shadowBias = 1.0f;
            light.shadowNormalBias = 0.0f;
            RenderSettings.sun = light;
        }

        private void AddCamera(SceneView view)
        {
            var item = new GameObject();
            Place(item, "Camera", view.position, view.eulerDegrees);
            Camera camera = item.AddComponent<Camera>();
            camera.fieldOfView = view.fieldOfViewDegrees;
            camera.nearClipPlane = 0.1f;
            camera.farClipPlane = 500.0f;
        }

        private void Place(GameObject item, string name, Vector3 position, Vector3 eulerDegrees)
        {
            item.name = name;
            item.transform.SetParent(parent, false);
            item.transform.localPosition = position;
            item.transform.localRotation = Quaternion.Euler(eulerDegrees.x, eulerDegrees.y, eulerDegrees.z);
            built.Add(item);
        }

        private Material Material(SceneSurface surface)
        {
            if (materials.TryGetValue(surface, out Material material)) return material;
            Shader shader = Shader.Find(LitShader);
            if (shader == null)
                throw new System.InvalidOperationException("there is no shader \"" + LitShader + "\": these scenes " +
                                                           "need URP, which this project does not use");
            material = new Material(shader) { name = "Penumbra " + surface };
            material.SetColor("_BaseColor", SceneSurfaces.Color(surface));
            material.SetFloat("_Smoothness", 0.1f);
            // Leaves are visible, and cast shadows, from both sides.
            if (surface == SceneSurface.Leaf) material.SetFloat("_Cull", 0.0f);
            materials.Add(surface, material);
            built.Add(material);
            return material;
        }

        private static PrimitiveType Primitive(PieceShape shape)
        {
            switch (shape)
            {
                case PieceShape.Cylinder: return PrimitiveType.Cylinder;
                case PieceShape.Ball: return PrimitiveType.Sphere;
                default: return PrimitiveType.Cube;
            }
        }

        // Unity's cube and sphere have a size of one metre; its cylinder is two metres high.
        private static Vector3 PrimitiveScale(in ScenePiece piece) =>
            piece.shape == PieceShape.Cylinder ? new Vector3(piece.size.x, 0.5f * piece.size.y, piece.size.z)
                                               : piece.size;
    }
}
