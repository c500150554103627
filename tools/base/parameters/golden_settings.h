// Settings for golden vectors: the awkward ones first, then random ones. All hold floats exactly.
#pragma once

#include <vector>

#include "parameters/random_setup.h"
#include "parameters/shader_uniforms.h"

namespace penumbra::parameters {

// Returns settings outside of both ends of every range, and the angles at which another of them decides; then
// `random` ones in range.
std::vector<SoftShadowParameters> golden_settings(int random, SetupGenerator& generator);

SoftShadowParameters random_settings(SetupGenerator& generator);

// These return the nearest float, of one number and of every field.
double as_float(double value);
SoftShadowParameters as_floats(SoftShadowParameters parameters);

}  // namespace penumbra::parameters
