namespace UnityEngine
{
    [AttributeUsage(AttributeTargets.Field)]
    public sealed partial class SerializeField : Attribute { }

    [AttributeUsage(AttributeTargets.Field)]
    public abstract class PropertyAttribute : Attribute { }

    [AttributeUsage(AttributeTargets.All)]
    public class TooltipAttribute : PropertyAttribute
    {
        public readonly string tooltip;

        public TooltipAttribute(string tooltip) { this.tooltip = tooltip; }
    }

    [AttributeUsage(AttributeTargets.Field)]
    public class InspectorNameAttribute : PropertyAttribute
    {
        public readonly string displayName;

        public InspectorNameAttribute(string displayName) { this.displayName = displayName; }
    }

    [AttributeUsage(AttributeTargets.Class)]
    public class HelpURLAttribute : Attribute
    {
        private readonly string url;

        public HelpURLAttribute(string url) { this.url = url; }

#if UNITY_6000_0_OR_NEWER
        public virtual string URL => url;
#else
        public string URL => url;
#endif
    }

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class RangeAttribute : PropertyAttribute
    {
        public readonly float min, max;

        public RangeAttribute(float min, float max) => (this.min, this.max) = (min, max);
    }
}

namespace UnityEngine.Scripting
{
    [AttributeUsage(AttributeTargets.Assembly | AttributeTargets.Class | AttributeTargets.Struct | AttributeTargets.Enum |
                    AttributeTargets.Constructor | AttributeTargets.Method | AttributeTargets.Property |
                    AttributeTargets.Field | AttributeTargets.Event | AttributeTargets.Interface |
                    AttributeTargets.Delegate)]
    public class PreserveAttribute : Attribute { }

    [AttributeUsage(AttributeTargets.Class)]
    public class RequireDerivedAttribute : Attribute { }
}

namespace UnityEditor.ShaderKeywordFilter
{
    [AttributeUsage(AttributeTargets.Field, AllowMultiple = true)]
    public class FilterAttribute : Attribute { internal FilterAttribute() { } }

    [AttributeUsage(AttributeTargets.Field, AllowMultiple = true)]
    public class SelectIfAttribute : FilterAttribute
    {
        public SelectIfAttribute(object condition, bool overridePriority = false, string filePath = "",
                                 int lineNumber = 0, params string[] keywordNames) { }
    }
}
