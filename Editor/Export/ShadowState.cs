using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>
    /// The main light's shadow of a frame as URP has uploaded it: matrices to the bit, so that `penumbra constants
    /// --matrices` gives that frame's own constants.
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

        /// <summary>_MainLightWorldToShadow, one for each cascade and more.</summary>
        internal Matrix4x4[] worldToShadow;

        /// <summary>_CascadeShadowSplitSpheres0 to 3: centre, squared radius; empty with one cascade.</summary>
        internal Vector4[] splitSpheres;
    }
}
