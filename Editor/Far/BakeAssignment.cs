using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>Fills a FarShadowGround from the JSON file of a bake and the pictures beside it.</summary>
    internal static class BakeAssignment
    {
        /// <summary>
        /// Assigns the bake. Returns null, or the reason why the component stays as it was, as a message with its
        /// remedy.
        /// </summary>
        internal static string Assign(TextAsset file, FarShadowGround ground)
        {
            string path = AssetDatabase.GetAssetPath(file);
            string problem = BakeFile.Read(file.text, out BakeFile bake);
            if (problem == null) problem = Assign(bake, path, ground);
            return problem == null ? null : path + " was not assigned: " + problem + ".";
        }

        private static string Assign(BakeFile bake, string path, FarShadowGround ground)
        {
            bool hasOther = bake.HasHeights ? ground.HorizonFirst != null || ground.HorizonSecond != null
                                            : ground.HeightMap != null;
            bool isSameArea = ground.CornerMetres.Equals(bake.Corner) && ground.SizeMetres.Equals(bake.Size);
            if (hasOther && !isSameArea)
                return "it covers another area than the pictures that are assigned. Bake the horizon of the same height field, " +
                       "or remove those pictures";
            var pictures = new List<Texture2D>();
            foreach (string name in bake.Pictures)
            {
                string picture = path.Substring(0, path.LastIndexOf('/') + 1) + name;
                pictures.Add(BakedPicture.Import(picture, bake.HasHeights));
                if (pictures[pictures.Count - 1] == null) return "there is no " + picture + ". Copy the bake's pictures beside it";
            }
            Undo.RecordObject(ground, "Assign Bake");
            ground.CornerMetres = bake.Corner;
            ground.SizeMetres = bake.Size;
            if (bake.HasHeights)
            {
                ground.HeightsMetres = bake.Heights;
                ground.HeightMap = pictures[0];
            }
            else
            {
                ground.HorizonFirst = pictures[0];
                ground.HorizonSecond = pictures[1];
            }
            EditorUtility.SetDirty(ground);
            return null;
        }
    }
}
