using UnityEngine;
using UnityEngine.Rendering;
#if UNITY_6000_0_OR_NEWER
using RasterCommands = UnityEngine.Rendering.RasterCommandBuffer;
#else
using RasterCommands = UnityEngine.Rendering.CommandBuffer;
#endif

namespace Penumbra
{
    /// <summary>
    /// URP's three keywords that select where receivers read the main light's shadow. Penumbra selects the
    /// screen-space texture from the resolve pass until transparents are drawn, which no depth texture contains.
    ///
    /// URP resets _MAIN_LIGHT_SHADOWS and _MAIN_LIGHT_SHADOWS_CASCADE before every camera, but never the screen
    /// keyword: left on, it would remove the shadows of every later camera. So the restore pass disables it, or, if
    /// that pass did not run because a camera threw an exception, it is disabled before the next camera.
    /// </summary>
    internal sealed class ShadowKeywords
    {
        internal const string MapName = "_MAIN_LIGHT_SHADOWS";
        internal const string CascadesName = "_MAIN_LIGHT_SHADOWS_CASCADE";
        internal const string ScreenName = "_MAIN_LIGHT_SHADOWS_SCREEN";

        /// <summary>Shader keywords are global, so all features share one instance.</summary>
        internal static readonly ShadowKeywords Global = new ShadowKeywords();

        private GlobalKeyword map;
        private GlobalKeyword cascades;
        private GlobalKeyword screen;
        private bool created;

        /// <summary>Whether the screen keyword is on and has not been disabled yet.</summary>
        internal bool IsOpen { get; private set; }

        internal void Open(CommandBuffer commands)
        {
            Create();
            commands.SetKeyword(map, false);
            commands.SetKeyword(cascades, false);
            commands.SetKeyword(screen, true);
            IsOpen = true;
        }

        /// <summary>
        /// Restores what URP's shadow pass has set: one of the two keywords, by the number of cascades; with an empty
        /// map, the one without cascades.
        /// </summary>
        internal void Restore(RasterCommands commands, int cascadeCount)
        {
            if (!IsOpen) return;
            commands.SetKeyword(screen, false);
            commands.SetKeyword(map, cascadeCount == 1);
            commands.SetKeyword(cascades, cascadeCount > 1);
            IsOpen = false;
        }

        /// <summary>Disables the keyword, before a camera, if the previous camera left it on. True if it did.</summary>
        internal bool Close(CommandBuffer commands)
        {
            if (!IsOpen) return false;
            commands.SetKeyword(screen, false);
            IsOpen = false;
            return true;
        }

        private void Create()
        {
            if (created) return;
            map = GlobalKeyword.Create(MapName);
            cascades = GlobalKeyword.Create(CascadesName);
            screen = GlobalKeyword.Create(ScreenName);
            created = true;
        }
    }
}
