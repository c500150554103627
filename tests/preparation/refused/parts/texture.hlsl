Texture2D<float4> _T : register(t0);
