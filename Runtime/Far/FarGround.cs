using UnityEngine;

namespace Penumbra
{
    /// <summary>The ground as shaders know it: its place, and the textures of one mode.</summary>
    internal struct FarGround
    {
        /// <summary>Corner and size, world x and z in metres.</summary>
        internal Vector4 area;

        /// <summary>
        /// The metres that stored 0 and 1 mean, and the number of samples of the heights along x and z.
        /// </summary>
        internal Vector4 heights;

        /// <summary>The factors of the heights' red and green, which are multiplied before they are added.</summary>
        internal Vector4 channels;

        internal Texture heightMap;
        internal Texture horizonFirst;
        internal Texture horizonSecond;
    }
}
