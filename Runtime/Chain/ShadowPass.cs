using System;
using UnityEngine.Rendering;
using UnityEngine.Scripting;

namespace Penumbra
{
    /// <summary>
    /// One idea of the frame: what it draws or computes, from what, into what. Every class derived from it is found and
    /// put in by its Order. A new one that records its steps itself (Run) brings its shader along (AssetPath) and needs
    /// no change anywhere else; one that draws by a pass of Hidden/Penumbra/Shadows (Draw) adds that pass there.
    /// </summary>
    [RequireDerived]
    internal abstract class ShadowPass
    {
        /// <summary>Place in the chain. Mask 100, resolve 200, upsample 300, denoise 400.</summary>
        internal abstract int Order { get; }

        /// <summary>Of Hidden/Penumbra/Shadows, on in every draw of a chain that has this pass; null: none.</summary>
        internal virtual string Keyword => null;

        /// <summary>Path in the package of a shader or compute shader of its own, kept for players; null: none.</summary>
        internal virtual string AssetPath => null;

        /// <summary>What AssetPath names, before any chain is made; null where it is missing: it is not needed then.</summary>
        internal virtual void SetAsset(UnityEngine.Object asset) { }

        internal abstract bool IsNeeded(in ShadowOptions options);

        /// <summary>Adds its steps to the chain: Draw for a pass of the shader, Run for anything else.</summary>
        internal abstract void AddSteps(ShadowChain chain, in ShadowOptions options);

        /// <summary>Sets the uniforms that only it reads. Must not allocate.</summary>
        internal virtual void SetUniforms(CommandBuffer commands, in ShadowFrame frame) { }

        /// <summary>
        /// Records the step that AddSteps has added by Run with this number: a dispatch, or draws with a material of its
        /// own. The source and the sizes are set as for a draw; no target is bound. Must not allocate.
        /// </summary>
        internal virtual void Record(CommandBuffer commands, in ShadowFrame frame, RTHandle target, int run) =>
            throw new NotSupportedException(GetType().Name + " adds a step of its own and does not record it");
    }
}
