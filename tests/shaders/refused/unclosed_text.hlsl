// unclosed_text.hlsl:2:40: error: this text has no closing '"' on its line
float4 Main() : SV_Target { string s = "abc;
return 1; }
