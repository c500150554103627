using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>The light's view of one cascade.</summary>
    internal struct CasterView
    {
        internal Matrix4x4 view;
        internal Matrix4x4 projection;

        /// <summary>The bias of URP's shadow map: depth bias, normal bias, in metres.</summary>
        internal Vector4 bias;

        /// <summary>The culled casters, valid if isCulled; otherwise nothing is drawn.</summary>
        internal CullingResults casters;
        internal bool isCulled;
    }

    /// <summary>
    /// The data with which passes draw the casters of one frame. Each recording pass has one, reused without
    /// allocating.
    /// </summary>
    internal sealed class CasterFrame
    {
        internal const int MostCascades = 4;

        internal readonly CasterView[] cascades = new CasterView[MostCascades];
        internal Camera camera;
        internal Matrix4x4 cameraView;
        internal Matrix4x4 cameraProjection;

        /// <summary>The camera's culling results.</summary>
        internal CullingResults seen;
        internal VisibleLight light;

        /// <summary>URP's shadow map; null if the pipeline does not give access to it.</summary>
        internal RTHandle shadowMap;

        private RendererList[] lists = Array.Empty<RendererList>();

        /// <summary>
        /// The index of a step's list for a cascade. A step that draws what the camera sees has one list, stored as
        /// that of cascade 0.
        /// </summary>
        internal static int IndexOf(int step, int cascade) => step * MostCascades + cascade;

        internal void MakeRoom(int steps)
        {
            if (lists.Length < steps * MostCascades) lists = new RendererList[steps * MostCascades];
        }

        internal void Set(int index, in RendererList list) => lists[index] = list;

        internal void Draw(CommandBuffer commands, int step) => commands.DrawRendererList(lists[IndexOf(step, 0)]);

        /// <summary>
        /// Draws the casters as seen from the light. Programs read URP's _ShadowBias and _LightDirection.
        /// </summary>
        internal void DrawCascade(CommandBuffer commands, int step, int cascade)
        {
            CasterView view = cascades[cascade];
            if (!view.isCulled) return;
            ShadowUtils.SetupShadowCasterConstantBuffer(commands, ref light, view.bias);
            commands.SetViewProjectionMatrices(view.view, view.projection);
            commands.DrawRendererList(lists[IndexOf(step, cascade)]);
            commands.SetViewProjectionMatrices(cameraView, cameraProjection);
        }
    }
}
