#include "../../../Shaders/ScreenPass.hlsl"
#include "../../../ShaderLibrary/VolumetricShadows.hlsl"

float3 _WorldSpaceCameraPos;
float4 _PenumbraFogRaysParameters0;

float4 FogRays(ScreenVaryings input) : SV_Target
{
    const ScreenView view = ViewOfThisEye();
    const int2 pixel = ScreenPixel(input.positionCS);
    const CameraSurface surface = ReadCameraPosition(_CameraDepthTexture, view, pixel);
    const float2 uv = (float2(pixel) + 0.5) * view.size.zw;
    const float3 through = ScreenPointOf(view.screenToWorld, uv, 0.5).positionWS; // any depth between the planes
    const float3 ray = (surface.seen ? surface.positionWS : through) - _WorldSpaceCameraPos;
    const float distance = surface.seen ? min(length(ray), 50.0) : 50.0;
    const float jitter = _PenumbraFogRaysParameters0.y > 0.5 ? GradientNoise(float2(pixel), 0u) : 0.5;
    return PenumbraMainLightFogVisibility(_WorldSpaceCameraPos, normalize(ray), distance, _PenumbraFogRaysParameters0.z,
                                          int(_PenumbraFogRaysParameters0.x), jitter);
}
