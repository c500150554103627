// entry_missing.hlsl: error: the entry point 'Main' is not defined
float4 Frag(float4 position : SV_Position) : SV_Target
{
    return 1.0;
}
