using System.Globalization;
using System.Linq;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>The looks' names in inspectors, and the text shown below them.</summary>
    internal static class LookText
    {
        internal static readonly GUIContent Label = new GUIContent(OptionTable.Look.Label, OptionTable.Look.Tooltip);

        /// <summary>The names in ShadowLook's order, Custom included.</summary>
        internal static readonly string[] Names = LookTable.Rows.Select(look => look.title).Append("Custom").ToArray();

        /// <summary>The names with a first entry for a Volume that does not override the look.</summary>
        internal static readonly string[] NamesInVolume = Names.Prepend("As the feature").ToArray();

        /// <summary>
        /// "The sun in clear air, ...": the look's description, and its softness cap if it has one; null for Custom.
        /// </summary>
        internal static string Describe(ShadowLook look)
        {
            if (look == ShadowLook.Custom) return null;
            LookValues values = ShadowLooks.Values(look);
            if (!Caps(values.softnessCapMetres)) return values.description;
            return values.description + string.Format(CultureInfo.InvariantCulture, " Penumbrae are at most {0:0.##} m wide.",
                                                      values.softnessCapMetres);
        }

        /// <summary>The note on a preset's figures if there is a softness cap; otherwise null.</summary>
        internal static string OfFigures(float softnessCapMetres) =>
            Caps(softnessCapMetres) ? "The figures were measured without a softness cap." : null;

        // The option's largest value, with which the presets are measured, counts as no cap.
        private static bool Caps(float metres) => metres < 100.0f;
    }
}
