using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// The matrix from a pixel of the camera's depth texture to world space:
    /// <code>
    ///   world = S (u, v, stored depth, 1), divided by w
    ///   S = inverse(view) inverse(gpuProjection) N,   N: u, v, depth to clip space
    /// </code>
    /// <para>u and v run from 0 to 1 over the texture, v from texel row 0; depth is as the texture stores it. Each
    /// matrix is inverted separately in double, so that neither a distant camera nor a near plane close to 0 costs
    /// precision; the product is rounded once. Any invertible projection is allowed: off-centre, oblique,
    /// orthographic.</para>
    /// <para>The error of that rounding: with reversed depth about 1e-7 of the camera's distance from the origin;
    /// with depth that is not reversed, more by the factor (receiver's distance / near plane), which is also the
    /// precision that such a depth buffer loses.</para>
    /// </summary>
    public static class ScreenToWorld
    {
        /// <summary>
        /// False if a matrix is singular or not finite, or the result does not fit floats: then nothing can be drawn,
        /// and the matrix is the identity.
        /// </summary>
        /// <param name="view">World to view (Camera.worldToCameraMatrix; of one eye under XR).</param>
        /// <param name="gpuProjection">View to the device's clip space, flipped and reversed as the device has it:
        /// GL.GetGPUProjectionMatrix(projection, whether the camera renders into a texture).</param>
        public static bool TryGet(in Matrix4x4 view, in Matrix4x4 gpuProjection, ScreenConventions conventions,
                                  out Matrix4x4 screenToWorld)
        {
            if (DoubleMatrix.From(gpuProjection).TryInvert(out var clipToView) &&
                DoubleMatrix.From(view).TryInvert(out var viewToWorld))
            {
                var clipToWorld = DoubleMatrix.Product(viewToWorld, clipToView);
                return FromScreen(clipToWorld, conventions).TryRound(out screenToWorld);
            }
            screenToWorld = Matrix4x4.identity;
            return false;
        }

        /// <summary>
        /// The matrix from (uv, stored depth, 1) of one camera to the same of another, both given by their screenToWorld;
        /// the identity if the other's is singular.
        /// </summary>
        internal static Matrix4x4 Between(in Matrix4x4 from, in Matrix4x4 to) =>
            DoubleMatrix.From(to).TryInvert(out DoubleMatrix worldToScreen) &&
            DoubleMatrix.Product(worldToScreen, DoubleMatrix.From(from)).TryRound(out Matrix4x4 between)
                ? between
                : Matrix4x4.identity;

        // The result is right-multiplied by N: clip x = 2u - 1, y = 2v - 1 or its negative, z = depth or 2 depth - 1.
        private static DoubleMatrix FromScreen(in DoubleMatrix clip, ScreenConventions conventions)
        {
            var up = conventions.UvStartsAtTop ? -1.0 : 1.0;
            var toFar = conventions.DepthIsZeroToOne ? 0.0 : 1.0;
            DoubleMatrix screen;
            screen.Column0 = 2.0 * clip.Column0;
            screen.Column1 = 2.0 * up * clip.Column1;
            screen.Column2 = (1.0 + toFar) * clip.Column2;
            screen.Column3 = clip.Column3 - clip.Column0 - up * clip.Column1 - toFar * clip.Column2;
            return screen;
        }
    }
}
