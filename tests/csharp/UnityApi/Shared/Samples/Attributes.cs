using System;
using Penumbra.UnityApi;

namespace UnityEngine
{
    [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Scripting/Attributes.cs")]
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Scripting/Attributes.cs")]
    [AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
    public sealed class ContextMenu : Attribute
    {
        public ContextMenu(string itemName) { }
    }

    [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Scripting/Attributes.cs")]
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Scripting/Attributes.cs")]
    public sealed class AddComponentMenu : Attribute
    {
        public AddComponentMenu(string menuName) { }
    }

    [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Scripting/Attributes.cs")]
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Scripting/Attributes.cs")]
    [AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
    public sealed class RequireComponent : Attribute
    {
        public RequireComponent(Type requiredComponent) { }
    }

    [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Scripting/Attributes.cs")]
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Scripting/Attributes.cs")]
    [AttributeUsage(AttributeTargets.Class, Inherited = false)]
    public sealed class CreateAssetMenuAttribute : Attribute
    {
        public string menuName { get; set; }
        public string fileName { get; set; }
    }

    [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Scripting/Attributes.cs")]
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Scripting/Attributes.cs")]
    public sealed class ExecuteAlways : Attribute
    {
    }

    [ReadFrom(At.Unity2022, "engine", "Runtime/Export/Scripting/Attributes.cs")]
    [ReadFrom(At.Unity6, "engine", "Runtime/Export/Scripting/Attributes.cs")]
    public sealed class HideInInspector : Attribute
    {
    }
}
