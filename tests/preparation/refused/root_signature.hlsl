// root_signature.hlsl:3:2: warning: unrecognized attribute 'RootSignature'
// compile: --stage compute
[RootSignature("")][numthreads(8, 8, 1)] void Main(uint3 id : SV_DispatchThreadID) { }
