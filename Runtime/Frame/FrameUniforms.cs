using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>
    /// Sets the uniforms of ShaderLibrary/Shadows.hlsl and Shaders/PenumbraShadows.shader. They are global, so that
    /// forward shaders of the project's own that include Shadows.hlsl find them too.
    /// </summary>
    internal sealed class FrameUniforms
    {
        internal static readonly int AtlasTexelSize = Shader.PropertyToID("_PenumbraMainLightAtlasTexelSize");
        internal static readonly int MainLightParams = Shader.PropertyToID("_PenumbraMainLightParams");
        internal static readonly int ScreenToWorldMatrices = Shader.PropertyToID("_PenumbraScreenToWorld");
        internal static readonly int ToPreviousScreenMatrices = Shader.PropertyToID("_PenumbraToPreviousScreen");
        internal static readonly int ScreenSize = Shader.PropertyToID("_PenumbraScreenSize");
        internal static readonly int TargetSize = Shader.PropertyToID("_PenumbraTargetSize");
        internal static readonly int Mip = Shader.PropertyToID("_PenumbraMip");
        internal static readonly int Cascade = Shader.PropertyToID("_PenumbraCascade");
        internal static readonly int Tile = Shader.PropertyToID("_PenumbraTile");
        internal static readonly int ScreenSpaceShadowmap = Shader.PropertyToID(ShadowChain.OutputName);

        private readonly Matrix4x4[] screenToWorld = new Matrix4x4[ShadowFrame.MostViews];
        private readonly Matrix4x4[] toPreviousScreen = new Matrix4x4[ShadowFrame.MostViews];

        internal void Set(CommandBuffer commands, in ShadowFrame frame)
        {
            commands.SetGlobalVector(AtlasTexelSize, frame.uniforms.MainLightAtlasTexelSize);
            commands.SetGlobalVector(MainLightParams, frame.uniforms.MainLightParams);
            frame.uniforms.PcssAngular.SetGlobal(commands);
            frame.uniforms.PcssClassic.SetGlobal(commands);
            frame.uniforms.PcssHdrp.SetGlobal(commands);
            SetParameters(commands, frame.options);
            SetCascades(commands, frame.options.technique.Entry().cascades, frame.uniforms);
            SetMask(commands, frame);
            DenoiseParameters.Default.SetGlobal(commands);
            frame.options.ContactShadows().SetGlobal(commands);
            frame.far.Set(commands, frame.options);
            commands.SetGlobalVector(ScreenSize, TextureSize.Drawn(ChainTexture.OfScreen(1), frame).Uniform);
            screenToWorld[0] = frame.screenToWorld0;
            screenToWorld[1] = frame.screenToWorld1;
            commands.SetGlobalMatrixArray(ScreenToWorldMatrices, screenToWorld);
            toPreviousScreen[0] = frame.toPreviousScreen0;
            toPreviousScreen[1] = frame.toPreviousScreen1;
            commands.SetGlobalMatrixArray(ToPreviousScreenMatrices, toPreviousScreen);
        }

        /// <summary>
        /// Makes the noise static for what is drawn after the chain: nothing averages the frames of forward shaders that
        /// filter themselves.
        /// </summary>
        internal static void StopNoise(CommandBuffer commands, in ShadowFrame frame)
        {
            if (!frame.options.Accumulates) return;
            Vector4 parameters = frame.uniforms.MainLightParams;
            parameters.z = 0.0f;
            commands.SetGlobalVector(MainLightParams, parameters);
        }

        // Forward shaders may use any filter that needs no passes; where two share a struct, the technique's is last.
        private static void SetParameters(CommandBuffer commands, in ShadowOptions options)
        {
            IReadOnlyList<TechniqueEntry> entries = TechniqueTable.Entries;
            for (int i = 0; i < entries.Count; ++i)
                if (entries[i].formats[0].graph == null) Set(commands, entries[i].formats[0].parameters, options);
            Set(commands, options.Format.parameters, options);
        }

        private static void Set(CommandBuffer commands, ParameterVector[] parameters, in ShadowOptions options)
        {
            for (int i = 0; i < parameters.Length; ++i) parameters[i].SetGlobal(commands, options);
        }

        private static void SetCascades(CommandBuffer commands, CascadeVector[] vectors, in ShadowUniforms uniforms)
        {
            for (int i = 0; i < vectors.Length; ++i)
                commands.SetGlobalVector(vectors[i].Uniform, vectors[i].In(uniforms));
        }

        // The mask must cover the penumbrae that the filter draws.
        private static void SetMask(CommandBuffer commands, in ShadowFrame frame)
        {
            MaskParameters parameters = MaskParameters.Default;
            parameters.maskPenumbraMetres = frame.uniforms.PcssAngular.maxPenumbraMetres;
            parameters.SetGlobal(commands);
        }
    }
}
