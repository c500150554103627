using UnityEditor;
using UnityEditor.Build;
using UnityEditor.Build.Reporting;

namespace Penumbra.Editor
{
    /// <summary>
    /// What is known of the player being built: its own options, which a script may give, not the build window's. Also
    /// has every feature find its shaders: on a machine that builds and draws nothing, nobody else asks them to.
    /// </summary>
    internal sealed class PlayerBuild : IPreprocessBuildWithReport, IPostprocessBuildWithReport
    {
        private static bool? development;

        /// <summary>Outside of a player's build, as for asset bundles, what the build window says.</summary>
        internal static bool IsDevelopment => development ?? EditorUserBuildSettings.development;

        public int callbackOrder => 0;

        public void OnPreprocessBuild(BuildReport report)
        {
            Begin(report.summary.options);
            foreach (PenumbraShadows feature in FeaturesInProject.Features()) feature.FindShaders();
        }

        public void OnPostprocessBuild(BuildReport report) => End();

        internal static void Begin(BuildOptions options) => development = (options & BuildOptions.Development) != 0;
        internal static void End() => development = null;
    }
}
