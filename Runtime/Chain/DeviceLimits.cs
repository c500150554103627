using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>
    /// Tells why a chain cannot run on this device, as a message. Most reasons are limits of WebGL and OpenGL ES;
    /// PreparedChain checks the programs themselves.
    /// </summary>
    internal static class DeviceLimits
    {
        /// <summary>
        /// Whether the device's interface is OpenGL, which does not define raw reads of the shadow map. Shaders compute
        /// another filter there in the place of one that reads it (TechniqueByKeyword.hlsl). WebGPU counts as OpenGL,
        /// because no frame was seen there yet.
        /// </summary>
        internal static bool IsOpenGl =>
#if UNITY_6000_0_OR_NEWER
            SystemInfo.graphicsDeviceType == GraphicsDeviceType.WebGPU ||
#endif
            SystemInfo.graphicsDeviceType == GraphicsDeviceType.OpenGLCore ||
            SystemInfo.graphicsDeviceType == GraphicsDeviceType.OpenGLES3;

        /// <summary>The value of SystemInfo.graphicsShaderLevel for shader target 4.5.</summary>
        internal const int Level45 = 45;

        /// <summary>
        /// The reason why this device can run neither the options' passes before the filter, whatever they are, nor the
        /// filter; null if it can.
        /// </summary>
        internal static string Problem(in ShadowOptions options)
        {
            bool hasMaps = options.HasPasses && ChainSubstitute.Has(options.technique);
            if (IsOpenGl && (options.MasksConservatively || hasMaps))
                return "OpenGL does not define how its passes read the shadow map";
            return options.technique.Entry().needsTarget45 && SystemInfo.graphicsShaderLevel < Level45
                       ? "it needs shader model 4.5" : null;
        }

        /// <summary>The reason why this device cannot run the chain; null if it can.</summary>
        internal static string Problem(ShadowChain chain)
        {
            foreach (ChainTexture texture in chain.Slots)
            {
                string problem = Problem(texture);
                if (problem != null) return problem;
            }
            foreach (ChainStep step in chain.Steps)
            {
                string problem = Problem(step);
                if (problem != null) return problem;
            }
            return null;
        }

        private static string Problem(in ChainTexture texture)
        {
            if (!DeviceFormats.IsSupported(texture))
                return "this device cannot " + (texture.randomWrite ? "write" : "draw to") + " textures of " +
                       texture.format;
            if (!DeviceFormats.IsFilteredAsNeeded(texture)) return "this device cannot filter textures of " + texture.format;
            if (texture.depth > 1 && !SystemInfo.supports3DRenderTextures)
                return "this device cannot draw to 3D textures";
            if ((texture.layers > 1 || texture.extent == GraphExtent.Tile) && !SystemInfo.supports2DArrayTextures)
                return "this device does not support texture arrays";
            return texture.samples > 1 && SystemInfo.supportsMultisampledTextures == 0
                       ? "this device cannot read multisampled textures" : null;
        }

        private static string Problem(ChainStep step)
        {
            string pass = "pass '" + step.pass.program + "' ";
            if (step.reads.Any(read => read.levels != null) &&
                (SystemInfo.copyTextureSupport & CopyTextureSupport.Basic) == 0)
                return pass + "generates mip levels from copies, and this device cannot copy textures";
            if (step.pass.kind == PassKind.Compute) return null;
#if !UNITY_6000_0_OR_NEWER
            if (step.pass.testsShadowMap)
                return pass + "tests casters against the shadow map, which only URP 17 (Unity 6) gives access to";
#endif
            return step.writes.Length > SystemInfo.supportedRenderTargetCount
                       ? pass + "draws to " + step.writes.Length + " textures at once, and this device supports " +
                             SystemInfo.supportedRenderTargetCount
                       : null;
        }

        /// <summary>The reason why the device cannot run thread groups of the kernel's size; null if it can.</summary>
        internal static string Problem(GraphPass kernel, Vector3Int threads)
        {
            int all = threads.x * threads.y * threads.z;
            if (threads.x <= SystemInfo.maxComputeWorkGroupSizeX && threads.y <= SystemInfo.maxComputeWorkGroupSizeY &&
                threads.z <= SystemInfo.maxComputeWorkGroupSizeZ && all <= SystemInfo.maxComputeWorkGroupSize) return null;
            return "kernel '" + kernel.program + "' has groups of " + all + " threads, and this device allows " +
                   SystemInfo.maxComputeWorkGroupSize + ", at most " + SystemInfo.maxComputeWorkGroupSizeX + " x " +
                   SystemInfo.maxComputeWorkGroupSizeY + " x " + SystemInfo.maxComputeWorkGroupSizeZ;
        }

        private const string StereoRemedy = "; use XR's multi-pass mode, which draws one after the other";

        /// <summary>
        /// The reason why the chain's textures cannot hold both eyes at once, which would be their slices; null if they
        /// can.
        /// </summary>
        internal static string StereoProblem(ShadowChain chain)
        {
            foreach (ChainTexture texture in chain.Slots)
                if (texture.extent == GraphExtent.Screen && texture.layers > 1)
                    return "a texture of the screen has layers, which cannot be drawn for both eyes at once" + StereoRemedy;
            return null;
        }

        /// <summary>
        /// The reason why the step cannot draw both eyes at once: raster passes are compiled for textures with two
        /// slices, kernels only if their file declares a keyword for it. Null if it can.
        /// </summary>
        internal static string StereoProblem(ShadowChain chain, ChainStep step, ProgramAsset asset)
        {
            bool ofScreen = step.reads.Concat(step.writes)
                .Any(used => chain.Slots[used.index].extent == GraphExtent.Screen);
            if (step.pass.kind != PassKind.Compute || !ofScreen || asset.Declares(ChainKeywords.BothEyes)) return null;
            return "kernel '" + step.pass.program + "' uses textures of the screen, and " + step.pass.asset +
                   " has no keyword " + ChainKeywords.BothEyes + " to do so for both eyes at once" + StereoRemedy;
        }
    }
}
