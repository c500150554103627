using UnityEngine;
using UnityEngine.Rendering;
#if UNITY_6000_0_OR_NEWER
using Commands = UnityEngine.Rendering.RasterCommandBuffer;
#else
using Commands = UnityEngine.Rendering.CommandBuffer;
#endif

namespace Penumbra
{
    /// <summary>
    /// Draws a debug view into the bound target, with the uniforms and textures that this camera's chain has set.
    /// </summary>
    internal sealed class DebugViewDraw
    {
        internal const string ShaderName = "Hidden/Penumbra/DebugViews";

        private static readonly int Params = Shader.PropertyToID("_PenumbraDebugParams");

        private readonly Material material;
        private readonly int[] passes;

        internal DebugViewDraw(Material material)
        {
            this.material = material;
            string[] names = System.Enum.GetNames(typeof(DebugView));
            passes = new int[names.Length];
            for (int i = 0; i < names.Length; ++i) passes[i] = material.FindPass(names[i]);
        }

        /// <summary>
        /// Draws the view. With `overlay`, the image of the camera below remains visible where this camera has none.
        /// `upsideDown` says that the target's rows run in the opposite direction to those of the chain's textures.
        /// </summary>
        internal void Draw(Commands commands, DebugView view, bool hasMask, bool overlay, bool upsideDown)
        {
            commands.SetGlobalVector(Params, new Vector4(hasMask ? 1.0f : 0.0f, overlay ? 1.0f : 0.0f,
                                                         upsideDown ? 1.0f : 0.0f, 0.0f));
            commands.DrawProcedural(Matrix4x4.identity, material, passes[(int)view], MeshTopology.Triangles, 3, 1, null);
        }
    }
}
