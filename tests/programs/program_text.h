// A program as HLSL. The functions of several programs stand in one shader, with a call of each in Main.
#pragma once

#include <string>
#include <vector>

#include "programs/program.h"

namespace penumbra::programs {

// The text of a compute shader of one group of one thread for each set of inputs: In holds kInputs words for
// each, Out kOutputs words for each program of each set.
std::string shader_text(const std::vector<const Program*>& programs);

std::string program_text(const Program& program);

}  // namespace penumbra::programs
