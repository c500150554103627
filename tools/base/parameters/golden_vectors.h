// Inputs and expected results of the per-frame mathematics, for testing other implementations (C# in the
// package) value by value.
//
// Inputs are exact floats; results are computed from them in double or long double and rounded to float once.
// Every number is printed with the fewest digits that read back to the same float.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "parameters/random_setup.h"
#include "parameters/shader_uniforms.h"

namespace penumbra::parameters {

// The JSON has one list for each kind: angles, atlases, cascades, projections (bias), uniforms, cameras. Each
// has its awkward cases and, where cases are random, `count` of them. The same count and seed give the same
// bytes.
std::string golden_vectors_json(int count, std::uint32_t seed);

// Returns settings outside of both ends of every range, and the angles at which another of them decides; then
// `random` ones in range.
std::vector<SoftShadowParameters> golden_settings(int random, SetupGenerator& generator);

SoftShadowParameters random_settings(SetupGenerator& generator);

// These return the nearest float, of one number and of every field.
double as_float(double value);
SoftShadowParameters as_floats(SoftShadowParameters parameters);

// A cascade as a renderer meets it: a matrix of floats, the map it leads to, and settings.
struct GoldenCascade {
  std::string name;
  glm::dmat4 world_to_shadow{1.0};
  int resolution = 2048;
  int cascades = 4;
  SoftShadowParameters parameters;
  double depth_bias = 1.0;
  double normal_bias = 1.0;
  SoftQuality quality = SoftQuality::medium;
};

// Returns cascades with scales of every size a float has, no angle and the widest, sheared, far away; then
// `random` fits.
std::vector<GoldenCascade> golden_cascades(int random, SetupGenerator& generator);

}  // namespace penumbra::parameters
