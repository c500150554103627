// switch_cases.hlsl:18:34: error: this case has code and ends without break or return, and HLSL does not fall through: end it with break, or repeat the code of the next one
// switch_cases.hlsl:19:44: error: this case has code and ends without break or return, and HLSL does not fall through: end it with break, or repeat the code of the next one
// switch_cases.hlsl:20:59: error: this case has code and ends without break or return, and HLSL does not fall through: end it with break, or repeat the code of the next one
// switch_cases.hlsl:21:52: error: this case has code and ends without break or return, and HLSL does not fall through: end it with break, or repeat the code of the next one
// switch_cases.hlsl:22:35: error: this case has code and ends without break or return, and HLSL does not fall through: end it with break, or repeat the code of the next one
// switch_cases.hlsl:23:41: error: this case has code and ends without break or return, and HLSL does not fall through: end it with break, or repeat the code of the next one
// switch_cases.hlsl:24:60: error: the last case of a switch is empty: write break
// switch_cases.hlsl:29:43: error: HLSL has no continue in a switch: set a variable, and continue after the switch
// switch_cases.hlsl:35:5: error: 'case' is in no switch: a label belongs in a switch's braces
// switch_cases.hlsl:36:20: error: 'default' is in no switch: a label belongs in a switch's braces
// switch_cases.hlsl:40:9: error: a case label must be a constant, and 'n' is not: use a number, a static const, or if and else
// switch_cases.hlsl:41:9: error: a case label must be a constant, and 'n' is not: use a number, a static const, or if and else
// switch_cases.hlsl:42:9: error: a case label must be a constant, and 'Two' is not: use a number, a static const, or if and else
// switch_cases.hlsl:43:9: error: a case label must be a constant, and 'v' is not: use a number, a static const, or if and else
// switch_cases.hlsl:44:9: error: a case label must be an integer, and this is '1.5'
// switch_cases.hlsl:46:9: error: the switch has case 3 already, in line 45: remove one of the two
int n; static const int K = 3;
int Two() { switch (n) { case 0: case 1: n = 1; case 2: break; } return 2; }
float FallsThrough(float v) { switch (n) { case 0: v = 1; case 1: v += 2; break; } return v; }
float EndsWithCode(float v) { switch (n) { case 0: break; case 1: v = 1; } return v; }
void EndsInDiscard() { switch (n) { case 0: break; default: discard; } }
void MayNotBreak() { switch (n) { case 0: if (n > 2) break; default: break; } }
float HasABlock(float v) { switch (n) { case 3 ? 1 : 2: { v = 1; } case 3: break; } return v; }
float EndsInAnEmptyCase() { switch (n) { case 0: return 1; default: } return 2; }

float ContinuesTheLoopAround()
{
    for (int i = 0; i < n; ++i)
        switch (n) { case 0: if (i > 2) { continue; } break; }
    return 2;
}

float4 Labels(float4 c : COLOR) : SV_Target
{
    case 1: c.x = 1;
    if (c.x > 0) { default: c.x = 1; }
    const int v = n;
    switch (n)
    {
        case n: return 1;
        case n + 1: return 1;
        case Two(): return 1;
        case v: return 1;
        case 1.5: return 1;
        case 3: return 1;
        case K: return 2;
        default: return 2;
    }
}

float4 Main() : SV_Target { return 1; }
