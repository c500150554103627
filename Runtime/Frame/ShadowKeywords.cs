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
    /// URP's three keywords that say where receivers find the main light's shadow. Ours is the screen-space texture
    /// from the resolve on until transparents, which are in no depth texture, are drawn.
    ///
    /// URP resets _MAIN_LIGHT_SHADOWS and _MAIN_LIGHT_SHADOWS_CASCADE before every camera, the screen keyword never: one
    /// that is left on would take the shadows from every camera after it. So it is switched off by the restore pass, and
    /// where that did not come to run (a camera threw), before the next camera.
    /// </summary>
    internal sealed class ShadowKeywords
    {
        internal const string MapName = "_MAIN_LIGHT_SHADOWS";
        internal const string CascadesName = "_MAIN_LIGHT_SHADOWS_CASCADE";
        internal const string ScreenName = "_MAIN_LIGHT_SHADOWS_SCREEN";

        /// <summary>Keywords are the process's, whoever switches them.</summary>
        internal static readonly ShadowKeywords Global = new ShadowKeywords();

        private GlobalKeyword map;
        private GlobalKeyword cascades;
        private GlobalKeyword screen;
        private bool created;

        /// <summary>The screen keyword has been switched on and not off again.</summary>
        internal bool IsOpen { get; private set; }

        internal void Open(CommandBuffer commands)
        {
            Create();
            commands.SetKeyword(map, false);
            commands.SetKeyword(cascades, false);
            commands.SetKeyword(screen, true);
            IsOpen = true;
        }

        /// <summary>As URP's shadow pass has left them; it uses one of the two for as many cascades.</summary>
        internal void Restore(RasterCommands commands, int cascadeCount)
        {
            if (!IsOpen) return;
            commands.SetKeyword(screen, false);
            commands.SetKeyword(map, cascadeCount == 1);
            commands.SetKeyword(cascades, cascadeCount > 1);
            IsOpen = false;
        }

        /// <summary>Before a camera: what the one before it has left open. True when there was something.</summary>
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
