using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEngine
{
    public class GUIContent
    {
        public GUIContent(string text, string tooltip) => (this.text, this.tooltip) = (text, tooltip);

        public string text { get; set; }
        public string tooltip { get; set; }
    }

    public sealed partial class GUIStyle { }

    public sealed class GUILayoutOption { private GUILayoutOption() { } }

    public partial class GUILayout
    {
        /// <summary>The text of the button that is pressed; null for none.</summary>
        [OwnBehaviour] public static string Pressed { get; set; }

        public static bool Button(string text, params GUILayoutOption[] options) => text == Pressed;
    }
}

namespace UnityEditor
{
    public partial class CustomEditor : Attribute { public CustomEditor(Type inspectedType) { } }

    [AttributeUsage(AttributeTargets.Method)]
    public sealed class MenuItem : Attribute { public MenuItem(string itemName) { } }

    public partial class Editor : ScriptableObject
    {
        public Object target { get; set; }
        public SerializedObject serializedObject => null;

        public virtual void OnInspectorGUI() { }
    }

    [Flags]
    public enum BuildOptions { None = 0, Development = 1 << 0 }

    public partial class EditorUserBuildSettings : Object
    {
        private EditorUserBuildSettings() { }

        public static bool development { get; set; }
    }

    public sealed partial class EditorApplication
    {
        public static event Action projectChanged;

        [OwnBehaviour] public static int Listeners => projectChanged?.GetInvocationList().Length ?? 0;

        [OwnBehaviour] public static void ChangeProject() => projectChanged?.Invoke();
    }

    public partial class EditorWindow : ScriptableObject
    {
        [OwnBehaviour] public static EditorWindow Shown { get; set; }

        public static T GetWindow<T>(string title) where T : EditorWindow
        {
            Shown = Shown as T ?? CreateInstance<T>();
            return (T)Shown;
        }

        public void Repaint() { }
    }

    public static class SettingsService
    {
        [OwnBehaviour] public static string Opened { get; set; }

        public static EditorWindow OpenProjectSettings(string settingsPath = null)
        {
            Opened = settingsPath;
            return null;
        }
    }

    public sealed partial class PrefabUtility
    {
        [OwnBehaviour] public static HashSet<Object> Recorded { get; } = new();

        public static void RecordPrefabInstancePropertyModifications(Object targetObject) => Recorded.Add(targetObject);
    }

    public enum MessageType { None = 0, Info = 1, Warning = 2, Error = 3 }

    public sealed partial class EditorGUILayout
    {
        [OwnBehaviour] public static List<string> Boxes { get; } = new();

        public static void HelpBox(string message, MessageType type) => Boxes.Add(message);
        public static void LabelField(string label, GUIStyle style, params GUILayoutOption[] options) { }
        public static Vector2 BeginScrollView(Vector2 scrollPosition, params GUILayoutOption[] options) => default;
        public static void EndScrollView() { }
        public static bool PropertyField(SerializedProperty property, params GUILayoutOption[] options) => false;
        public static Object ObjectField(GUIContent label, Object obj, Type objType, bool allowSceneObjects,
                                         params GUILayoutOption[] options) => obj;
        public static int Popup(GUIContent label, int selectedIndex, string[] displayedOptions,
                                params GUILayoutOption[] options) => selectedIndex;
        public static bool PropertyField(SerializedProperty property, GUIContent label,
                                         params GUILayoutOption[] options) => false;
    }

    public sealed class EditorStyles
    {
        public static GUIStyle boldLabel => null;
        public static GUIStyle wordWrappedLabel => null;
    }

    public partial class EditorUtility
    {
        [OwnBehaviour] public static HashSet<Object> Dirty { get; } = new();

        public static void SetDirty(Object target) => Dirty.Add(target);

        public static bool DisplayDialog(string title, string message, string ok) => true;
        public static string SaveFilePanel(string title, string directory, string defaultName, string extension) => "";
    }

    public sealed partial class AssetDatabase
    {
        public static string GetAssetPath(Object assetObject)
        {
            foreach (var asset in Assets)
                if (ReferenceEquals(asset.Value, assetObject)) return asset.Key;
            if (assetObject is not null && Contained.TryGetValue(assetObject, out Object main)) return GetAssetPath(main);
            return "";
        }
        public static Object LoadMainAssetAtPath(string assetPath) => LoadAssetAtPath<Object>(assetPath);
        [OwnBehaviour] public static Dictionary<string, Object> Assets { get; } = new();

        /// <summary>The main assets that others are parts of.</summary>
        [OwnBehaviour] public static Dictionary<Object, Object> Contained { get; } = new();

