// Planar and blob shadows sample: an object flattened onto level ground along the main light. A stencil bit keeps
// pixels from being darkened twice where several triangles, or objects, cast onto them.
Shader "Penumbra Samples/Planar Shadow"
{
    Properties
    {
        _ShadowColor("Shadow color", Color) = (0.35, 0.38, 0.45, 1)
        _GroundMetres("Height of the ground, m", Float) = 0
        _FadeMetres("Height of what casts none, m", Float) = 4
    }

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Transparent" "Queue" = "Transparent-100" }

        Pass
        {
            Name "PlanarShadow"
            Tags { "LightMode" = "UniversalForwardOnly" }
            Blend DstColor Zero
            ZTest LEqual
            ZWrite Off
            Cull Off
            Offset -1, -1

            // One of the lower four bits, which URP leaves to its users in its deferred path, too.
            Stencil
            {
                Ref 8
                ReadMask 8
                WriteMask 8
                Comp NotEqual
                Pass Replace
            }

            HLSLPROGRAM
            #pragma target 3.5
            #pragma vertex PlanarVertex
            #pragma fragment PlanarFragment
            #pragma multi_compile_instancing
            #include "PlanarShadow.hlsl"
            ENDHLSL
        }
    }
}
