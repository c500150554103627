// compile: --stage compute --entry Main
#if UNITY_VERSION >= 60010000 || UNITY_VERSION < 202230 || 201710 > UNITY_VERSION || UNITY_VERSION >= 60000023
#elif UNITY_VERSION >= 600000 || UNITY_VERSION < 6000000 || UNITY_VERSION >= 550 || defined(UNITY_VERSION) && _A == 600010
#endif
#if UNITY_VERSION >= 600010  // penumbra-lint: disable=unity-version
#endif
groupshared float _Sum;
groupshared uint _Other = 1;  // penumbra-lint: disable=groupshared-initialiser
static const uint _Counts[2] = { 1, 2 };
RWStructuredBuffer<float> W;
[numthreads(1, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)
{
    _Sum = _Counts[id.x & 1] + _Other;
    W[id.x] = _Sum;
}
