using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Samples.CustomPipeline
{
    /// <summary>
    /// Sets the uniforms of Shaders/SunShadow.hlsl, which have the same names: the inputs of ShadowTile and
    /// PcssAngularParameters, computed by Runtime/Parameters. Arrays have the shader's length, whatever the count,
    /// because Unity fixes an array's length when it is first set.
    /// </summary>
    internal sealed class SunUniforms
    {
        private static readonly int worldToShadow = Shader.PropertyToID("_SunWorldToShadow");
        private static readonly int spheres = Shader.PropertyToID("_SunSpheres");
        private static readonly int tiles = Shader.PropertyToID("_SunTiles");
        private static readonly int scales = Shader.PropertyToID("_SunScales");
        private static readonly int atlasTexelSize = Shader.PropertyToID("_SunAtlasTexelSize");
        private static readonly int cascadeCount = Shader.PropertyToID("_SunCascades");
        private static readonly int casterBias = Shader.PropertyToID("_SunCasterBias");

        private readonly Matrix4x4[] matrixArray = new Matrix4x4[AtlasLayout.MostCascades];
        private readonly Vector4[] sphereArray = new Vector4[AtlasLayout.MostCascades];
        private readonly Vector4[] tileArray = new Vector4[AtlasLayout.MostCascades];
        private readonly Vector4[] scaleArray = new Vector4[AtlasLayout.MostCascades];

        internal void Set(CommandBuffer commands, SunShadowSettings settings, in AtlasLayout layout,
                          SunCascade[] cascades, int count)
        {
            for (int i = 0; i < count; ++i)
            {
                matrixArray[i] = cascades[i].worldToShadow;
                sphereArray[i] = cascades[i].Sphere;
                tileArray[i] = layout.Tile(i);
                scaleArray[i] = cascades[i].Scales;
            }
            commands.SetGlobalMatrixArray(worldToShadow, matrixArray);
            commands.SetGlobalVectorArray(spheres, sphereArray);
            commands.SetGlobalVectorArray(tiles, tileArray);
            commands.SetGlobalVectorArray(scales, scaleArray);
            // The library's packing clamps the user's values.
            var packed = new ShadowUniforms(settings.Parameters, layout, 0);
            commands.SetGlobalVector(atlasTexelSize, packed.MainLightAtlasTexelSize);
            packed.PcssAngular.SetGlobal(commands);
            // The noise is static: without a temporal filter, changing noise would flicker.
            commands.SetGlobalVector(cascadeCount, new Vector4(count, 0.0f, 0.0f, 0.0f));
        }

        /// <summary>Sets the bias for the cascade that is drawn next.</summary>
        internal void SetCasterBias(CommandBuffer commands, SunShadowSettings settings, in CascadeScales cascade)
        {
            Vector2 metres = ShadowBias.OfCascade(cascade, settings.depthBias, settings.normalBias,
                                                  SoftShadowKernel.Off);
            commands.SetGlobalVector(casterBias, new Vector4(metres.x, metres.y, 0.0f, 0.0f));
        }
    }
}
