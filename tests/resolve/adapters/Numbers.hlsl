// Every kind of declaration; each number that is read has a decimal place of its own.
struct Light { float range; float2 shift[2]; int mode; float2x3 turn; };
Light _Lights[2];
float _Taps[3];
uint _Count;
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    return _Lights[0].range + 10.0 * _Lights[1].shift[1].y + 100.0 * _Lights[1].mode +
           1000.0 * _Lights[1].turn[1][2] + 10000.0 * mul(_Lights[1].turn, float3(1.0, 0.0, 0.0)).y +
           100000.0 * _Taps[2] + 1000000.0 * _Count;
}
