cbuffer C1
{
    float4 a : packoffset(c1); float b : packoffset(c0.y); float2 c : packoffset(c0.z);
    float d[3] : packoffset(c2); float e : packoffset(c4.y);
}
cbuffer C2 { float f : packoffset(c0); }
cbuffer C3
{
    float2 g : packoffset(c0.z); float h : packoffset(c0.y); float4x4 m : packoffset(c1); float2 i[2] : packoffset(c5.x);
}
float4 Main() : SV_Target { return 1; }
