#pragma multi_compile _ WIDE
struct Surface
{
    float3 normal;
    float roughness;
};

float3x3 Basis(float3 n)
{
    const float3 t = normalize(cross(n, abs(n.y) < 0.9 ? float3(0, 1, 0) : float3(1, 0, 0)));
    return float3x3(t, cross(n, t), n);
}

float Lobe(Surface surface, float3 view)
{
    const float a = surface.roughness * surface.roughness;
    float d = saturate(dot(surface.normal, view));
#if WIDE
    d = d * d;
#endif
    switch (uint(a * 4))
    {
        case 0: return d;
        case 1: return d * a;
        default: break;
    }
    [loop] while (d > 0.5) d *= 0.5;
    return d;
}

float4 Main(float3 normal : NORMAL, float3 view : TEXCOORD1) : SV_Target
{
    Surface surface;
    surface.normal = mul(Basis(normal), view);
    surface.roughness = 0.5;
    return Lobe(surface, view);
}
