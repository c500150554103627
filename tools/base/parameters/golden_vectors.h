// Inputs and expected results of the per-frame mathematics, for testing other implementations (C# in the
// package) value by value.
//
// Inputs are exact floats; results are computed from them in double or long double and rounded to float once.
// Every number is printed with the fewest digits that read back to the same float.
#pragma once

#include <cstdint>
#include <string>

namespace penumbra::parameters {

// The JSON has one list for each kind: angles, atlases, cascades, projections (bias), uniforms, cameras. Each
// has its awkward cases and, where cases are random, `count` of them. The same count and seed give the same
// bytes.
std::string golden_vectors_json(int count, std::uint32_t seed);

}  // namespace penumbra::parameters
