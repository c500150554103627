using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// A vector that a technique's filter is told from a cascade on, by a rule of its manifest: what another uniform of the
    /// frame holds, but for the components that are the rule's own.
    /// </summary>
    internal readonly struct CascadeVector
    {
        private readonly int uniform;
        private readonly int baseUniform;
        private readonly int own;
        private readonly Vector4 value;

        /// <param name="baseName">Null: all components are the rule's own.</param>
        /// <param name="own">Bits of those that are, from x on.</param>
        internal CascadeVector(string name, string baseName, int own, float x, float y, float z, float w)
        {
            uniform = Shader.PropertyToID(name);
            baseUniform = baseName == null ? 0 : Shader.PropertyToID(baseName);
            this.own = baseName == null ? AllComponents : own;
            value = new Vector4(x, y, z, w);
        }

        private const int AllComponents = 0b1111;

        internal int Uniform => uniform;

        /// <summary>In a frame of these; what they do not have is as the technique is listed.</summary>
        internal Vector4 In(in ShadowUniforms uniforms)
        {
            if (own == AllComponents || !uniforms.TryGet(baseUniform, out Vector4 vector)) return value;
            return new Vector4(Component(0, value.x, vector.x), Component(1, value.y, vector.y),
                               Component(2, value.z, vector.z), Component(3, value.w, vector.w));
        }

        private float Component(int index, float ofRule, float ofFrame) => (own >> index & 1) != 0 ? ofRule : ofFrame;
    }
}
