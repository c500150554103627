// Penumbra: what the filters with fixed kernels read, for exits before them.
//
// Computes:   ExitReach of the single comparison, of boxes, of four taps and of tents.
// Source:     FixedPcf.hlsl, TentPcf.hlsl, HardTest.hlsl. Along each axis a kernel reads as far as its outermost fetch and
//             the footprint around it.
// Inputs:     those of the filters.
// Cost:       no fetches.
// Guarantees: those of FilterExits.hlsl.
// Use it:     with DecideExits, where the map's passes cost less than the fetches that they save: not before kernels of four
//             fetches and fewer.
#ifndef PENUMBRA_KERNEL_EXITS_HLSL
#define PENUMBRA_KERNEL_EXITS_HLSL

#include "FilterExits.hlsl"
#include "../Core/ShadowBias.hlsl"
#include "BoxParameters.hlsl"

static const float kDiagonal = 1.4142136;

// reach: of the outermost fetch, texels along each axis. Tents place their fetches between texels; boxes do not.
float KernelRadius(float reach)
{
    return kDiagonal * (reach + kFootprintTexels);
}

ExitReach FlatKernel(ShadowReceiver receiver, ShadowTile tile, float reach)
{
    return FlatReachOfDisc(PrepareQuads(receiver, tile), KernelRadius(reach));
}

ExitReach PlaneKernel(ShadowReceiver receiver, ShadowTile tile, float reach)
{
    ExitReach kernel = ReachOfDisc(PrepareQuads(receiver, tile), KernelRadius(reach));
    kernel.planeShift = kFootprintShift;
    kernel.planeAlone = true;
    return kernel;
}

// taps: fetches along each axis. The kernel is 2 taps - 1 texels wide.
float TentReach(float taps)
{
    return taps - 0.5;
}

float BoxReach(BoxParameters parameters)
{
    return 0.5 * (min(max(float(parameters.tapsPerSide), 1.0), 9.0) - 1.0);
}

ExitReach ReachOfOneTap(ShadowReceiver receiver, ShadowTile tile)
{
    return FlatKernel(receiver, tile, 0.0);
}

ExitReach ReachOfFourTap(ShadowReceiver receiver, ShadowTile tile)
{
    return FlatKernel(receiver, tile, 0.5);
}

ExitReach ReachOfFourTapPlane(ShadowReceiver receiver, ShadowTile tile)
{
    return PlaneKernel(receiver, tile, 0.5);
}

ExitReach ReachOfBox(ShadowReceiver receiver, ShadowTile tile, BoxParameters parameters)
{
    return FlatKernel(receiver, tile, BoxReach(parameters));
}

ExitReach ReachOfBoxPlane(ShadowReceiver receiver, ShadowTile tile, BoxParameters parameters)
{
    return PlaneKernel(receiver, tile, BoxReach(parameters));
}

ExitReach ReachOfTent3x3(ShadowReceiver receiver, ShadowTile tile)
{
    return FlatKernel(receiver, tile, TentReach(2.0));
}

ExitReach ReachOfTent5x5(ShadowReceiver receiver, ShadowTile tile)
{
    return FlatKernel(receiver, tile, TentReach(3.0));
}

ExitReach ReachOfTent7x7(ShadowReceiver receiver, ShadowTile tile)
{
    return FlatKernel(receiver, tile, TentReach(4.0));
}

ExitReach ReachOfTent3x3Plane(ShadowReceiver receiver, ShadowTile tile)
{
    return PlaneKernel(receiver, tile, TentReach(2.0));
}

ExitReach ReachOfTent5x5Plane(ShadowReceiver receiver, ShadowTile tile)
{
    return PlaneKernel(receiver, tile, TentReach(3.0));
}

ExitReach ReachOfTent7x7Plane(ShadowReceiver receiver, ShadowTile tile)
{
    return PlaneKernel(receiver, tile, TentReach(4.0));
}

// TentAdaptive's own bias.
ExitReach ReachOfTent5x5Adaptive(ShadowReceiver receiver, ShadowTile tile)
{
    ExitReach kernel = FlatKernel(receiver, tile, TentReach(3.0));
    const float2 texelSize = kernel.receiver.texelSize;
    const float bias = AdaptiveBias(BoundGradient(receiver.depthGradient), 2.5 * texelSize, 0.01);
    kernel.receiver.depth = min(max(MoveTowardLight(kernel.receiver.depth, bias), 0.0), 1.0);
    return kernel;
}

#endif
