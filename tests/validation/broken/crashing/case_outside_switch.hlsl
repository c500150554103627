// case_outside_switch.hlsl: ?
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    case 1:
    return uv.xyxy;
}
