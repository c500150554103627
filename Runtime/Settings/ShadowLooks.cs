using System;

namespace Penumbra
{
    /// <summary>
    /// The values of each look. A look is not stored but recognised by its two values, so that sliders moved later,
    /// blended Volumes and undo need no special handling.
    /// </summary>
    public static class ShadowLooks
    {
        /// <summary>The look's values. Throws ArgumentOutOfRangeException for Custom, which has none.</summary>
        public static LookValues Values(ShadowLook look)
        {
            if (look < 0 || look >= ShadowLook.Custom)
                throw new ArgumentOutOfRangeException(nameof(look), look, "Custom has no values; choose another look");
            return LookTable.Rows[(int)look];
        }

        /// <summary>The look that has exactly these values; Custom if none does.</summary>
        public static ShadowLook Of(float angularDiameterDegrees, float softnessCapMetres)
        {
            int at = Array.FindIndex(LookTable.Rows, look => look.angularDiameterDegrees == angularDiameterDegrees &&
                                                             look.softnessCapMetres == softnessCapMetres);
            return at >= 0 ? (ShadowLook)at : ShadowLook.Custom;
        }
    }
}
