using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Penumbra
{
    /// <summary>
    /// The shaders and compute shaders of passes beside the feature's own, kept in the feature's asset: a player
    /// contains what an asset refers to, and graphs are no assets.
    /// </summary>
    [Serializable]
    internal sealed class PassAssets
    {
        private const string Package = "Packages/com.penumbra.shadows/";

        [Tooltip("Where in the package each asset lies.")]
        [SerializeField] private List<string> paths = new List<string>();
        [Tooltip("In the order of the paths.")]
        [SerializeField] private List<Object> assets = new List<Object>();

        /// <summary>In the editor: looks for what is not there yet. True when something has been added.</summary>
        internal bool Find(IEnumerable<TechniqueGraph> graphs)
        {
            bool changed = false;
#if UNITY_EDITOR
            foreach (TechniqueGraph graph in graphs)
                foreach (GraphPass pass in graph.passes)
                    changed |= pass.asset != PenumbraShadows.ShaderFile && Find(pass.asset);
#endif
            return changed;
        }

        /// <summary>Null where it is missing.</summary>
        internal Object Of(string path)
        {
            int at = paths.IndexOf(path);
            return at >= 0 && at < assets.Count ? assets[at] : null;
        }

#if UNITY_EDITOR
        private bool Find(string path)
        {
            if (Of(path) != null) return false;
            var asset = UnityEditor.AssetDatabase.LoadAssetAtPath<Object>(Package + path);
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
