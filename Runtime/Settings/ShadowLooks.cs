using System;

namespace Penumbra
{
    /// <summary>
    /// The values behind each look's name. A look is not stored: it is told by its two values, so that a slider moved
    /// afterwards, a Volume that blends and an undo need nothing of their own.
    /// </summary>
    public static class ShadowLooks
    {
        /// <summary>Custom has no values: it throws ArgumentOutOfRangeException.</summary>
        public static LookValues Values(ShadowLook look)
        {
            if (look < 0 || look >= ShadowLook.Custom)
                throw new ArgumentOutOfRangeException(nameof(look), look, "has no values: choose a look that is not Custom");
            return LookTable.Rows[(int)look];
        }

        /// <summary>The look that has exactly these values; Custom where none has.</summary>
        public static ShadowLook Of(float angularDiameterDegrees, float softnessCapMetres)
        {
            int at = Array.FindIndex(LookTable.Rows, look => look.angularDiameterDegrees == angularDiameterDegrees &&
                                                             look.softnessCapMetres == softnessCapMetres);
            return at >= 0 ? (ShadowLook)at : ShadowLook.Custom;
        }
    }
}
