// entry_missing.hlsl: error: there is no function 'Main' to enter at
float4 Frag(float4 position : SV_Position) : SV_Target
{
    return 1.0;
}
