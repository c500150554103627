// Planar and blob shadows sample: the soft shadow of a ball on level ground, on a square that the vertex program lays
// there.
Shader "Penumbra Samples/Blob Shadow"
{
    Properties
    {
        _ShadowColor("Shadow color", Color) = (0.35, 0.38, 0.45, 1)
        _RadiusMetres("Radius of the ball, m", Float) = 0.5
        _GroundMetres("Height of the ground, m", Float) = 0
        _HalfDiameter("Half the sun's angle, radians", Float) = 0.0436
        _FadeMetres("Height of what casts none, m", Float) = 4
    }

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Transparent" "Queue" = "Transparent-100" }

        Pass
        {
            Name "BlobShadow"
            Tags { "LightMode" = "UniversalForwardOnly" }
            Blend DstColor Zero
            ZTest LEqual
            ZWrite Off
            Cull Off
            Offset -1, -1

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex BlobVertex
            #pragma fragment BlobFragment
            #pragma multi_compile_instancing
            #include "BlobShadow.hlsl"
            ENDHLSL
        }
    }
}
