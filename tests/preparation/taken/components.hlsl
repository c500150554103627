struct S { float xx; };
struct T { float4 s, st; float2 p() { return st.xy; } };
float4 Main(float4 c : COLOR) : SV_Target
{
    float3 v = 1; float4x4 m = 1; S s; T t;
    t.s = t.st = 1; float2 a = t.s.xy + t.p();
    if (any(c.xx)) ++v.x; (v.xy) = (c.xx); while (any(c.xx == 1)) --v.y;
    v.xy = c.xx; m._m00_m01 = c.yy; s.xx = 1; bool b = any(c.xx == 1); v = c.xxx;
    c = m._m00_m11.xyxy;
    return 1;
}
