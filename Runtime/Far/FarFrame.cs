using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>
    /// The data from which a frame's far shadows and clouds are computed; the uniforms of Shaders/FarPass.hlsl.
    /// </summary>
    internal struct FarFrame
    {
        internal static readonly int TowardSun = Shader.PropertyToID("_PenumbraTowardSun");
        internal static readonly int ShadowDistance = Shader.PropertyToID("_PenumbraShadowDistance");
        internal static readonly int CloudCentre = Shader.PropertyToID("_PenumbraCloudCentre");
        internal static readonly int CloudWind = Shader.PropertyToID("_PenumbraCloudWind");
        internal static readonly int GroundArea = Shader.PropertyToID("_PenumbraGroundArea");
        internal static readonly int GroundHeights = Shader.PropertyToID("_PenumbraGroundHeights");
        internal static readonly int GroundChannels = Shader.PropertyToID("_PenumbraGroundChannels");
        internal static readonly int HeightMap = Shader.PropertyToID("_PenumbraGroundHeightsTexture");
        internal static readonly int HorizonFirst = Shader.PropertyToID("_PenumbraHorizonFirstTexture");
        internal static readonly int HorizonSecond = Shader.PropertyToID("_PenumbraHorizonSecondTexture");

        internal FarGround ground;
        internal FarShadowsParameters parameters;
        internal CloudParameters clouds;

        /// <summary>The direction towards the main light, world space, of length 1.</summary>
        internal Vector3 towardSun;

        /// <summary>URP's shadow distance, at most the far plane's.</summary>
        internal float distanceMetres;

        /// <summary>
        /// The camera's position, around which the map of the clouds lies. XR's eyes share it, as they share the map.
        /// </summary>
        internal Vector3 centre;

        /// <summary>The way that the clouds have moved along x and z.</summary>
        internal Vector2 windMetres;

        internal static FarFrame Of(FarShadowsSettings settings, in ShadowSource source, Vector3 camera)
        {
            FarFrame far = default;
            far.parameters = settings.parameters;
            far.clouds = settings.cloudLayer;
            far.towardSun = source.towardLight;
            far.distanceMetres = source.distanceMetres;
            far.centre = camera;
            far.windMetres = new Vector2(Moved(settings.windMetresPerSecond.x), Moved(settings.windMetresPerSecond.y));
            return far;
        }

        // The product is computed in double precision, because a game may run for days.
        private static float Moved(float metresPerSecond)
        {
            double metres = metresPerSecond * Time.timeAsDouble;
            return double.IsNaN(metres) || double.IsInfinity(metres) ? 0.0f : (float)metres;
        }

        internal void Set(CommandBuffer commands, in ShadowOptions options)
        {
            if (!options.DrawsBeyondCascades) return;
            float halfDiameter = 0.5f * options.angularDiameterDegrees * Mathf.Deg2Rad;
            commands.SetGlobalVector(TowardSun, new Vector4(towardSun.x, towardSun.y, towardSun.z, halfDiameter));
            commands.SetGlobalVector(ShadowDistance, new Vector4(distanceMetres, 0.0f, 0.0f, 0.0f));
            parameters.SetGlobal(commands);
            SetGround(commands, options.farShadows);
            if (!options.clouds) return;
            commands.SetGlobalVector(CloudCentre, new Vector4(centre.x, centre.y, centre.z, 0.0f));
            commands.SetGlobalVector(CloudWind, new Vector4(windMetres.x, windMetres.y, 0.0f, 0.0f));
            clouds.SetGlobal(commands);
        }

        private void SetGround(CommandBuffer commands, FarShadowMode mode)
        {
            if (mode == FarShadowMode.Off) return;
            commands.SetGlobalVector(GroundArea, ground.area);
            commands.SetGlobalVector(GroundHeights, ground.heights);
            if (mode == FarShadowMode.HeightMap)
            {
                commands.SetGlobalVector(GroundChannels, ground.channels);
                commands.SetGlobalTexture(HeightMap, ground.heightMap);
                return;
            }
            commands.SetGlobalTexture(HorizonFirst, ground.horizonFirst);
            commands.SetGlobalTexture(HorizonSecond, ground.horizonSecond);
        }
    }
}
