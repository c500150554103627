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
        internal static readonly int ScreenSize = Shader.PropertyToID("_PenumbraScreenSize");
        internal static readonly int TargetSize = Shader.PropertyToID("_PenumbraTargetSize");
        internal static readonly int SourceSize = Shader.PropertyToID("_PenumbraSourceSize");
        internal static readonly int SourceTexture = Shader.PropertyToID("_PenumbraSourceTexture");
        internal static readonly int ScreenSpaceShadowmap = Shader.PropertyToID("_ScreenSpaceShadowmapTexture");

        private readonly Matrix4x4[] screenToWorld = new Matrix4x4[ShadowFrame.MostViews];

        internal void Set(CommandBuffer commands, in ShadowFrame frame)
        {
            commands.SetGlobalVector(AtlasTexelSize, frame.uniforms.MainLightAtlasTexelSize);
            commands.SetGlobalVector(MainLightParams, frame.uniforms.MainLightParams);
            frame.uniforms.PcssAngular.SetGlobal(commands);
            frame.uniforms.PcssClassic.SetGlobal(commands);
            frame.uniforms.PcssHdrp.SetGlobal(commands);
            commands.SetGlobalVector(ScreenSize, Size(frame, ChainTexture.OfScreen(1)));
            screenToWorld[0] = frame.screenToWorld0;
            screenToWorld[1] = frame.screenToWorld1;
            commands.SetGlobalMatrixArray(ScreenToWorldMatrices, screenToWorld);
        }

        /// <summary>Width, height and their inverses of what is drawn of a texture.</summary>
        internal static Vector4 Size(in ShadowFrame frame, in ChainTexture texture)
        {
            bool ofScreen = texture.extent == ChainExtent.Screen;
            float width = ofScreen ? Mathf.Ceil(texture.Size(frame.width) * frame.widthScale)
                                   : texture.Size(frame.MapWidth);
            float height = ofScreen ? Mathf.Ceil(texture.Size(frame.height) * frame.heightScale)
                                    : texture.Size(frame.MapHeight);
            return new Vector4(width, height, 1.0f / width, 1.0f / height);
        }
    }
}
