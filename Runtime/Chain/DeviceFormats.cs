using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    /// <summary>The format of a chain's texture on this device.</summary>
    internal static class DeviceFormats
    {
        /// <summary>
        /// The format of the texture on this device. Only the format with one 8-bit channel, of visibility and masks,
        /// has replacements: all devices can render to a format with four channels, and all that support compute
        /// shaders can write 32 bits.
        /// </summary>
        internal static GraphicsFormat Of(in ChainTexture texture)
        {
            if (texture.format != GraphicsFormat.R8_UNorm || Can(texture.format, texture.randomWrite))
                return texture.format;
            return texture.randomWrite ? GraphicsFormat.R32_SFloat : GraphicsFormat.B8G8R8A8_UNorm;
        }

        /// <summary>Whether the device supports what the chain does with such a texture.</summary>
        internal static bool IsSupported(in ChainTexture texture) => Can(Of(texture), texture.randomWrite);

        /// <summary>Whether the device interpolates between texels of the texture, where a filter needs that.</summary>
        internal static bool IsFilteredAsNeeded(in ChainTexture texture) => !texture.filtered || CanFilter(Of(texture));

        // A texture that kernels write is also cleared as a render target.
        private static bool Can(GraphicsFormat format, bool randomWrite) =>
            CanDrawTo(format) && (!randomWrite || CanWrite(format));

#if UNITY_6000_0_OR_NEWER
        private static bool CanDrawTo(GraphicsFormat format) =>
            SystemInfo.IsFormatSupported(format, GraphicsFormatUsage.Render);

        private static bool CanWrite(GraphicsFormat format) =>
            SystemInfo.IsFormatSupported(format, GraphicsFormatUsage.LoadStore);

        private static bool CanFilter(GraphicsFormat format) =>
            SystemInfo.IsFormatSupported(format, GraphicsFormatUsage.Linear);
#else
        private static bool CanDrawTo(GraphicsFormat format) => SystemInfo.IsFormatSupported(format, FormatUsage.Render);

        private static bool CanWrite(GraphicsFormat format) =>
            SystemInfo.IsFormatSupported(format, FormatUsage.LoadStore);

        private static bool CanFilter(GraphicsFormat format) => SystemInfo.IsFormatSupported(format, FormatUsage.Linear);
#endif
    }
}
