using UnityEngine;

namespace Penumbra
{
    // Written by `penumbra validate --emit-looks` from Shaders/PenumbraShadows.technique.json; do not edit.
    /// <summary>
    /// How the light looks: the size of its disc and the widest penumbra. A look says nothing of quality, and a quality
    /// preset nothing of the look.
    /// </summary>
    public enum ShadowLook
    {
        /// <summary>The sun in clear air, 0.53 degrees wide as it is seen from the earth.</summary>
        [InspectorName("Crisp noon")]
        CrispNoon,

        /// <summary>A sun in haze: a disc of 2 degrees stands in for the glow around it.</summary>
        [InspectorName("Hazy")]
        Hazy,

        /// <summary>A sun behind thin cloud: a disc of 5 degrees stands in for the bright part of the sky.</summary>
        [InspectorName("Overcast")]
        Overcast,

        /// <summary>A low sun: a disc of 1 degree stands in for the glow that the long way through air gives it.</summary>
        [InspectorName("Sunset")]
        Sunset,

        /// <summary>Values of no look, set by hand.</summary>
        Custom,
    }

    internal static class LookTable
    {
        /// <summary>In ShadowLook's order.</summary>
        internal static readonly LookValues[] Rows =
        {
            new LookValues("Crisp noon", 0.53f, 100.0f,
                           "The sun in clear air, 0.53 degrees wide as it is seen from the earth."),
            new LookValues("Hazy", 2.0f, 100.0f,
                           "A sun in haze: a disc of 2 degrees stands in for the glow around it."),
            new LookValues("Overcast", 5.0f, 2.0f,
                           "A sun behind thin cloud: a disc of 5 degrees stands in for the bright part of the sky."),
            new LookValues("Sunset", 1.0f, 100.0f,
                           "A low sun: a disc of 1 degree stands in for the glow that the long way through air gives it."),
        };
    }
}
