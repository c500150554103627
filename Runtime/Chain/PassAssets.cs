using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Penumbra
{
    /// <summary>
    /// The file of techniques, and the shaders and compute shaders of passes other than the feature's own. They are
    /// stored in the feature's asset: a player contains what an asset references, and graphs are not assets.
    /// </summary>
    [Serializable]
    internal sealed class PassAssets
    {
        private const string Folder = "Shaders";

        /// <summary>
        /// The GUID of the package's folder, by which a package that was copied into Assets is found, too.
        /// </summary>
        internal const string FolderGuid = "d547e543300383e817b83b7a554c305a";

        [Tooltip("Each asset's path in the package.")]
        [SerializeField] private List<string> paths = new List<string>();
        [Tooltip("In the order of the paths.")]
        [SerializeField] private List<Object> assets = new List<Object>();

        internal TextAsset Techniques => Of(TechniqueTable.File) as TextAsset;

#if UNITY_EDITOR
        /// <summary>Finds the assets that are not stored yet. True if any was added.</summary>
        internal bool Find(IEnumerable<TechniqueGraph> graphs)
        {
            bool changed = false;
            foreach (TechniqueGraph graph in graphs)
                foreach (GraphPass pass in graph.passes)
                    changed |= pass.asset != PenumbraShadows.ShaderFile && Find(pass.asset);
            return changed;
        }
#endif

        /// <summary>The asset at the path; null if it is missing.</summary>
        internal Object Of(string path)
        {
            int at = paths.IndexOf(path);
            return at >= 0 && at < assets.Count ? assets[at] : null;
        }

#if UNITY_EDITOR
        /// <summary>The place of the package's file `path` in the project.</summary>
        internal static string PathInProject(string path)
        {
            string folder = UnityEditor.AssetDatabase.GUIDToAssetPath(FolderGuid);
            return folder.Substring(0, Math.Max(0, folder.Length - Folder.Length)) + path;
        }

        internal bool Find(string path)
        {
            if (Of(path) != null) return false;
            var asset = UnityEditor.AssetDatabase.LoadAssetAtPath<Object>(PathInProject(path));
            if (asset == null) return false;
            int at = paths.IndexOf(path);
            if (at >= 0)
            {
                assets[at] = asset;
            }
            else
            {
                paths.Add(path);
                assets.Add(asset);
            }
            return true;
        }
#endif
    }
}
