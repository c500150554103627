#include <algorithm>

#include "lint/program_rules.h"
#include "lint/rule.h"

namespace penumbra::lint {

namespace {

constexpr const char* rule = "property-type";
constexpr std::uint64_t bytes_of_number = 4;

bool has_components(const MaterialProperty& property) {
  return property.type == "Color" || property.type == "Vector";
}

// Returns whether the stage declares the property's variable as one number.
bool takes_one(const PassStage& stage, const MaterialProperty& property) {
  return std::any_of(stage.buffers.begin(), stage.buffers.end(), [&](const ConstantBuffer& buffer) {
    return std::any_of(buffer.members.begin(), buffer.members.end(), [&](const ConstantBufferMember& member) {
      return member.name == property.name && member.size == bytes_of_number;
    });
  });
}

}  // namespace

std::vector<hlsl::Diagnostic> property_type_findings(const ShaderToLint& shader) {
  std::vector<hlsl::Diagnostic> findings;
  for (const MaterialProperty& property : shader.properties) {
    const auto stage = std::find_if(shader.stages.begin(), shader.stages.end(),
                                    [&](const PassStage& any) { return takes_one(any, property); });
    if (!has_components(property) || stage == shader.stages.end()) continue;
    findings.push_back(
        {shader.file,
         property.line,
         property.column,
         find_rule(rule)->severity,
         "property '" + property.name + "' is a " + property.type + ", and pass '" + stage->pass +
             "' declares it as one number, which gets its first component: declare it float4, or "
             "make the property a Float",
         {},
         rule});
  }
  return findings;
}

}  // namespace penumbra::lint
