using System;
using System.Collections.Generic;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>
    /// The JSON file of `penumbra bake heightfield` or `penumbra bake horizon`; fields have its keys, which
    /// Documentation~/far-shadows.md describes.
    /// </summary>
    [Serializable]
    internal sealed class BakeFile
    {
        internal const string HeightField = "height-field";
        internal const string HorizonAngles = "horizon-angles";
        private const int Version = 1;

        public string kind;
        public int version;
        public string picture;
        public string[] pictures;
        public float[] corner_metres;
        public float[] size_metres;
        public float[] heights_metres;

        internal bool HasHeights => kind == HeightField;

        /// <summary>Names of the pictures, files in the same folder: one of heights, two of horizon angles.</summary>
        internal IReadOnlyList<string> Pictures => HasHeights ? new[] { picture } : pictures;

        internal Vector2 Corner => Pair(corner_metres);
        internal Vector2 Size => Pair(size_metres);
        internal Vector2 Heights => Pair(heights_metres);

        /// <summary>
        /// Reads the file. Returns null, or the reason why the text is no such file, as a message with its remedy.
        /// </summary>
        internal static string Read(string json, out BakeFile bake)
        {
            try
            {
                bake = JsonUtility.FromJson<BakeFile>(json);
            }
            catch (ArgumentException error)
            {
                bake = null;
                return "it is not JSON (" + error.Message + "). Choose the file that `penumbra bake` wrote";
            }
            string problem = bake == null ? "it is empty. Choose the file that `penumbra bake` wrote" : bake.Problem();
            if (problem != null) bake = null;
            return problem;
        }

        private string Problem()
        {
            if (kind != HeightField && kind != HorizonAngles)
                return "its \"kind\" is \"" + kind + "\". Choose a file of `penumbra bake heightfield` or `penumbra bake horizon`";
            if (version != Version)
                return "its \"version\" is " + version + ", and this package reads " + Version + ". Bake again with the program of " +
                       "the package's version";
            if (!IsPair(corner_metres) || !IsPair(size_metres) || HasHeights && !IsPair(heights_metres))
                return "it lacks \"corner_metres\", \"size_metres\" or \"heights_metres\". Bake again";
            int count = HasHeights ? 1 : 2;
            if (Pictures == null || Pictures.Count != count || !IsNamed(Pictures))
                return "it does not name " + (count == 1 ? "its picture" : "two pictures") + " in its folder. Bake again";
            return null;
        }

        // Every picture has a plain name, so that nothing outside of the folder is read.
        private static bool IsNamed(IReadOnlyList<string> names)
        {
            foreach (string name in names)
                if (string.IsNullOrEmpty(name) || name.IndexOfAny(new[] { '/', '\\' }) >= 0) return false;
            return true;
        }

        private static bool IsPair(float[] values) => values != null && values.Length == 2;

        private static Vector2 Pair(float[] values) => new Vector2(values[0], values[1]);
    }
}
