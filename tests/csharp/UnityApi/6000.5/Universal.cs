using Penumbra.UnityApi;

namespace UnityEngine.Rendering.Universal
{
    public partial class UniversalRendererData
    {
        public bool tileOnlyMode { get; set; }
    }
}
