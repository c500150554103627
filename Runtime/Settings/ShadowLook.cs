using UnityEngine;

namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraShadows.technique.json; do not edit.
    /// <summary>
    /// The appearance of the light: the size of its disc and the widest penumbra. Looks do not affect quality, and
    /// quality presets do not affect the look.
    /// </summary>
    public enum ShadowLook
    {
        /// <summary>The sun in clear air, 0.53 degrees wide as seen from Earth.</summary>
        [InspectorName("Crisp noon")] CrispNoon,

        /// <summary>The sun in haze: a disc of 2 degrees approximates the glow around it.</summary>
        [InspectorName("Hazy")] Hazy,

        /// <summary>The sun behind thin cloud: a disc of 5 degrees approximates the bright part of the sky.</summary>
        [InspectorName("Overcast")] Overcast,

        /// <summary>A low sun: a disc of 1 degree approximates the glow from its long path through the air.</summary>
        [InspectorName("Sunset")] Sunset,

        /// <summary>Other values, set by hand.</summary>
        Custom,
    }

    internal static class LookTable
    {
        /// <summary>In ShadowLook's order.</summary>
        internal static readonly LookValues[] Rows =
        {
            new LookValues("Crisp noon", 0.53f, 100.0f,
                           "The sun in clear air, 0.53 degrees wide as seen from Earth."),
            new LookValues("Hazy", 2.0f, 100.0f,
                           "The sun in haze: a disc of 2 degrees approximates the glow around it."),
            new LookValues("Overcast", 5.0f, 2.0f,
                           "The sun behind thin cloud: a disc of 5 degrees approximates the bright part of the sky."),
            new LookValues("Sunset", 1.0f, 100.0f,
                           "A low sun: a disc of 1 degree approximates the glow from its long path through the air."),
        };
    }
}
