namespace Penumbra
{
    /// <summary>What a look sets, and what it stands for.</summary>
    public readonly struct LookValues
    {
        /// <summary>As inspectors and pages call it.</summary>
        public readonly string title;

        /// <summary>Full angle of the light's disc in degrees.</summary>
        public readonly float angularDiameterDegrees;

        /// <summary>Widest penumbra in metres, full width.</summary>
        public readonly float softnessCapMetres;

        /// <summary>One sentence.</summary>
        public readonly string description;

        internal LookValues(string title, float angularDiameterDegrees, float softnessCapMetres, string description)
        {
            this.title = title;
            this.angularDiameterDegrees = angularDiameterDegrees;
            this.softnessCapMetres = softnessCapMetres;
            this.description = description;
        }
    }
}
