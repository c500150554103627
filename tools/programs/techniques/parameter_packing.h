// The places of a parameter struct's fields in the vectors that the shaders' uniforms hold.
//
// Fields are packed in order, each in the next free components; one that does not fit into the rest of a
// vector begins the next, as in HLSL's constant buffers. Whole numbers are stored as floats, exact to 2^24.
// The uniforms are float4 _Penumbra<Struct>0, 1, ...; the emitted HLSL unpacks them, the emitted C# packs
// them.
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

std::vector<PackedPlace> packed_places(const ParameterStruct& parameters);  // places of the fields, in order
std::size_t vector_count(const ParameterStruct& parameters);
std::string uniform_name(const ParameterStruct& parameters, std::size_t vector);  // _PenumbraMaskParameters0

// Components that no field has are 0. Throws std::out_of_range where a field has no value.
std::vector<std::array<float, 4>> packed(const ParameterStruct& parameters,
                                         const std::map<std::string, std::vector<double>>& values);

}  // namespace penumbra::techniques
