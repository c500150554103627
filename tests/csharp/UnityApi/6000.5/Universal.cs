namespace UnityEngine.Rendering.Universal;

public partial class UniversalRendererData
{
    // Unity serializes this field.
    private int m_PrepassLayerMask = -1;
    private int m_OpaqueLayerMask = -1;

    public bool tileOnlyMode { get; set; }
}
