#include "cycle_b.hlsl"
