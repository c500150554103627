using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    /// <summary>The format that a chain's texture has on this device.</summary>
    internal static class DeviceFormats
    {
        /// <summary>
        /// One channel of 8 bits, visibility or a mask, is the one format that has others in its place: all devices draw to
        /// one of four channels, and all that run kernels write 32 bits.
        /// </summary>
        internal static GraphicsFormat Of(in ChainTexture texture)
        {
            if (texture.format != GraphicsFormat.R8_UNorm || Can(texture.format, texture.randomWrite))
                return texture.format;
            return texture.randomWrite ? GraphicsFormat.R32_SFloat : GraphicsFormat.B8G8R8A8_UNorm;
        }

        /// <summary>The device can do with such a texture what the chain does.</summary>
        internal static bool IsSupported(in ChainTexture texture) => Can(Of(texture), texture.randomWrite);

        // A texture that kernels write is cleared as a target, too.
        private static bool Can(GraphicsFormat format, bool randomWrite) =>
            CanDrawTo(format) && (!randomWrite || CanWrite(format));

#if UNITY_6000_0_OR_NEWER
        private static bool CanDrawTo(GraphicsFormat format) =>
            SystemInfo.IsFormatSupported(format, GraphicsFormatUsage.Render);

        private static bool CanWrite(GraphicsFormat format) =>
            SystemInfo.IsFormatSupported(format, GraphicsFormatUsage.LoadStore);
#else
        private static bool CanDrawTo(GraphicsFormat format) => SystemInfo.IsFormatSupported(format, FormatUsage.Render);

        private static bool CanWrite(GraphicsFormat format) =>
            SystemInfo.IsFormatSupported(format, FormatUsage.LoadStore);
#endif
    }
}
