using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Penumbra.Samples.Scenes
{
    /// <summary>Which scene; what to look at in each stands in this sample's README.</summary>
    public enum SampleSceneKind
    {
        /// <summary>Blocks that touch the ground and hover above it.</summary>
        Contact,

        /// <summary>Thin bars and wires, near the ground and far above it.</summary>
        Fence,

        /// <summary>Trees with many small leaves.</summary>
        Foliage,

        /// <summary>The same blocks again and again, out to where the shadows end.</summary>
        Cascades,
    }

    /// <summary>
    /// Builds a scene below its game object, with a sun and a camera, out of primitives and generated meshes; no asset
    /// is needed or made. The same kind and seed give the same scene. Building anew removes what was built before, and
    /// nothing else.
    /// </summary>
    [AddComponentMenu("Penumbra Samples/Sample Scene")]
    public sealed class SampleScene : MonoBehaviour
    {
        [Tooltip("Which scene Build makes.")]
        [SerializeField] private SampleSceneKind kind;

        [Tooltip("Places and turns what is placed by chance: the trees and their leaves.")]
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

        /// <summary>Game objects, meshes and materials of the scene there is; none before Build and after Remove.
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
