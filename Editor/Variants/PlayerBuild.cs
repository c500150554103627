using UnityEditor;
using UnityEditor.Build;
using UnityEditor.Build.Reporting;

namespace Penumbra.Editor
{
    /// <summary>
    /// The options of the player being built, which a script may set independently of the build window. The class also
    /// makes every feature find its shaders, since on a build machine no view does.
    /// </summary>
    internal sealed class PlayerBuild : IPreprocessBuildWithReport, IPostprocessBuildWithReport
    {
        private static bool? development;

        /// <summary>
        /// Whether the player is a development build. Outside a player's build, as for asset bundles, it is the build
        /// window's setting.
        /// </summary>
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
