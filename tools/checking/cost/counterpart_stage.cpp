#include "cost/counterpart_stage.h"

#include <algorithm>

#include "shaders/pipeline_interface.h"

namespace penumbra::cost {
namespace {

using shaders::ScalarType;
using shaders::StageLocation;

// Variables that share a location become one that covers them.
std::vector<StageLocation> whole_locations(const std::vector<StageLocation>& variables) {
  std::vector<StageLocation> locations;
  for (StageLocation variable : variables) {
    variable.components = std::min(4U, variable.component + variable.components);
    variable.component = 0;
    if (!locations.empty() && locations.back().location == variable.location) {
      locations.back().components = std::max(locations.back().components, variable.components);
    } else {
      locations.push_back(variable);
    }
  }
  return locations;
}

std::string type_of(const StageLocation& at) {
  const char* scalar = at.type == ScalarType::float32 ? "float"
                       : at.type == ScalarType::int32 ? "int"
                                                      : "uint";
  return at.components == 1 ? scalar : scalar + std::to_string(at.components);
}

std::string name_of(const StageLocation& at) {
  return "at" + std::to_string(at.location);
}

// Returns "[[vk::location(L)]] TYPE NAME : SEMANTIC": HLSL requires a semantic although only the location
// matters.
std::string declaration(const StageLocation& at, std::size_t location, const std::string& semantic) {
  const char* flat = at.type == ScalarType::float32 ? "" : "nointerpolation ";
  return "[[vk::location(" + std::to_string(location) + ")]] " + flat + type_of(at) + " " + name_of(at) +
         " : " + semantic + std::to_string(location);
}

}  // namespace

std::string vertex_stage_for(const std::vector<std::uint32_t>& fragment, const std::string& entry) {
  const std::vector<StageLocation> passed =
      whole_locations(shaders::pipeline_interface(fragment, entry).inputs);
  std::string members = "    float4 position : SV_Position;\n";
  std::string parameters = "[[vk::location(0)]] float4 position : ATTRIBUTE0";
  std::string body = "    passed.position = position;\n";
  std::size_t attribute = 1;  // attributes are dense, whatever the locations that the fragment shader reads
  for (const StageLocation& at : passed) {
    members += "    " + declaration(at, at.location, "PASSED") + ";\n";
    parameters += ",\n            " + declaration(at, attribute++, "ATTRIBUTE");
    body += "    passed." + name_of(at) + " = " + name_of(at) + ";\n";
  }
  return "struct Passed\n{\n" + members + "};\n\nPassed Main(" + parameters + ")\n{\n    Passed passed;\n" +
         body + "    return passed;\n}\n";
}

std::string fragment_stage_for(const std::vector<std::uint32_t>& vertex, const std::string& entry) {
  const std::vector<StageLocation> passed =
      whole_locations(shaders::pipeline_interface(vertex, entry).outputs);
  std::string parameters = "float4 position : SV_Position";
  std::string body = "    float4 sum = 0;\n";
  for (const StageLocation& at : passed) {
    parameters += ",\n            " + declaration(at, at.location, "PASSED");
    const std::string swizzle = std::string("xyzw").substr(0, at.components);
    StageLocation as_float = at;
    as_float.type = ScalarType::float32;
    body += "    sum." + swizzle + " += (" + type_of(as_float) + ")" + name_of(at) + ";\n";
  }
  return "float4 Main(" + parameters + ") : SV_Target\n{\n" + body + "    return sum;\n}\n";
}

}  // namespace penumbra::cost
