using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering.Universal;

namespace Penumbra.Editor
{
    /// <summary>
    /// The findings of the last search of the project. A search reads every shader, so it runs on demand alone; its
    /// findings are serialized with the window, and stay when scripts are compiled.
    /// </summary>
    [Serializable]
    internal sealed class ReceiverSearch
    {
        [SerializeField] internal bool done;

        /// <summary>Whether the project has changed since the search.</summary>
        [SerializeField] internal bool outdated;

        [SerializeField] internal List<ReceiverProblem> problems = new List<ReceiverProblem>();

        /// <summary>
        /// The renderers with the feature; whether their prepass excludes layers is read as it is shown.
        /// </summary>
        [SerializeField] private List<ScriptableRendererData> renderers = new List<ScriptableRendererData>();

        internal void Run()
        {
            problems = ReceiverReport.Find();
            renderers = FeaturesInProject.Renderers();
            done = true;
            outdated = false;
        }

        internal List<(ScriptableRendererData renderer, int layers)> Renderers()
        {
            renderers.RemoveAll(renderer => renderer == null);  // these were deleted since
            return PrepassLayers.In(renderers);
        }
    }
}
