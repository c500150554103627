using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra.Samples.CustomPipeline
{
    /// <summary>
    /// The pipeline's asset: create one, and select it in Project Settings, Graphics. Unity 6 needs the pipeline's
    /// type in the asset's base class.
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
