namespace Penumbra
{
    /// <summary>The values that a look sets, and the weather or light that it represents.</summary>
    public readonly struct LookValues
    {
        /// <summary>The name in inspectors and documentation.</summary>
        public readonly string title;

        /// <summary>Full angle of the light's disc in degrees.</summary>
        public readonly float angularDiameterDegrees;

        /// <summary>Widest penumbra in metres, full width.</summary>
        public readonly float softnessCapMetres;

        /// <summary>The look's description, one sentence.</summary>
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
