using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Penumbra
{
    /// <summary>
    /// The shaders and compute shaders that passes bring, kept in the feature's asset: a player contains what an asset
    /// refers to, and passes are no assets.
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
        internal bool Find(IReadOnlyList<ShadowPass> passes)
        {
            bool changed = false;
#if UNITY_EDITOR
            foreach (ShadowPass pass in passes)
            {
                if (pass.AssetPath == null || Of(pass) != null) continue;
                var asset = UnityEditor.AssetDatabase.LoadAssetAtPath<Object>(Package + pass.AssetPath);
                if (asset == null) continue;
                int at = paths.IndexOf(pass.AssetPath);
                if (at >= 0)
                {
                    assets[at] = asset;
                }
                else
                {
                    paths.Add(pass.AssetPath);
                    assets.Add(asset);
                }
                changed = true;
            }
#endif
            return changed;
        }

        /// <summary>Hands each pass its own; null where it is missing.</summary>
        internal void Give(IReadOnlyList<ShadowPass> passes)
        {
            foreach (ShadowPass pass in passes)
                if (pass.AssetPath != null) pass.SetAsset(Of(pass));
        }

        private Object Of(ShadowPass pass)
        {
            int at = paths.IndexOf(pass.AssetPath);
            return at >= 0 && at < assets.Count ? assets[at] : null;
        }
    }
}
