// case_outside_switch.hlsl:4:5: error: 'case' is in no switch: a label belongs in a switch's braces
float4 Main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    case 1:
    return uv.xyxy;
}
