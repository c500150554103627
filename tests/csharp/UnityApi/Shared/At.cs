namespace Penumbra.UnityApi
{
    /// <summary>The versions our declarations were read at.</summary>
    public static class At
    {
        public const string Unity2022 = "2022.3.17f1";
        public const string Core14 = "14.0.9";
        public const string Universal14 = "14.0.9";

        public const string Unity6 = "6000.0.23f1";
        public const string Core17 = "17.0.3";
        public const string Universal17 = "17.0.3";

        public const string Unity65 = "6000.5.2f1";
        public const string Core175 = "17.5.0";
        public const string Universal175 = "17.5.0";
    }
}
