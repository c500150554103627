namespace UnityEngine;

[ReadFrom(At.Engine, "engine", "Runtime/Export/Scripting/Attributes.cs")]
[AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
public sealed class ContextMenu : Attribute { public ContextMenu(string itemName) { } }

[ReadFrom(At.Engine, "engine", "Runtime/Export/Scripting/Attributes.cs")]
public sealed class AddComponentMenu : Attribute { public AddComponentMenu(string menuName) { } }

[ReadFrom(At.Engine, "engine", "Runtime/Export/Scripting/Attributes.cs")]
[AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
public sealed class RequireComponent : Attribute { public RequireComponent(Type requiredComponent) { } }

[ReadFrom(At.Engine, "engine", "Runtime/Export/Scripting/Attributes.cs")]
[AttributeUsage(AttributeTargets.Class, Inherited = false)]
public sealed class CreateAssetMenuAttribute : Attribute
{
    public string menuName { get; set; }
    public string fileName { get; set; }
}

[ReadFrom(At.Engine, "engine", "Runtime/Export/Scripting/Attributes.cs")]
public sealed class ExecuteAlways : Attribute { }

[ReadFrom(At.Engine, "engine", "Runtime/Export/Scripting/Attributes.cs")]
public sealed class HideInInspector : Attribute { }
