// Test: adds a uniform to a storage image, so that runs can be counted.
cbuffer Step
{
    float4 _Step;
};
RWTexture2D<float4> _Image;

[numthreads(1, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)
{
    _Image[id.xy] = _Image[id.xy] + _Step;
}
