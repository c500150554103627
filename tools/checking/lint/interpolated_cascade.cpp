#include "lint/interpolated_cascade.h"

#include "lint/rule.h"
#include "spirv/code.h"

namespace penumbra::lint {
namespace {

bool is_sampling(spv::Op op) {
  return op >= spv::OpImageSampleImplicitLod && op <= spv::OpImageDrefGather;
}

// Returns the variable that a pointer points into.
spirv::Id base_of(const spirv::Code& code, spirv::Id pointer) {
  const spirv::Instruction* chain = code.definition(pointer);
  while (chain != nullptr && chain->op == spv::OpAccessChain) {
    pointer = chain->operands[0];
    chain = code.definition(pointer);
  }
  return pointer;
}

// Returns whether the pointer leads to URP's spheres of cascades, by which a cascade is chosen.
bool is_split_sphere(const spirv::Code& code, const spirv::Instruction& pointer) {
  if (pointer.op != spv::OpAccessChain || pointer.operands.size() < 2) return false;
  const spirv::Instruction* base = code.definition(pointer.operands[0]);
  const std::optional<std::int64_t> member = code.integer(pointer.operands[1]);
  return member && base != nullptr &&
         code.member_name(code.pointee(base->type), static_cast<std::uint32_t>(*member))
             .starts_with("_CascadeShadowSplitSphere");
}

// Returns whether the value is calculated from the cascade of the point alone: where a shadow map is sampled
// for it, it is light and no coordinate.
bool is_of_cascade(const spirv::Code& code, spirv::Id value) {
  bool found = false;
  std::set<spirv::Id> seen;
  std::vector<spirv::Id> waiting{value};
  while (!waiting.empty()) {
    const spirv::Instruction* at = code.definition(waiting.back());
    waiting.pop_back();
    if (at == nullptr || !seen.insert(at->result).second) continue;
    if (is_sampling(at->op)) return false;
    found = found || is_split_sphere(code, *at);
    for (const spirv::Id id : code.ids(*at)) waiting.push_back(id);
  }
  return found;
}

}  // namespace

std::set<std::uint32_t> outputs_of_cascade(const std::vector<std::uint32_t>& spirv) {
  const spirv::Code code(spirv);
  std::set<std::uint32_t> locations;
  for (const spirv::Instruction& store : code.instructions()) {
    if (store.op != spv::OpStore) continue;
    const spirv::Id output = base_of(code, store.operands[0]);
    const std::optional<std::uint32_t> location = code.decoration(output, spv::DecorationLocation);
    const spirv::Instruction* variable = code.definition(output);
    if (location && variable != nullptr && code.storage_class(variable->type) == spv::StorageClassOutput &&
        is_of_cascade(code, store.operands[1]))
      locations.insert(*location);
  }
  return locations;
}

hlsl::Diagnostic interpolated_cascade_finding(const hlsl::TokenPlace& place, const std::string& semantic,
                                              const std::string& vertex_program) {
  constexpr const char* rule = "interpolated-cascade";
  return {place.file,
          place.line,
          place.column,
          find_rule(rule)->severity,
          "'" + semantic + "' is a shadow coordinate that " + vertex_program +
              " calculates with cascades, and between vertices of two cascades it is in neither: call "
              "TransformWorldToShadowCoord() in the fragment program, and read the interpolated coordinate "
              "only where "
              "REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR is defined",
          {},
          rule};
}

}  // namespace penumbra::lint
