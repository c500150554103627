using System;
using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// What a metre and the light's size come to in one cascade's tile, from URP's world-to-shadow matrix M: its row 0
    /// is atlas UV across the light, its row 2 stored depth along it, so their lengths are UV and depth per metre.
    /// <para>Spaces: tile UV is 0 to 1 over the cascade's tile; depth is as the map stores it. Computed in double,
    /// rounded once. Every figure is finite: of a matrix that maps nothing (URP's no-op matrices of entries beyond
    /// the count, a zero or not finite row) or whose figures no float holds, all are 0 and IsMapped is false.</para>
    /// </summary>
    public readonly struct CascadeScales
    {
        internal readonly double TanHalf;
        private readonly double uvPerMetre;
        private readonly double depthPerMetre;
        private readonly int tileResolution;

        /// <param name="worldToShadow">An entry of _MainLightWorldToShadow: world to atlas UV and stored depth.</param>
        /// <param name="layout">Of the map the entry leads to.</param>
        /// <param name="angularDiameterDegrees">Full angle of the light's disc, as AngularDiameter takes it.</param>
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

        /// <summary>False: the matrix leads to no tile, and what it would shade is lit.</summary>
        public bool IsMapped => uvPerMetre > 0.0;

        /// <summary>Tile UV per metre across the light: |row0| / tile width.</summary>
        public float UvPerMetre => (float)uvPerMetre;

        /// <summary>Stored depth per metre along the light: |row2|.</summary>
        public float DepthPerMetre => (float)depthPerMetre;

        /// <summary>Penumbra radius in tile UV per unit of depth gap: tan(a/2) UvPerMetre / DepthPerMetre.</summary>
        public float DepthToRadial => (float)DepthToRadialInDouble;

        /// <summary>Its inverse; 0 stands for none, at angular diameter 0.</summary>
        public float RadialToDepth => (float)RadialToDepthInDouble;

        /// <summary>
        /// HDRP's tan(a/2) |m00 / m22| of the device projection (depth 0 to 1): twice the geometric radius.
        /// </summary>
        public float DepthToRadialHdrp => (float)(2.0 * DepthToRadialInDouble);

        /// <summary>Side of a texel across the light.</summary>
        public float TexelSizeMetres => (float)TexelSizeInDouble;

        /// <summary>Penumbra radius for a gap as long as the tile's whole depth range.</summary>
        public float MaxPenumbraTexels => (float)(DepthToRadialInDouble * tileResolution);

        internal double UvPerMetreInDouble => uvPerMetre;
        internal double DepthPerMetreInDouble => depthPerMetre;
        internal double DepthToRadialInDouble => IsMapped ? TanHalf * uvPerMetre / depthPerMetre : 0.0;
        internal double RadialToDepthInDouble => TanHalf > 0.0 ? depthPerMetre / (TanHalf * uvPerMetre) : 0.0;
        internal double TexelSizeInDouble => IsMapped ? 1.0 / (uvPerMetre * tileResolution) : 0.0;
        internal double DepthRangeMetres => IsMapped ? 1.0 / depthPerMetre : 0.0;

        // Squares of floats neither overflow nor vanish in double.
        private static double Length(float x, float y, float z) =>
            Math.Sqrt((double)x * x + (double)y * y + (double)z * z);

        private bool IsMeasurable() =>
            uvPerMetre > 0.0 && depthPerMetre > 0.0 && Bounded.FitsFloat(uvPerMetre) &&
            Bounded.FitsFloat(depthPerMetre) && Bounded.FitsFloat(2.0 * DepthToRadialInDouble) &&
            Bounded.FitsFloat(RadialToDepthInDouble) && Bounded.FitsFloat(TexelSizeInDouble) &&
            Bounded.FitsFloat(DepthToRadialInDouble * tileResolution) && Bounded.FitsFloat(DepthRangeMetres);
    }
}
