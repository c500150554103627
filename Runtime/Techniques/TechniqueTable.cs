using System;
using System.Collections.Generic;
using UnityEngine;

namespace Penumbra
{
    /// <summary>
    /// The techniques, indexed by ShadowTechnique, and the graphs of passes, by name: what `penumbra emit` writes from
    /// the manifests into Techniques.txt. It is read once. Players have the file because the feature's asset keeps it.
    /// </summary>
    internal static class TechniqueTable
    {
        /// <summary>Path of the file in the package.</summary>
        internal const string File = "Runtime/Techniques/Techniques.txt";

        private static TechniqueEntry[] entries;
        private static Dictionary<string, TechniqueGraph> graphs;
        private static TextAsset refused;

        /// <summary>The message that says why there is no table; null once there is one.</summary>
        internal static string Problem { get; private set; } = File + " is missing";

        internal static IReadOnlyList<TechniqueEntry> Entries
        {
            get
            {
                Require();
                return entries;
            }
        }

        internal static TechniqueEntry Entry(this ShadowTechnique technique)
        {
            Require();
            return entries[(int)technique];
        }

        internal static TechniqueGraph Graph(string name)
        {
            Require();
            return graphs.TryGetValue(name, out TechniqueGraph graph) ? graph
                : throw new InvalidOperationException(File + " has no graph '" + name + "'");
        }

        /// <summary>Reads the file, unless one was read. True if there is a table.</summary>
        internal static bool Load(TextAsset file)
        {
            if (entries != null) return true;
            if (file == null || file == refused) return false;
            try
            {
                var reader = new TechniqueReader(file.text);
                graphs = reader.graphs;
                entries = reader.OfEveryTechnique();
                foreach (string name in ChainGraphs.Names) Graph(name);
                Problem = null;
            }
            catch (Exception error) when (error is FormatException || error is InvalidOperationException)
            {
                Forget();
                refused = file;
                Problem = error.Message;
            }
            return entries != null;
        }

        /// <summary>Lets the file be read anew, as after an edit.</summary>
        internal static void Forget()
        {
            entries = null;
            graphs = null;
            refused = null;
            Problem = File + " is missing";
        }

        // In the editor, inspectors and builds use the table whether a feature has loaded it or not.
        private static void Require()
        {
            if (entries != null) return;
#if UNITY_EDITOR
            Load(UnityEditor.AssetDatabase.LoadAssetAtPath<TextAsset>(PassAssets.PathInProject(File)));
#endif
            if (entries == null) throw new InvalidOperationException(Problem);
        }
    }
}
