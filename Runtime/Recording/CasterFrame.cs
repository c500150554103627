using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Penumbra
{
    /// <summary>What the light sees in one cascade.</summary>
    internal struct CasterView
    {
        internal Matrix4x4 view;
        internal Matrix4x4 projection;

        /// <summary>As URP's shadow map has it: depth, normal, in metres.</summary>
        internal Vector4 bias;

        /// <summary>Culled for it; without it nothing is drawn.</summary>
        internal CullingResults casters;
        internal bool isCulled;
    }

    /// <summary>What passes draw the casters of one frame with. One for each recorder: nothing is allocated.</summary>
    internal sealed class CasterFrame
    {
        internal const int MostCascades = 4;

        internal readonly CasterView[] cascades = new CasterView[MostCascades];
        internal Camera camera;
        internal Matrix4x4 cameraView;
        internal Matrix4x4 cameraProjection;

        /// <summary>By the camera.</summary>
        internal CullingResults seen;
        internal VisibleLight light;

        /// <summary>Null where the pipeline does not hand it out.</summary>
        internal RTHandle shadowMap;

        private RendererList[] lists = Array.Empty<RendererList>();

        /// <summary>Of a step that draws what the camera sees the one list is that of cascade 0.</summary>
        internal static int IndexOf(int step, int cascade) => step * MostCascades + cascade;

        internal void MakeRoom(int steps)
        {
            if (lists.Length < steps * MostCascades) lists = new RendererList[steps * MostCascades];
        }

        internal void Set(int index, in RendererList list) => lists[index] = list;

        internal void Draw(CommandBuffer commands, int step) => commands.DrawRendererList(lists[IndexOf(step, 0)]);

        /// <summary>As the light sees them. Programs find URP's _ShadowBias and _LightDirection.</summary>
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
