using UnityEditor;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>
    /// Imports a picture of 16 bits a channel so that its numbers arrive in shaders as they were baked.
    /// </summary>
    internal static class BakedPicture
    {
        private const int LargestSide = 16384;

        /// <summary>
        /// Sets the import settings and imports the picture; null if there is no picture at `path`. Settings that
        /// override the default for one platform stay.
        /// </summary>
        internal static Texture2D Import(string path, bool hasHeights)
        {
            if (AssetImporter.GetAtPath(path) is TextureImporter importer)
            {
                // A project for 2D imports sprites, whose colours change where alpha is 0: alpha is an angle, too.
                importer.textureType = TextureImporterType.Default;
                importer.textureShape = TextureImporterShape.Texture2D;
                importer.alphaSource = TextureImporterAlphaSource.FromInput;
                importer.alphaIsTransparency = false;
                importer.sRGBTexture = false;
                importer.mipmapEnabled = false;
                importer.wrapMode = TextureWrapMode.Clamp;
                // Heights have a power of two plus one samples a side.
                importer.npotScale = TextureImporterNPOTScale.None;
                TextureImporterPlatformSettings settings = importer.GetDefaultPlatformTextureSettings();
                settings.maxTextureSize = LargestSide;
                settings.textureCompression = TextureImporterCompression.Uncompressed;
                settings.format = hasHeights ? TextureImporterFormat.R16 : TextureImporterFormat.RGBA64;
                importer.SetPlatformTextureSettings(settings);
                importer.SaveAndReimport();
            }
            return AssetDatabase.LoadAssetAtPath<Texture2D>(path);
        }
    }
}
