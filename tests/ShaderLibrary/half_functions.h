// The library's functions that are computed in 16-bit half, and the values that scenes give them.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {

// A result's unit, and the largest difference that is accepted of it.
struct Quantity {
  const char* unit;
  double accepted;
  bool turns = false;  // 0 and 1 are the same
};

using Inputs = std::function<Case(Random&)>;  // makes the inputs of one case

struct HalfFunction {
  std::string function;  // the name on the page
  Quantity quantity;
  CoreFunction called;
  Inputs inputs;

  friend void PrintTo(const HalfFunction& tested, std::ostream* out) { *out << tested.function; }
};

std::vector<HalfFunction> half_functions();

}  // namespace penumbra::shader_library_tests
