using UnityEngine;

namespace Penumbra
{
    /// <summary>What shaders are told of the ground: its place, and the textures of one mode.</summary>
    internal struct FarGround
    {
        /// <summary>Corner and size, world x and z in metres.</summary>
        internal Vector4 area;

        /// <summary>Metres of a stored 0 and of 1, and of heights the samples along x and z.</summary>
        internal Vector4 heights;

        /// <summary>What the red and green of heights are multiplied with before they are added.</summary>
        internal Vector4 channels;

        internal Texture heightMap;
        internal Texture horizonFirst;
        internal Texture horizonSecond;
    }
}
