using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Samples.CustomPipeline
{
    /// <summary>
    /// The pipeline as an asset: create one, and name it in Project Settings, Graphics. Unity 6 wants to know the
    /// pipeline's type from the asset's.
    /// </summary>
    [CreateAssetMenu(menuName = "Rendering/Penumbra Sample Pipeline", fileName = "SoftShadowPipeline")]
    public sealed class SoftShadowPipelineAsset
#if UNITY_6000_0_OR_NEWER
        : RenderPipelineAsset<SoftShadowPipeline>
#else
        : RenderPipelineAsset
#endif
    {
        [SerializeField] private SunShadowSettings sun = new SunShadowSettings();

        /// <inheritdoc/>
        protected override RenderPipeline CreatePipeline() => new SoftShadowPipeline(sun);
    }
}
