// recovery_at_file_scope.hlsl:2:1: error: expected a declaration, found 'Textur2D'
Textur2D t;
float First(float x) { return one; }
float4 Main() : SV_Target { return First(1); }
