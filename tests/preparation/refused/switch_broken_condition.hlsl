// switch_broken_condition.hlsl:4:75: error: expected '(', found '}'
// A closing bracket behind a keyword is no condition, so the check of cases does not go on behind it.
int n;
float4 Main() : SV_Target { float v = 0; switch (n) { case 0: { n = 1; if } v = 2; break; } return v; }
