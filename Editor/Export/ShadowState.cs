using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>
    /// URP's main light shadow constants of a frame, with bit-exact matrices, so that `penumbra constants --matrices`
    /// computes that frame's constants.
    /// </summary>
    internal struct ShadowState
    {
        internal float angularDiameterDegrees;
        internal int resolution;
        internal int cascadeCount;
        internal bool reversedZ;
        internal float depthBias;
        internal float normalBias;
        internal string softQuality;
        internal Vector3 lightDirection;

        /// <summary>_MainLightWorldToShadow: one matrix for each cascade, and unused entries.</summary>
        internal Matrix4x4[] worldToShadow;

        /// <summary>_CascadeShadowSplitSpheres0 to 3: centre, squared radius; empty with one cascade.</summary>
        internal Vector4[] splitSpheres;
    }
}
