// missing_return.hlsl:2:27: error: function does not return a value: Main
float4 Main() : SV_Target { }
