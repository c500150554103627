namespace UnityEngine;

[AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
public sealed class ContextMenu : Attribute { public ContextMenu(string itemName) { } }

public sealed class AddComponentMenu : Attribute { public AddComponentMenu(string menuName) { } }

[AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
public sealed class RequireComponent : Attribute { public RequireComponent(Type requiredComponent) { } }

[AttributeUsage(AttributeTargets.Class, Inherited = false)]
public sealed class CreateAssetMenuAttribute : Attribute
{
    public string menuName { get; set; }
    public string fileName { get; set; }
}

public sealed class ExecuteAlways : Attribute { }

public sealed class HideInInspector : Attribute { }
