using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    /// <summary>
    /// Reads how a Terrain stores its heights. 32766 of 65535 is the full height (Unity's
    /// PaintContext.kNormalizedHeightScale), in one channel of 16 bits or, with Vulkan and OpenGL ES, in two of 8, of
    /// which red has the low byte and green the high one (UnpackHeightmap of Unity's TerrainEngine.cginc and URP's
    /// terrain shaders). Both are linear, so that filtered texels are filtered heights. The first and last samples lie
    /// on the terrain's edges. A Terrain has no rotation.
    /// </summary>
    internal static class TerrainHeights
    {
        private const float FullHeight = 32766.0f / 65535.0f;

        internal static bool TryGet(Terrain terrain, ref FarGround ground)
        {
            TerrainData data = terrain.terrainData;
            if (data == null) return false;
            Vector3 corner = terrain.GetPosition();
            Vector3 size = data.size;
            ground.area = new Vector4(corner.x, corner.z, size.x, size.z);
            ground.heights = new Vector4(corner.y, corner.y + size.y, data.heightmapResolution, data.heightmapResolution);
            RenderTexture heights = data.heightmapTexture;
            ground.heightMap = heights;
            ground.channels = Channels(heights);
            return heights != null;
        }

        private static Vector4 Channels(RenderTexture heights)
        {
            if (heights == null || heights.graphicsFormat != GraphicsFormat.R8G8_UNorm)
                return new Vector4(1.0f / FullHeight, 0.0f, 0.0f, 0.0f);
            const float low = 1.0f / 257.0f;
            return new Vector4(low / FullHeight, 256.0f * low / FullHeight, 0.0f, 0.0f);
        }
    }
}
