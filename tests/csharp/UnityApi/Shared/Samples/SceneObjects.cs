using UnityEngine.Rendering;

namespace UnityEngine
{
    public partial class Object
    {
        public HideFlags hideFlags { get; set; }

        public static void Destroy(Object obj) => DestroyImmediate(obj);

        public static void DestroyImmediate(Object obj)
        {
            if (obj is not null) obj.Destroyed = true;
        }
    }

    [Flags]
    public enum HideFlags { None = 0, HideInHierarchy = 1, HideAndDontSave = 61 }

    public partial class Component
    {
        /// <summary>The game object that the component was added to.</summary>
        [OwnBehaviour] public GameObject Owner { get; set; }

        public GameObject gameObject => Owner;
    }

    public class MonoBehaviour : Behaviour { }

    public sealed partial class GameObject : Object
    {
        [OwnBehaviour] public List<Component> Components { get; } = new();

        public GameObject() { }

        public GameObject(string name) { this.name = name; }

        public Transform transform { get; } = new Transform();

        public T AddComponent<T>() where T : Component
        {
            var component = (T)Activator.CreateInstance(typeof(T));
            component.Owner = this;
            Components.Add(component);
            return component;
        }

        public T GetComponent<T>()
        {
            foreach (Component component in Components)
                if (component is T found) return found;
            return default;
        }

        public static GameObject CreatePrimitive(PrimitiveType type)
        {
            var item = new GameObject(type.ToString());
            item.AddComponent<MeshFilter>();
            item.AddComponent<MeshRenderer>();
            return item;
        }
    }

    public partial class Transform
    {
        public Vector3 localPosition { get; set; }
        public Quaternion localRotation { get; set; }
        public Vector3 localScale { get; set; } = Vector3.one;
        [OwnBehaviour] public Transform Above { get; private set; }

        /// <summary>The vector is returned as if nothing were turned.</summary>
        public Vector3 InverseTransformVector(Vector3 vector) =>
            new Vector3(vector.x / localScale.x, vector.y / localScale.y, vector.z / localScale.z);

        public void SetParent(Transform parent, bool worldPositionStays) => Above = parent;
    }

    public enum PrimitiveType { Sphere = 0, Capsule = 1, Cylinder = 2, Cube = 3, Plane = 4, Quad = 5 }

    public sealed partial class MeshFilter : Component { public Mesh sharedMesh { get; set; } }

    public partial class Renderer : Component
    {
        public Material sharedMaterial { get; set; }
        public ShadowCastingMode shadowCastingMode { get; set; } = ShadowCastingMode.On;
        public bool receiveShadows { get; set; } = true;
    }

    public partial class MeshRenderer : Renderer { }

    public sealed partial class Mesh : Object
    {
        public Mesh() { }

        [OwnBehaviour] public bool Readable { get; set; } = true;

        public bool isReadable => Readable;

        public IndexFormat indexFormat { get; set; }

        public Bounds bounds { get; set; }
        public Vector3[] vertices { get; set; } = new Vector3[0];
        public int[] triangles { get; set; } = new int[0];

        public void SetVertices(List<Vector3> inVertices) => vertices = inVertices.ToArray();
        public void SetNormals(List<Vector3> inNormals) { }
        public void SetTriangles(List<int> triangles, int submesh) => this.triangles = triangles.ToArray();
        public void RecalculateBounds() { }
    }

    public partial struct Bounds
    {
        public Bounds(Vector3 center, Vector3 size) => (this.center, this.size) = (center, size);

        public Vector3 center { get; set; }
        public Vector3 size { get; set; }
    }

    public partial class Material
    {
        public void SetColor(string name, Color value) { }

        public void SetFloat(string name, float value) { }
    }

    public partial class Application { public static bool isPlaying { get; [OwnBehaviour] set; } }
}

namespace UnityEngine.Rendering
{
    public enum ShadowCastingMode { Off = 0, On = 1, TwoSided = 2, ShadowsOnly = 3 }

    public enum IndexFormat { UInt16 = 0, UInt32 = 1 }
}

namespace UnityEngine.Rendering.Universal
{
    public partial class UniversalAdditionalLightData : MonoBehaviour { }
}
