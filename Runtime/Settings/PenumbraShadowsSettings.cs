using System;
using UnityEngine;

namespace Penumbra
{
    /// <summary>What the Renderer Feature holds; a Volume (PenumbraShadowsVolume) overrides options by place.</summary>
    [Serializable]
    public sealed class PenumbraShadowsSettings
    {
        public QualityPreset preset = QualityPreset.Medium;

        /// <summary>Full angle of the light's disc in degrees, for every preset.</summary>
        [Range(0.0f, 30.0f)]
        public float angularDiameterDegrees = AngularDiameter.SunDegrees;

        /// <summary>In force when the preset is Custom.</summary>
        public ShadowOptions custom = ShadowPresets.Options(QualityPreset.Medium);

        /// <summary>Moving noise is only right where something averages frames: temporal antialiasing, an upscaler.</summary>
        public NoiseMode noise = NoiseMode.Static;

        /// <summary>Scene views of the editor too, not only game cameras.</summary>
        public bool sceneView = true;

        /// <summary>Realtime reflection probes too; six faces, seldom worth it.</summary>
        public bool reflectionProbes;

        /// <summary>In the editor and in development builds.</summary>
        public DebugView debugView;

        /// <summary>The options before any Volume.</summary>
        public ShadowOptions Options()
        {
            ShadowOptions options = preset == QualityPreset.Custom ? custom : ShadowPresets.Options(preset);
            if (preset != QualityPreset.Custom) options.angularDiameterDegrees = angularDiameterDegrees;
            options.debugView = debugView;
            return options.Clamped();
        }
    }
}
