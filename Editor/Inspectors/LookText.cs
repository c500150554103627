using System.Globalization;
using System.Linq;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>The looks as inspectors list them, and what is said under the list.</summary>
    internal static class LookText
    {
        internal static readonly GUIContent Label = new GUIContent(OptionTable.Look.Label, OptionTable.Look.Tooltip);

        /// <summary>In ShadowLook's order, Custom included.</summary>
        internal static readonly string[] Names = LookTable.Rows.Select(look => look.title).Append("Custom").ToArray();

        /// <summary>Those, behind a first entry for a Volume that leaves the look to the feature.</summary>
        internal static readonly string[] NamesInVolume = Names.Prepend("As the feature").ToArray();

        /// <summary>"The sun in clear air, ...": the look's sentence, and the cap where it has one; null for Custom.</summary>
        internal static string Describe(ShadowLook look)
        {
            if (look == ShadowLook.Custom) return null;
            LookValues values = ShadowLooks.Values(look);
            if (!Caps(values.softnessCapMetres)) return values.description;
            return values.description + string.Format(CultureInfo.InvariantCulture, " Penumbrae are at most {0:0.##} m wide.",
                                                      values.softnessCapMetres);
        }

        /// <summary>What a cap does to a preset's figures; null without one.</summary>
        internal static string OfFigures(float softnessCapMetres) =>
            Caps(softnessCapMetres) ? "The figures are of penumbrae without a softness cap." : null;

        // The widest that the option allows: the presets are measured with it.
        private static bool Caps(float metres) => metres < 100.0f;
    }
}
