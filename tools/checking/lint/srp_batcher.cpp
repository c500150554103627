#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "lint/program_rules.h"
#include "lint/rule.h"

namespace penumbra::lint {

namespace {

constexpr const char* rule = "srp-batcher";
constexpr const char* material_buffer = "UnityPerMaterial";

hlsl::Diagnostic finding(const ShaderToLint& shader, const MaterialProperty& at, std::string message) {
  return {shader.file, at.line, at.column, find_rule(rule)->severity, std::move(message), {}, rule};
}

const ConstantBuffer* find_buffer(const PassStage& stage, const std::string& name) {
  const auto found = std::find_if(stage.buffers.begin(), stage.buffers.end(),
                                  [&](const ConstantBuffer& buffer) { return buffer.name == name; });
  return found == stage.buffers.end() ? nullptr : &*found;
}

std::string stage_of(const PassStage& stage) {
  std::string text = "pass '" + stage.pass + "' (" + hlsl::stage_name(stage.stage);
  for (const std::string& keyword : stage.keywords) text += " " + keyword;
  return text + ")";
}

// Reports the buffer that contains a property, if it is not UnityPerMaterial.
std::optional<hlsl::Diagnostic> misplaced(const ShaderToLint& shader, const MaterialProperty& property) {
  for (const PassStage& stage : shader.stages)
    for (const ConstantBuffer& buffer : stage.buffers) {
      if (buffer.name == material_buffer) continue;
      const bool holds = std::any_of(buffer.members.begin(), buffer.members.end(),
                                     [&](const auto& member) { return member.name == property.name; });
      if (!holds) continue;
      const std::string where = buffer.name == "$Global" ? "outside of every constant buffer"
                                                         : "in constant buffer '" + buffer.name + "'";
      return finding(shader, property,
                     "material property '" + property.name + "' is declared " + where + " in " +
                         stage_of(stage) + "; the SRP Batcher needs it in UnityPerMaterial");
    }
  return std::nullopt;
}

std::string difference(const ConstantBuffer& first, const ConstantBuffer& other) {
  for (std::size_t i = 0; i < std::max(first.members.size(), other.members.size()); ++i) {
    if (i >= first.members.size()) return "'" + other.members[i].name + "' is only in the second";
    if (i >= other.members.size()) return "'" + first.members[i].name + "' is only in the first";
    if (first.members[i] == other.members[i]) continue;
    const auto told = [](const ConstantBufferMember& member) {
      return "'" + member.name + "' at byte " + std::to_string(member.offset) + " of " +
             std::to_string(member.size) + " bytes";
    };
    return told(first.members[i]) + " against " + told(other.members[i]);
  }
  return "";
}

}  // namespace

std::vector<hlsl::Diagnostic> srp_batcher_findings(const ShaderToLint& shader) {
  std::vector<hlsl::Diagnostic> findings;
  for (const MaterialProperty& property : shader.properties)
    if (std::optional<hlsl::Diagnostic> found = misplaced(shader, property))
      findings.push_back(std::move(*found));
  const PassStage* reference = nullptr;
  std::set<std::string> told;  // passes
  for (const PassStage& stage : shader.stages) {
    const ConstantBuffer* layout = find_buffer(stage, material_buffer);
    if (layout == nullptr) continue;
    if (reference == nullptr) reference = &stage;
    const ConstantBuffer& expected = *find_buffer(*reference, material_buffer);
    if (layout->members == expected.members || !told.insert(stage.pass).second) continue;
    findings.push_back(finding(shader, {},
                               "UnityPerMaterial differs between " + stage_of(*reference) + " and " +
                                   stage_of(stage) + ": " + difference(expected, *layout) +
                                   "; the SRP Batcher needs one layout in all passes"));
  }
  return findings;
}

}  // namespace penumbra::lint
