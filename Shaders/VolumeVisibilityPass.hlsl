// Penumbra: the visibility that the stencil left of shadow volumes.
//
// Computes:   VolumeVisibility   1 at the pixels that the pass's stencil test leaves; the others keep the target's 0
// Source:     Crow 1977; Heidmann 1991.
// Inputs:     the stencil of ShadowVolumePasses.hlsl, through the stencil test of the pass.
// Cost:       no fetches.
// Guarantees: every pixel is 0 or 1.
// Use it:     into a target of one channel that is 0, after CountVolumes.
#ifndef PENUMBRA_VOLUME_VISIBILITY_PASS_HLSL
#define PENUMBRA_VOLUME_VISIBILITY_PASS_HLSL

#include "ScreenPass.hlsl"

float4 VolumeVisibility(ScreenVaryings input) : SV_Target
{
    return 1.0;
}

#endif
