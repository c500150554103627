using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>A uniform of a technique: each component is a number, or follows an option.</summary>
    internal sealed class ParameterVector
    {
        private readonly int uniform;
        private readonly ParameterComponent x, y, z, w;

        internal ParameterVector(string name, ParameterComponent x, ParameterComponent y, ParameterComponent z,
                                 ParameterComponent w)
        {
            uniform = Shader.PropertyToID(name);
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }

        /// <summary>Does not allocate.</summary>
        internal void SetGlobal(CommandBuffer commands, in ShadowOptions options) =>
            commands.SetGlobalVector(uniform, new Vector4(x.In(options), y.In(options), z.In(options), w.In(options)));
    }

    /// <summary>A number; or the value of an option, clamped to the range of the parameter that it sets.</summary>
    internal readonly struct ParameterComponent
    {
        private readonly bool isOption;
        private readonly NumberOption option;
        private readonly float low;
        private readonly float high;

        internal ParameterComponent(float number)
        {
            isOption = false;
            option = default;
            low = high = number;
        }

        internal ParameterComponent(NumberOption option, float low, float high)
        {
            isOption = true;
            this.option = option;
            this.low = low;
            this.high = high;
        }

        internal float In(in ShadowOptions options) =>
            isOption ? Bounded.OrLow(OptionTable.Get(options, option), low, high) : low;
    }
}
