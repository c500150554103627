using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    /// <summary>
    /// The texture that is bound under the name of one that a pass does not have; no program reads it.
    /// </summary>
    internal static class AbsentTexture
    {
        private static Texture2DArray ofBothEyes;

        /// <summary>The texture for so many views: with both eyes in one draw, programs declare an array.</summary>
        internal static Texture For(int views)
        {
            if (views == 1) return Texture2D.blackTexture;
            if (ofBothEyes == null)
                ofBothEyes = new Texture2DArray(1, 1, views, GraphicsFormat.R8_UNorm, TextureCreationFlags.None);
            return ofBothEyes;
        }
    }
}
