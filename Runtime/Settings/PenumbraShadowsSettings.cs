using System;
using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// The settings of the Renderer Feature; a Volume (PenumbraShadowsVolume) overrides options by place.
    /// </summary>
    [Serializable]
    public sealed class PenumbraShadowsSettings
    {
        [Tooltip(OptionTable.Quality.Tooltip)]
        public QualityPreset preset = QualityPreset.Medium;

        /// <summary>Full angle of the light's disc in degrees, for every preset but Custom.</summary>
        [Tooltip(OptionTable.AngularDiameterDegrees.Tooltip)]
        [Range(0.0f, 30.0f)]
        public float angularDiameterDegrees = AngularDiameter.SunDegrees;

        /// <summary>Widest penumbra in metres, for every preset but Custom.</summary>
        [Tooltip(OptionTable.SoftnessCapMetres.Tooltip)]
        [Range(0.0f, 100.0f)]
        public float softnessCapMetres = 100.0f;

        [Tooltip("Every option; used if Quality is Custom.")]
        public ShadowOptions custom = ShadowPresets.Options(QualityPreset.Medium);

        /// <summary>
        /// The noise of the samples. Per-frame noise is only right where something averages frames: temporal
        /// antialiasing, an upscaler, or with Accumulated the feature itself.
        /// </summary>
        [Tooltip("Static: the noise of the samples stays the same. Per Frame: a new pattern every frame, for temporal " +
                 "antialiasing or an upscaler to average; without one, penumbrae flicker. Accumulated: a new pattern " +
                 "every frame, averaged by a pass of its own: steadier in motion, for a texture of 4 bytes per pixel.")]
        public NoiseMode noise = NoiseMode.Static;

        [Tooltip("Draws these shadows in Scene views of the editor too, not only in game cameras.")]
        public bool sceneView = true;

        [Tooltip("Draws these shadows in realtime reflection probes too: six images each, seldom worth the cost.")]
        public bool reflectionProbes;

        /// <summary>Border in which a cascade is dithered with the next, for every preset.</summary>
        [Tooltip(OptionTable.CascadeBlend.Tooltip)]
        [Range(OptionTable.CascadeBlend.Min, OptionTable.CascadeBlend.Max)]
        public float cascadeBlend;

        /// <summary>Length of the rays of contact shadows, for every preset; at 0 there are none.</summary>
        [Tooltip(OptionTable.ContactShadowMetres.Tooltip)]
        [Range(OptionTable.ContactShadowMetres.Min, OptionTable.ContactShadowMetres.Max)]
        public float contactShadowMetres;

        /// <summary>Samples along each ray of contact shadows.</summary>
        [Tooltip(OptionTable.ContactShadowSteps.Tooltip)]
        [Range(OptionTable.ContactShadowSteps.Min, OptionTable.ContactShadowSteps.Max)]
        public int contactShadowSteps = ScreenTraceParameters.Default.traceSteps;

        /// <summary>Shadows beyond the cascades and of clouds, for every preset.</summary>
        [Tooltip("Shadows of the ground beyond the shadow distance, and of clouds.")]
        public FarShadowsSettings farShadows = new FarShadowsSettings();

        [Tooltip(OptionTable.DebugView.Tooltip)]
        public DebugView debugView;

        /// <summary>
        /// The look whose values the current options have; Custom if none does. Setting it sets its two values;
        /// setting Custom throws ArgumentOutOfRangeException, as Custom has no values.
        /// </summary>
        public ShadowLook Look
        {
            get => preset == QualityPreset.Custom
                       ? ShadowLooks.Of(custom.angularDiameterDegrees, custom.softnessCapMetres)
                       : ShadowLooks.Of(angularDiameterDegrees, softnessCapMetres);
            set
            {
                LookValues look = ShadowLooks.Values(value);
                if (preset == QualityPreset.Custom)
                {
                    custom.angularDiameterDegrees = look.angularDiameterDegrees;
                    custom.softnessCapMetres = look.softnessCapMetres;
                }
                else
                {
                    angularDiameterDegrees = look.angularDiameterDegrees;
                    softnessCapMetres = look.softnessCapMetres;
                }
            }
        }

        /// <summary>The options before Volumes override them.</summary>
        public ShadowOptions Options()
        {
            ShadowOptions options = preset == QualityPreset.Custom
                                        ? custom
                                        : ShadowPresets.Options(preset).Under(angularDiameterDegrees, softnessCapMetres);
            options.cascadeBlend = cascadeBlend;
            options.contactShadowMetres = contactShadowMetres;
            options.contactShadowSteps = contactShadowSteps;
            options.farShadows = farShadows.mode;
            options.clouds = farShadows.clouds;
            options.debugView = debugView;
            options.accumulates = noise == NoiseMode.Accumulated;
            return options.Clamped();
        }
    }
}
