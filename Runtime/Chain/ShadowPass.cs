using UnityEngine.Rendering;
using UnityEngine.Scripting;

namespace Penumbra
{
    /// <summary>
    /// One idea of the frame: which of PenumbraShadows.shader's passes it draws, from what, into what. Every class
    /// derived from it is found and put in by its Order, so that a new one needs no change anywhere else.
    /// </summary>
    [RequireDerived]
    internal abstract class ShadowPass
    {
        /// <summary>Place in the chain. Mask 100, resolve 200, upsample 300, denoise 400.</summary>
        internal abstract int Order { get; }

        internal abstract bool IsNeeded(in ShadowOptions options);

        /// <summary>Adds its draws to the chain.</summary>
        internal abstract void AddSteps(ShadowChain chain, in ShadowOptions options);

        /// <summary>Sets the uniforms that only it reads. Must not allocate.</summary>
        internal virtual void SetUniforms(CommandBuffer commands, in ShadowFrame frame) { }
    }
}
