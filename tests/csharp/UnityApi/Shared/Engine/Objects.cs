namespace UnityEngine;

[ReadFrom(At.Engine, "engine", "Runtime/Export/Scripting/UnityEngineObject.bindings.cs")]
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

[ReadFrom(At.Engine, "engine", "Runtime/Export/Debug/Debug.bindings.cs")]
public partial class Debug { public static bool isDebugBuild { get; [OwnBehaviour] set; } = true; }

[ReadFrom(At.Engine, "engine", "Runtime/Export/Scripting/LayerMask.bindings.cs")]
public struct LayerMask { public static string LayerToName(int layer) => layer == 4 ? "Water" : ""; }

[ReadFrom(At.Engine, "engine", "Runtime/Export/Scripting/Component.bindings.cs")]
public partial class Component : Object
{
    public Transform transform { get; } = new Transform();

    public bool TryGetComponent<T>(out T component)
    {
        component = gameObject == null ? default : gameObject.GetComponent<T>();
        return component != null;
    }
}

[ReadFrom(At.Engine, "engine", "Runtime/Transform/ScriptBindings/Transform.bindings.cs")]
public partial class Transform
{
    internal Transform() { }

    public Vector3 forward { get; set; }
    public Vector3 position { get; set; }
}

[ReadFrom(At.Engine, "engine", "Runtime/Export/Scripting/Behaviour.bindings.cs")] public class Behaviour : Component { }

[ReadFrom(At.Engine, "engine", "Runtime/Export/Scripting/ScriptableObject.bindings.cs")]
public class ScriptableObject : Object
{
    public static T CreateInstance<T>() where T : ScriptableObject => (T)System.Activator.CreateInstance(typeof(T));
}
