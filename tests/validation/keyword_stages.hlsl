struct Out { float4 p : SV_Position;
#ifdef LIT
    float3 n : NORMAL;
#endif
#ifndef WAVES
    float id : ID;
#endif
};
Out Vert(float4 v : POSITION) { return (Out)v.x; }
float4 Frag(float3 n : NORMAL, float id : ID) : SV_Target
{
    float4 c = 0;
#ifdef LIT
    c += n.x;
#endif
#if defined(FOG) || defined(WAVES)
    c += id;
#endif
    return c;
}
