// text.hlsl:12:22: warning: 600010 is no value of UNITY_VERSION: that is 202230 for Unity 2022.3.0, 60000000 for 6000.0.0 and 60010000 for 6000.1.0 [unity-version]
// text.hlsl:13:23: warning: 600010000 is no value of UNITY_VERSION: that is 202230 for Unity 2022.3.0, 60000000 for 6000.0.0 and 60010000 for 6000.1.0 [unity-version]
// text.hlsl:13:67: warning: 20223 is no value of UNITY_VERSION: that is 202230 for Unity 2022.3.0, 60000000 for 6000.0.0 and 60010000 for 6000.1.0 [unity-version]
// text.hlsl:15:23: warning: 60001000 is no value of UNITY_VERSION: that is 202230 for Unity 2022.3.0, 60000000 for 6000.0.0 and 60010000 for 6000.1.0 [unity-version]
// text.hlsl:16:23: warning: 6000 is no value of UNITY_VERSION: that is 202230 for Unity 2022.3.0, 60000000 for 6000.0.0 and 60010000 for 6000.1.0 [unity-version]
// text.hlsl:16:48: warning: 2022 is no value of UNITY_VERSION: that is 202230 for Unity 2022.3.0, 60000000 for 6000.0.0 and 60010000 for 6000.1.0 [unity-version]
// text.hlsl:16:73: warning: 20220300 is no value of UNITY_VERSION: that is 202230 for Unity 2022.3.0, 60000000 for 6000.0.0 and 60010000 for 6000.1.0 [unity-version]
// text.hlsl:18:19: warning: every thread writes the initialiser of the groupshared '_Sum' when it starts, also over what others have written since (DXC ignores it): let one thread write it, and put GroupMemoryBarrierWithGroupSync() behind [groupshared-initialiser]
// text.hlsl:19:18: warning: every thread writes the initialiser of the groupshared '_Count' when it starts, also over what others have written since (DXC ignores it): let one thread write it, and put GroupMemoryBarrierWithGroupSync() behind [groupshared-initialiser]
// text.hlsl:19:48: warning: every thread writes the initialiser of the groupshared '_Last' when it starts, also over what others have written since (DXC ignores it): let one thread write it, and put GroupMemoryBarrierWithGroupSync() behind [groupshared-initialiser]
// compile: --stage compute --entry Main
#if UNITY_VERSION >= 600010
#elif defined(_A) && (600010000 <= UNITY_VERSION || UNITY_VERSION<20223)
#endif
# if UNITY_VERSION >= 60001000 // 6000.1
#elif UNITY_VERSION > 6000 || UNITY_VERSION == 2022 || UNITY_VERSION != 20220300
#endif
groupshared float _Sum = 0;
groupshared uint _Count[2] = { 1, 2 }, _Other, _Last = 3;
RWStructuredBuffer<float> W;
[numthreads(8, 8, 1)] void Main(uint3 id : SV_DispatchThreadID)
{
    W[id.x] = _Sum + _Count[1] + _Other + _Last;
}
