#include "cycle_a.hlsl"
