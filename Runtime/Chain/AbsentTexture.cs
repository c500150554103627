using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    /// <summary>What is bound under the name of a texture that a pass does not have; no program reads it.</summary>
    internal static class AbsentTexture
    {
        private static Texture2DArray ofBothEyes;

        /// <summary>With both eyes in one draw, programs declare an array.</summary>
        internal static Texture For(int views)
        {
            if (views == 1) return Texture2D.blackTexture;
            if (ofBothEyes == null)
                ofBothEyes = new Texture2DArray(1, 1, views, GraphicsFormat.R8_UNorm, TextureCreationFlags.None);
            return ofBothEyes;
        }
    }
}
