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
#include <optional>
#include <string>
#include <vector>

namespace penumbra::techniques {

// The parameters of a technique's passes: structs of numbers, declared in its manifest.
struct ParameterRange {
  double smallest = 0.0;
  double largest = 0.0;
};

// A field of a parameter struct; `unit` and `doc` go into the emitted HLSL.
struct ParameterField {
  std::string name;
  std::string type;  // float, float2, float4 or int
  std::string unit;
  std::string doc;
  std::optional<ParameterRange> range;  // if absent, any finite value
  std::vector<double> otherwise;        // used where a technique gives no value; if empty, it has to
};

struct ParameterStruct {
  std::string name;
  std::string doc;
  std::vector<ParameterField> fields;
  std::string manifest{};  // the declaring file, relative to the package's folder if it lies in it
};

std::size_t component_count(const ParameterField& field);  // 1, 2 or 4

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
