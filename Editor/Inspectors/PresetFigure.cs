namespace Penumbra.Editor
{
    /// <summary>Error and cost of a preset under one light, measured against ray tracing.</summary>
    internal readonly struct PresetFigure
    {
        internal readonly float lightDegrees;

        /// <summary>Root mean square error of the visibility in penumbrae, 0 to 1.</summary>
        internal readonly float penumbraRmse;

        /// <summary>Texture fetches of all passes, per pixel of the screen.</summary>
        internal readonly float fetches;

        internal PresetFigure(float lightDegrees, float penumbraRmse, float fetches)
        {
            this.lightDegrees = lightDegrees;
            this.penumbraRmse = penumbraRmse;
            this.fetches = fetches;
        }
    }
}
