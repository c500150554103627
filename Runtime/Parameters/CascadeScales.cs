using System;
using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// The scales of one cascade's tile, from URP's world-to-shadow matrix M: how a metre and the light's size map to
    /// UV and depth. Row 0 of M is atlas UV across the light and row 2 the stored depth along it, so their lengths
    /// are UV and depth per metre.
    /// <para>Spaces: tile UV is 0 to 1 over the cascade's tile; depth is as the map stores it. Computed in double,
    /// rounded once. Every value is finite: if the matrix maps nothing (URP's no-op matrices of unused entries, a
    /// zero row or one that is not finite) or a value does not fit a float, all are 0 and IsMapped is false.</para>
    /// </summary>
    public readonly struct CascadeScales
    {
        internal readonly double TanHalf;
        private readonly double uvPerMetre;
        private readonly double depthPerMetre;
        private readonly int tileResolution;

        /// <param name="worldToShadow">An entry of _MainLightWorldToShadow: world to atlas UV and stored depth.</param>
        /// <param name="layout">Of the map that the matrix projects into.</param>
        /// <param name="angularDiameterDegrees">Full angle of the light's disc, see AngularDiameter.</param>
        public CascadeScales(in Matrix4x4 worldToShadow, in AtlasLayout layout, float angularDiameterDegrees)
        {
            TanHalf = AngularDiameter.TanHalfInDouble(angularDiameterDegrees, AngularDiameter.LargestDegrees);
            uvPerMetre = Length(worldToShadow.m00, worldToShadow.m01, worldToShadow.m02) / layout.TileWidth;
            depthPerMetre = Length(worldToShadow.m20, worldToShadow.m21, worldToShadow.m22);
            tileResolution = layout.TileResolution;
            if (IsMeasurable()) return;
            TanHalf = 0.0;
            uvPerMetre = 0.0;
            depthPerMetre = 0.0;
        }

        /// <summary>Whether the matrix projects into a tile; where it does not, its receivers are lit.</summary>
        public bool IsMapped => uvPerMetre > 0.0;

        /// <summary>Tile UV per metre across the light: |row0| / tile width.</summary>
        public float UvPerMetre => (float)uvPerMetre;

        /// <summary>Stored depth per metre along the light: |row2|.</summary>
        public float DepthPerMetre => (float)depthPerMetre;

        /// <summary>Penumbra radius in tile UV per unit of depth gap: tan(a/2) UvPerMetre / DepthPerMetre.</summary>
        public float DepthToRadial => (float)DepthToRadialInDouble;

        /// <summary>The inverse of DepthToRadial; 0 at angular diameter 0, where it does not exist.</summary>
        public float RadialToDepth => (float)RadialToDepthInDouble;

        /// <summary>
        /// HDRP's tan(a/2) |m00 / m22| of the device projection (depth 0 to 1): twice the geometric value.
        /// </summary>
        public float DepthToRadialHdrp => (float)(2.0 * DepthToRadialInDouble);

        /// <summary>Side of a texel in metres, across the light.</summary>
        public float TexelSizeMetres => (float)TexelSizeInDouble;

        /// <summary>Penumbra radius in texels for a gap as long as the tile's whole depth range.</summary>
        public float MaxPenumbraTexels => (float)(DepthToRadialInDouble * tileResolution);

        internal double UvPerMetreInDouble => uvPerMetre;
        internal double DepthPerMetreInDouble => depthPerMetre;
        internal double DepthToRadialInDouble => IsMapped ? TanHalf * uvPerMetre / depthPerMetre : 0.0;
        internal double RadialToDepthInDouble => TanHalf > 0.0 ? depthPerMetre / (TanHalf * uvPerMetre) : 0.0;
        internal double TexelSizeInDouble => IsMapped ? 1.0 / (uvPerMetre * tileResolution) : 0.0;
        internal double DepthRangeMetres => IsMapped ? 1.0 / depthPerMetre : 0.0;

        // Squares of floats neither overflow nor underflow in double.
        private static double Length(float x, float y, float z) =>
            Math.Sqrt((double)x * x + (double)y * y + (double)z * z);

        private bool IsMeasurable() =>
            uvPerMetre > 0.0 && depthPerMetre > 0.0 && Bounded.FitsFloat(uvPerMetre) &&
            Bounded.FitsFloat(depthPerMetre) && Bounded.FitsFloat(2.0 * DepthToRadialInDouble) &&
            Bounded.FitsFloat(RadialToDepthInDouble) && Bounded.FitsFloat(TexelSizeInDouble) &&
            Bounded.FitsFloat(DepthToRadialInDouble * tileResolution) && Bounded.FitsFloat(DepthRangeMetres);
    }
}
