int n;
namespace A { static const int b = 4; }
float Shared(float v)
{
    switch (n) { case 0: case 1: v = 1; break; default: case 3: break; }
    switch (n) { case 0: { v = 1; break; } case 1: { v = 2; } break; case A::b: return 2; }
    switch (n) { case 0: if (n) { return 1; } else if (v) return 2; else { break; } case 1: break; }
    switch (n) { case 0: v = 1; if (true) break; v = 9; case 1: if (false) break; v = 2; break; }
    switch (n) { case 0: [branch] if (n) { v = 1; } ; [unroll] for (int i = 0; i < 2; ++i) v += i; break; }
    switch (n) { case 0: switch (n) { case 1: return 1; default: return 2; } case 1: break; }
    switch (n) { case 0: return 1; default: ; }
    switch ((int)v) { case 1: { v = 1; break; } default: break; }
    return v;
}

float Continued(float v)
{
    for (int i = 0; i < n; ++i)
    {
        switch (n)
        {
            case 0:
                for (int j = 0; j < n; ++j) { if (j > 2) continue; }
                do { if (n) continue; } while (n > 8);
                break;
        }
        if (n > 3) continue;
    }
    return v;
}

float Labels()
{
    const int k = 2; static const int K = 6;
    switch (n)
    {
        case k: case 0x10: case -1: case 1: case (int)5: case K + 1: case max(7, 8): return 2;
        case 3: switch (n) { case 3: return 1; default: return 2; }
        case 4: return 1;
        default: return 2;
    }
}

float4 Main() : SV_Target { return Shared(1) + Continued(1) + Labels(); }