        public static T LoadAssetAtPath<T>(string assetPath) where T : Object =>
            Assets.TryGetValue(assetPath, out Object asset) ? asset as T : null;
        /// <summary>
        /// The paths of GUIDs: at first that of the package's folder of shaders, where the package manager puts it.
        /// </summary>
        [OwnBehaviour] public static Dictionary<string, string> Guids { get; } =
            new Dictionary<string, string>
            {
                { "d547e543300383e817b83b7a554c305a", "Packages/com.penumbra.shadows/Shaders" },
            };

        public static string GUIDToAssetPath(string guid) => Guids.TryGetValue(guid, out string path) ? path : "";
        [OwnBehaviour] public static int Listed { get; set; }
        [OwnBehaviour] public static string[] Paths { get; set; } = new string[0];

        public static string[] GetAllAssetPaths()
        {
            ++Listed;
            return Paths;
        }

        public static void ImportAsset(string path) { }
        public static bool CopyAsset(string path, string newPath) => false;
        public static string GenerateUniqueAssetPath(string path) => path;

        public static string[] FindAssets(string filter) => new string[0];
    }

    public partial class AssetPostprocessor { }

    public struct ShaderMessage
    {
        public ShaderMessage(string msg, Rendering.ShaderCompilerMessageSeverity sev = Rendering.ShaderCompilerMessageSeverity.Error)
        {
            message = msg;
            severity = sev;
            file = "";
            line = 0;
            platform = Rendering.ShaderCompilerPlatform.None;
        }

        public string message { get; }
        public string file { get; [OwnBehaviour] set; }
        public int line { get; [OwnBehaviour] set; }
        public Rendering.ShaderCompilerPlatform platform { get; [OwnBehaviour] set; }
        public Rendering.ShaderCompilerMessageSeverity severity { get; }
    }

    public sealed partial class ShaderUtil
    {
        /// <summary>The compiler's messages, by shader.</summary>
        [OwnBehaviour] public static Dictionary<Object, ShaderMessage[]> Messages { get; } = new();

        public static ShaderMessage[] GetShaderMessages(Shader s) => MessagesOf(s);
        public static ShaderMessage[] GetComputeShaderMessages(ComputeShader s) => MessagesOf(s);

        private static ShaderMessage[] MessagesOf(Object shader) =>
            Messages.TryGetValue(shader, out ShaderMessage[] messages) ? messages : new ShaderMessage[0];

        public static void SetAsyncCompilation(UnityEngine.Rendering.CommandBuffer cmd, bool allow) =>
            cmd.Record(static (device, value) => device.CompilesAsynchronously = value, allow);

        public static void RestoreAsyncCompilation(UnityEngine.Rendering.CommandBuffer cmd) => SetAsyncCompilation(cmd, true);
    }
}

namespace UnityEditor.Build.Reporting
{
    public struct BuildSummary { public BuildOptions options { get; } }

    public sealed partial class BuildReport : Object
    {
        private BuildReport() { }

        public BuildSummary summary => default;
    }
}

namespace UnityEditor.Build
{
    public interface IPreprocessBuildWithReport : IOrderedCallback
    {
        void OnPreprocessBuild(Reporting.BuildReport report);
    }

    public interface IPostprocessBuildWithReport : IOrderedCallback
    {
        void OnPostprocessBuild(Reporting.BuildReport report);
    }

    public interface IOrderedCallback { int callbackOrder { get; } }

    public interface IPreprocessShaders : IOrderedCallback
    {
        void OnProcessShader(Shader shader, Rendering.ShaderSnippetData snippet,
                             IList<Rendering.ShaderCompilerData> data);
    }

    public interface IPreprocessComputeShaders : IOrderedCallback
    {
        void OnProcessComputeShader(ComputeShader shader, string kernelName,
                                    IList<Rendering.ShaderCompilerData> data);
    }
}

namespace UnityEditor.Rendering
{
    public struct ShaderSnippetData { public string passName => ""; }

    public enum ShaderCompilerMessageSeverity { Error, Warning }

    public struct ShaderCompilerData
    {
        public UnityEngine.Rendering.ShaderKeywordSet shaderKeywordSet;
        public ShaderCompilerPlatform shaderCompilerPlatform { get; [OwnBehaviour] set; }
    }
}

namespace UnityEngine.Rendering
{
    public partial struct ShaderKeyword
    {
        [OwnBehaviour] public string Name { get; }

        public ShaderKeyword(string keywordName) { Name = keywordName; }
        public ShaderKeyword(Shader shader, string keywordName) { Name = keywordName; }
        public ShaderKeyword(ComputeShader shader, string keywordName) { Name = keywordName; }
    }

    public struct ShaderKeywordSet
    {
        [OwnBehaviour] public HashSet<string> Enabled { get; set; }

        public bool IsEnabled(ShaderKeyword keyword) => Enabled != null && Enabled.Contains(keyword.Name);
    }
}
