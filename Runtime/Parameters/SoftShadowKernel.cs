namespace Penumbra
{
    /// <summary>
    /// URP's soft shadow quality, with the values of _MainLightShadowParams.y. Off is also used for hard shadows and
    /// for an asset without soft shadows.
    /// </summary>
    public enum SoftShadowKernel { Off = 0, Low = 1, Medium = 2, High = 3 }
}
