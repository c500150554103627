using System;
using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// Shadows beyond the cascades: of the ground (FarShadowGround), and of clouds. They hold for every quality preset.
    /// </summary>
    [Serializable]
    public sealed class FarShadowsSettings
    {
        [Tooltip(OptionTable.FarShadows.Tooltip)]
        public FarShadowMode mode;

        [Tooltip("Where far shadows take over from the cascades, and how the height map is searched.")]
        public FarShadowsParameters parameters = FarShadowsParameters.Default;

        [Tooltip(OptionTable.Clouds.Tooltip)]
        public bool clouds;

        [Tooltip("The layer of clouds.")]
        public CloudParameters cloudLayer = CloudParameters.Default;

        /// <summary>The clouds' speed along world x and z, metres per second.</summary>
        [Tooltip("Wind in metres per second, along world x and z, that moves the clouds. They follow the game's time " +
                 "(Time.time), and stand still in edit mode.")]
        public Vector2 windMetresPerSecond = new Vector2(8.0f, 0.0f);
    }
}
