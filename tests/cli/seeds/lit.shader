Shader "Seeds/Lit"
{
    Properties
    {
        _BaseMap ("Albedo", 2D) = "white" {}
        _BaseColor ("Color", Color) = (1, 1, 1, 1)
        [Toggle] _Cutoff ("Cutoff", Range(0, 1)) = 0.5
    }
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        HLSLINCLUDE
        #pragma target 3.5
        cbuffer UnityPerMaterial
        {
            float4 _BaseColor;
            half _Cutoff;
        };
        Texture2D _BaseMap;
        SamplerState sampler_BaseMap;
        struct Varyings
        {
            float4 position : SV_Position;
            half2 uv : TEXCOORD0;
        };
        ENDHLSL
        Pass
        {
            Name "Forward"
            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment Frag
            #pragma multi_compile _ _FOG
            #pragma shader_feature_local_fragment _ _ALPHATEST_ON
            Varyings Vert(float3 position : POSITION, float2 uv : TEXCOORD0)
            {
                Varyings output = (Varyings)0;
                output.position = float4(position, 1);
                output.uv = uv;
                return output;
            }
            half4 Frag(Varyings input) : SV_Target
            {
                half4 color = _BaseMap.Sample(sampler_BaseMap, input.uv) * _BaseColor;
            #if defined(_ALPHATEST_ON)
                clip(color.a - _Cutoff);
            #endif
            #ifdef _FOG
                for (int i = 0; i < 4; ++i) color.rgb = lerp(color.rgb, 0.5h, 0.25h);
            #endif
                return color;
            }
            ENDHLSL
        }
        Pass
        {
            Name "ShadowCaster"
            ZWrite On ColorMask 0
            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment Frag
            float4 Vert(float3 position : POSITION) : SV_Position { return float4(position, 1); }
            void Frag() {}
            ENDHLSL
        }
    }
    Fallback Off
}
