using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// A vector parameter that a technique's filter uses from a certain cascade on, by a rule in its manifest: a copy
    /// of another uniform of the frame in which the rule replaces some components.
    /// </summary>
    internal readonly struct CascadeVector
    {
        private readonly int uniform;
        private readonly int baseUniform;
        private readonly int own;
        private readonly Vector4 value;

        /// <param name="baseName">The uniform that is copied; null if the rule sets all components.</param>
        /// <param name="own">Bit mask of the components that the rule sets; bit 0 is x.</param>
        internal CascadeVector(string name, string baseName, int own, float x, float y, float z, float w)
        {
            uniform = Shader.PropertyToID(name);
            baseUniform = baseName == null ? 0 : Shader.PropertyToID(baseName);
            this.own = baseName == null ? AllComponents : own;
            value = new Vector4(x, y, z, w);
        }

        private const int AllComponents = 0b1111;

        internal int Uniform => uniform;

        /// <summary>
        /// The vector with the frame's uniforms; for a base uniform that they do not contain, the manifest's values.
        /// </summary>
        internal Vector4 In(in ShadowUniforms uniforms)
        {
            if (own == AllComponents || !uniforms.TryGet(baseUniform, out Vector4 vector)) return value;
            return new Vector4(Component(0, value.x, vector.x), Component(1, value.y, vector.y),
                               Component(2, value.z, vector.z), Component(3, value.w, vector.w));
        }

        private float Component(int index, float ofRule, float ofFrame) => (own >> index & 1) != 0 ? ofRule : ofFrame;
    }
}
