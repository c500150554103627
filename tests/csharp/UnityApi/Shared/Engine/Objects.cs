namespace UnityEngine;

public partial class Object
{
    public string name { get; set; } = "";

    /// <summary>Destroyed objects compare equal to null.</summary>
    [OwnBehaviour] public bool Destroyed { get; set; }

    private static bool IsGone(Object o) => o is null || o.Destroyed;

    public static bool operator ==(Object x, Object y) => IsGone(x) ? IsGone(y) : ReferenceEquals(x, y);
    public static bool operator !=(Object x, Object y) => !(x == y);
    public override bool Equals(object other) => other is null ? IsGone(this) : ReferenceEquals(this, other);
    public override int GetHashCode() => base.GetHashCode();
}

public partial class Debug { public static bool isDebugBuild { get; [OwnBehaviour] set; } = true; }

public struct LayerMask { public static string LayerToName(int layer) => layer == 4 ? "Water" : ""; }

public partial class Component : Object
{
    public Transform transform { get; } = new Transform();

    public bool TryGetComponent<T>(out T component)
    {
        component = gameObject == null ? default : gameObject.GetComponent<T>();
        return component != null;
    }
}

public partial class Transform
{
    internal Transform() { }

    public Vector3 forward { get; set; }
    public Vector3 position { get; set; }
}

public class Behaviour : Component { }

public class ScriptableObject : Object
{
    public static T CreateInstance<T>() where T : ScriptableObject => (T)System.Activator.CreateInstance(typeof(T));
}
