namespace Penumbra
{
    /// <summary>
    /// URP's soft shadow quality, by the numbers of _MainLightShadowParams.y. Off also stands for hard shadows and
    /// for an asset without soft ones.
    /// </summary>
    public enum SoftShadowKernel
    {
        Off = 0,
        Low = 1,
        Medium = 2,
        High = 3,
    }
}
