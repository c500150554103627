// missing_return.hlsl:2:27: error: function 'Main' must return a value
float4 Main() : SV_Target { }
