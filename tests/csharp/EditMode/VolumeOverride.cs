using UnityEngine.Rendering;

namespace Penumbra.Tests
{
    internal static class VolumeOverride
    {
        /// <summary>Overrides an option with the value, as an inspector does.</summary>
        internal static void Set<T>(this VolumeParameter<T> parameter, T value)
        {
            parameter.overrideState = true;
            parameter.value = value;
        }
    }
}
