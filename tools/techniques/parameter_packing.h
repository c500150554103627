// How a parameter struct lies in the vectors that the shaders' uniform holds.
//
// Fields in order, each in the next free components; one that does not fit into what is left of a vector
// begins the next, as in HLSL's constant buffers. Whole numbers are stored as floats, exact to 2^24. The
// uniform is float4 _Penumbra<Struct>[vector_count]; the emitted HLSL unpacks it, the emitted C# packs it.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "techniques/parameter_struct.h"

namespace penumbra::techniques {

struct PackedPlace {
  std::size_t vector = 0;
  std::size_t component = 0;
};

std::vector<PackedPlace> packed_places(const ParameterStruct& parameters);  // of the fields, in order
std::size_t vector_count(const ParameterStruct& parameters);
std::string uniform_name(const ParameterStruct& parameters);  // _PenumbraMaskParameters

// Components that no field has are 0. Throws std::out_of_range where a field has no value.
std::vector<std::array<float, 4>> packed(const ParameterStruct& parameters,
                                         const std::map<std::string, std::vector<double>>& values);

}  // namespace penumbra::techniques
