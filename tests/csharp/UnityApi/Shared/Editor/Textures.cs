using Object = UnityEngine.Object;
using UnityEngine;

namespace UnityEditor
{
    public partial class AssetImporter : Object
    {
        [OwnBehaviour] public static Dictionary<string, AssetImporter> Importers { get; } = new();

        /// <summary>The number of times that its asset was imported again.</summary>
        [OwnBehaviour] public int Imports { get; private set; }

        public static AssetImporter GetAtPath(string path) =>
            Importers.TryGetValue(path, out AssetImporter importer) ? importer : null;

        public void SaveAndReimport() => ++Imports;
    }

    public sealed partial class TextureImporter : AssetImporter
    {
        /// <summary>The settings of the default platform.</summary>
        [OwnBehaviour] public TextureImporterPlatformSettings Settings { get; private set; } =
            new TextureImporterPlatformSettings();

        // The initial values are those of a new picture in a project whose default behaviour is 2D.
        public TextureImporterType textureType { get; set; } = TextureImporterType.Sprite;
        public TextureImporterShape textureShape { get; set; } = TextureImporterShape.Texture2D;
        public TextureImporterAlphaSource alphaSource { get; set; } = TextureImporterAlphaSource.None;
        public bool alphaIsTransparency { get; set; } = true;
        public bool sRGBTexture { get; set; } = true;
        public bool mipmapEnabled { get; set; } = true;
        public TextureWrapMode wrapMode { get; set; } = TextureWrapMode.Repeat;
        public TextureImporterNPOTScale npotScale { get; set; } = TextureImporterNPOTScale.ToNearest;

        public TextureImporterPlatformSettings GetDefaultPlatformTextureSettings() => new TextureImporterPlatformSettings();

        public void SetPlatformTextureSettings(TextureImporterPlatformSettings platformSettings) => Settings = platformSettings;
    }

    public sealed partial class TextureImporterPlatformSettings
    {
        public int maxTextureSize { get; set; } = 2048;
        public TextureImporterFormat format { get; set; }
        public TextureImporterCompression textureCompression { get; set; } = TextureImporterCompression.Compressed;
    }

    public enum TextureImporterType { Default = 0, Sprite = 8 }

    public enum TextureImporterShape { Texture2D = 1 << 0, Texture3D = 1 << 3 }

    public enum TextureImporterAlphaSource { None = 0, FromInput = 1 }

    public enum TextureImporterFormat { R16 = 9, RGBA64 = 74 }

    public enum TextureImporterNPOTScale { None = 0, ToNearest = 1 }

    public enum TextureImporterCompression { Uncompressed = 0, Compressed = 1 }
}

namespace UnityEngine
{
    public partial class TextAsset : Object
    {
        public TextAsset(string text) { this.text = text; }

        public string text { get; }
    }

    public static class JsonUtility
    {
        /// <summary>Reads public fields by their names, and skips other keys, as Unity's does.</summary>
        [OwnBehaviour] public static System.Func<string, System.Type, object> Reader { get; set; }

        public static T FromJson<T>(string json) => (T)Reader(json, typeof(T));
    }
}
