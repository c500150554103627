#pragma use_dxc
int n;
cbuffer C : register(b20) { float a; };
Texture2D t : register(t300, space1);
Texture2D u[] : register(t0, space1);
static float b[65537];
float4 Main() : SV_Target
{
    float v = 0;
    switch (n) { case 0: v = 1; case 1: break; }
    return v;
}
