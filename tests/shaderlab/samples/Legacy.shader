shader "Samples/Legacy" {
	properties { _Color ("Main Color", Color) = (1,1,1,1) _MainTex ("Base", 2D) = "white" }
	CGINCLUDE
	#define SHARED 1
	ENDCG
	Subshader {
		tags { "Queue"="Transparent" }
		Lighting On SeparateSpecular Off ColorMaterial AmbientAndDiffuse
		Fog { Mode Linear Color (0,0,0,0) Density 0.5 Range 0, 10 }
		AlphaTest Greater [_Cutoff]
		Material { Diffuse [_Color] Ambient (1,1,1,1) Shininess 0.7 Specular [_Spec] Emission [_Em] }
		BindChannels { Bind "Vertex", vertex Bind "texcoord", texcoord0 }
		CGPROGRAM
		#pragma surface surf Lambert
		struct Input { float2 uv_MainTex; };
		void surf(Input i, inout SurfaceOutput o) { o.Albedo = SHARED; }
		ENDCG
		pass {
			Color [_Color]
			AlphaTest Off
			SetTexture [_MainTex] {
				constantColor (1, 1, 1, 0.5)
				matrix [_Matrix]
				combine texture * primary DOUBLE, previous lerp (constant) texture
			}
			SetTexture [_Lightmap] { combine previous +- texture, one - primary }
		}
	}
	FallBack Off
}
