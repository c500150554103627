// Runs a small compute shader on the device, with or without the preparation stage.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "shaders/cross_compile.h"

namespace penumbra::preparation {

// `body` stands after `StructuredBuffer<float> In; RWStructuredBuffer<float> Out;` and defines Main(), which
// runs once. `uniforms`: the floats of each other buffer, by its name. Throws with the messages when it
// does not compile or the device complains.
struct Execution {
  std::string body;
  std::vector<float> in;
  std::map<std::string, std::vector<float>> uniforms{};
  std::size_t outputs = 8;
};

std::vector<float> run_prepared(const Execution& execution);
std::vector<float> run_unprepared(const Execution& execution);

// Prepares the shader, then runs it by way of the target's text (emitted.h).
std::vector<float> run_through(const Execution& execution, shaders::Target target);

// From FXC's bytecode, and by way of the target's text that is made from it.
std::vector<float> run_by_fxc(const Execution& execution);
std::vector<float> run_by_fxc_through(const Execution& execution, shaders::Target target);

}  // namespace penumbra::preparation
