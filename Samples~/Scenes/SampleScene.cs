using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Penumbra.Samples.Scenes
{
    /// <summary>The kind of scene; this sample's README describes what each shows.</summary>
    public enum SampleSceneKind
    {
        /// <summary>Blocks that touch the ground and hover above it.</summary>
        Contact,

        /// <summary>Thin bars and wires, near the ground and far above it.</summary>
        Fence,

        /// <summary>Trees with many small leaves.</summary>
        Foliage,

        /// <summary>The same blocks repeated up to the shadow distance.</summary>
        Cascades,
    }

    /// <summary>
    /// Builds a scene below its game object, with a sun and a camera, from primitives and generated meshes; no asset
    /// is needed or created. The same kind and seed give the same scene. Rebuilding removes only what was built
    /// before.
    /// </summary>
    [AddComponentMenu("Penumbra Samples/Sample Scene")]
    public sealed class SampleScene : MonoBehaviour
    {
        [Tooltip("The scene that Build creates.")]
        [SerializeField] private SampleSceneKind kind;

        [Tooltip("Seed of the random positions and orientations of trees and leaves.")]
        [SerializeField] private int seed = 1;

        [HideInInspector] [SerializeField] private List<Object> built = new List<Object>();

        public SampleSceneKind Kind
        {
            get => kind;
            set => kind = value;
        }

        public int Seed
        {
            get => seed;
            set => seed = value;
        }

        /// <summary>
        /// Game objects, meshes and materials of the built scene; empty before Build and after Remove.
        /// </summary>
        public IReadOnlyList<Object> Built => built;

        [ContextMenu("Build")]
        public void Build()
        {
            Remove();
            new SceneConstruction(transform, built).Build(SceneDescription.Of(kind, seed));
        }

        [ContextMenu("Remove")]
        public void Remove()
        {
            foreach (Object item in built)
            {
                if (item == null) continue;
                if (Application.isPlaying) Destroy(item);
                else DestroyImmediate(item);
            }
            built.Clear();
        }
    }
}
