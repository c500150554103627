// The inputs that techniques need of a scene besides the frame (techniques::Need), baked for a study.
#pragma once

#include <vector>

#include "bake/block_run.h"
#include "resolve/frame_inputs.h"
#include "scene/scene.h"
#include "techniques/pass_graph.h"

namespace penumbra::study {

struct BakeSettings {
  int ground_samples = 1025;    // along the ground's longer side
  int horizon_texels = 512;     // the same
  double nearest_metres = 0.0;  // for horizon angles: ground nearer than this hides nothing
  int field_voxels = 64;        // for distance fields: along the longest side of each object
};

// The inputs of the scene's ground (bake::ground_of) are textures of 16 bits, as `penumbra bake` writes them:
//   _PenumbraGroundArea      corner and size of the ground, x and z, world space, metres
//   _PenumbraGroundHeights   metres of 0 and of 1; samples along x and z
//   _PenumbraGroundChannels  of heights in one channel
//   _PenumbraGroundHeightsTexture
//   _PenumbraHorizonFirstTexture, _PenumbraHorizonSecondTexture
// The inputs of its objects (bake::ObjectFields) are:
//   _PenumbraFieldAtlas, _PenumbraFieldObjects, _PenumbraFieldTexture
// One input is of no scene (parameters/noise_mask.h): 8 bits, the slices below each other:
//   _PenumbraNoiseMaskTexture
// Throws as the bakes do.
resolve::FrameInputs baked_inputs(const gpu::Device& device, const scene::Scene& scene,
                                  const std::vector<techniques::Need>& needs, const BakeSettings& settings,
                                  const bake::BakeOptions& run);

// Returns the memory in MiB of the inputs that are baked for these needs.
double baked_mebibytes(const resolve::FrameInputs& inputs, const std::vector<techniques::Need>& needs);

}  // namespace penumbra::study
