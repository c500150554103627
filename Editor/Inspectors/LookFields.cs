using UnityEditor;

namespace Penumbra.Editor
{
    /// <summary>
    /// The two properties that a look sets. They are written through the serialized object, like every inspector field,
    /// so that one undo reverts both and prefabs and multiple selections work.
    /// </summary>
    internal sealed class LookFields
    {
        private readonly SerializedProperty degrees;
        private readonly SerializedProperty metres;

        internal LookFields(SerializedProperty degrees, SerializedProperty metres)
        {
            this.degrees = degrees;
            this.metres = metres;
        }

        internal ShadowLook Look
        {
            get => ShadowLooks.Of(degrees.floatValue, metres.floatValue);
            set
            {
                LookValues look = ShadowLooks.Values(value);
                degrees.floatValue = look.angularDiameterDegrees;
                metres.floatValue = look.softnessCapMetres;
            }
        }
    }

    /// <summary>The two properties of a look in a Volume, where each value has an override state.</summary>
    internal sealed class LookOverride
    {
        // These are the serialized names of VolumeParameter's value and override state.
        private const string Value = "m_Value";
        private const string Overrides = "m_OverrideState";

        private readonly LookFields values;
        private readonly SerializedProperty overridesDegrees;
        private readonly SerializedProperty overridesMetres;

        internal LookOverride(SerializedObject volume)
        {
            SerializedProperty degrees = volume.FindProperty(nameof(PenumbraShadowsVolume.angularDiameterDegrees));
            SerializedProperty metres = volume.FindProperty(nameof(PenumbraShadowsVolume.softnessCapMetres));
            values = new LookFields(degrees.FindPropertyRelative(Value), metres.FindPropertyRelative(Value));
            overridesDegrees = degrees.FindPropertyRelative(Overrides);
            overridesMetres = metres.FindPropertyRelative(Overrides);
        }

        /// <summary>
        /// The look of the overridden values; null if the Volume overrides neither value, Custom if it overrides only
        /// one.
        /// </summary>
        internal ShadowLook? Look
        {
            get
            {
                if (!overridesDegrees.boolValue && !overridesMetres.boolValue) return null;
                return overridesDegrees.boolValue && overridesMetres.boolValue ? values.Look : ShadowLook.Custom;
            }
            set
            {
                overridesDegrees.boolValue = overridesMetres.boolValue = value != null;
                if (value != null) values.Look = value.Value;
            }
        }
    }
}
