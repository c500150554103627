// The parameters of a technique's passes: structs of numbers, declared in its manifest.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace penumbra::techniques {

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

}  // namespace penumbra::techniques
