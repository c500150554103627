using System.Collections.Generic;
using UnityEditor;
using UnityEditor.Rendering;
using UnityEngine;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Editor
{
    /// <summary>Shows the preset with its options and figures, then the single options that have an effect.</summary>
    [CustomEditor(typeof(PenumbraShadowsVolume))]
    internal sealed class PenumbraShadowsVolumeEditor : VolumeComponentEditor
    {
        private readonly Dictionary<OptionField, SerializedDataParameter> options =
            new Dictionary<OptionField, SerializedDataParameter>();

        private SerializedDataParameter preset;
        private SerializedDataParameter cascadeBlend;
        private SerializedDataParameter contactShadows;
        private SerializedDataParameter contactShadowSteps;
        private SerializedDataParameter debugView;
        private LookOverride look;

        // Searching for assets is too slow for every repaint; the found assets' values are read at each repaint.
        private List<ScriptableRendererData> renderers;

        /// <inheritdoc/>
        public override void OnEnable()
        {
            preset = Unpack(serializedObject.FindProperty(nameof(PenumbraShadowsVolume.preset)));
            foreach (OptionField option in OptionFields.All)
                if (option.IsInVolume) options[option] = Unpack(serializedObject.FindProperty(option.name));
            cascadeBlend = Unpack(serializedObject.FindProperty(OptionFields.CascadeBlend.name));
            contactShadows = Unpack(serializedObject.FindProperty(OptionFields.ContactShadows.name));
            contactShadowSteps = Unpack(serializedObject.FindProperty(OptionFields.ContactShadowSteps.name));
            debugView = Unpack(serializedObject.FindProperty(OptionFields.DebugView.name));
            look = new LookOverride(serializedObject);
            renderers = null;
        }

        /// <summary>The name of the menu, where Unity would make one of the class's name.</summary>
        public override GUIContent GetDisplayTitle() => new GUIContent(PenumbraShadows.Title, "");

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            VolumeState state = State();
            PropertyField(preset, OptionFields.Preset);
            string figures = VolumeAdvice.Preset(state);
            if (figures != null) EditorGUILayout.HelpBox(figures, MessageType.None);
            ShowLook();
            foreach (OptionField option in OptionFields.All)
                if (VolumeAdvice.Shows(option, state.volume)) PropertyField(options[option], option.label);
            PropertyField(cascadeBlend, OptionFields.CascadeBlend.label);
            PropertyField(contactShadows, OptionFields.ContactShadows.label);
            PropertyField(contactShadowSteps, OptionFields.ContactShadowSteps.label);
            PropertyField(debugView, OptionFields.DebugView.label);
            AdviceBox.Show(VolumeAdvice.For(state));
        }

        // The first entry does not override the look.
        private void ShowLook()
        {
            int now = look.Look == null ? 0 : (int)look.Look + 1;
            int chosen = EditorGUILayout.Popup(LookText.Label, now, LookText.NamesInVolume);
            if (chosen == now || chosen == (int)ShadowLook.Custom + 1) return;
            look.Look = chosen == 0 ? (ShadowLook?)null : (ShadowLook)(chosen - 1);
        }

        private VolumeState State()
        {
            renderers = renderers ?? FeaturesInProject.Renderers();
            renderers.RemoveAll(renderer => renderer == null);  // these were deleted since
            VolumeState state = default;
            state.volume = (PenumbraShadowsVolume)target;
            state.features = new List<PenumbraShadowsSettings>(FeaturesInProject.Settings(renderers));
#if UNITY_6000_0_OR_NEWER
            state.defaultProfile = !enableOverrides;
#endif
            return state;
        }
    }
}
