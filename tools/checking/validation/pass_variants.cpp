#include "validation/pass_variants.h"

#include <algorithm>
#include <map>
#include <utility>

#include "shaders/package_shader.h"

namespace penumbra::validation {

std::vector<SourceVariant> pass_variants(const ValidationRequest& request,
                                         const techniques::Technique& technique,
                                         const std::vector<std::string>& keywords) {
  const bool reversed_z = std::find(keywords.begin(), keywords.end(), "UNITY_REVERSED_Z") != keywords.end();
  std::vector<std::string> on = keywords;
  on.insert(on.end(), technique.graph.keywords.begin(), technique.graph.keywords.end());
  std::map<std::filesystem::path, shaders::PackageShader> parsed;
  const auto variant_of = [&](const techniques::GraphPass& pass, shaders::CompileRequest compile) {
    SourceVariant variant;
    variant.technique = &technique;
    variant.unit.technique = technique.name;
    variant.unit.keywords = keywords;
    variant.unit.file = (request.techniques->package / pass.file).lexically_normal().string();
    variant.unit.pass = pass.program;
    variant.unit.lint = request.lint;
    variant.unit.compile = std::move(compile);
    variant.unit.compile.defines.insert(variant.unit.compile.defines.end(), request.defines.begin(),
                                        request.defines.end());
    return variant;
  };
  std::vector<SourceVariant> variants;
  for (const techniques::GraphPass& pass : technique.graph.passes) {
    if (pass.kind == techniques::PassKind::filter) continue;
    const std::filesystem::path file = (request.techniques->package / pass.file).lexically_normal();
    if (pass.kind == techniques::PassKind::compute) {
      variants.push_back(variant_of(
          pass, shaders::kernel_request(file, pass.program, on, reversed_z, request.package_roots)));
      continue;
    }
    const shaders::PackageShader& shader =
        parsed.try_emplace(file, file, request.package_roots).first->second;
    std::vector<std::vector<std::string>> keyword_sets{on};
    if (pass.kind == techniques::PassKind::casters &&
        !shader.declared(pass.program, {techniques::alpha_test_keyword}).empty()) {
      keyword_sets.push_back(on);
      keyword_sets.back().emplace_back(techniques::alpha_test_keyword);
    }
    for (std::size_t i = 0; i < keyword_sets.size(); ++i)
      for (const hlsl::Stage stage : {hlsl::Stage::vertex, hlsl::Stage::fragment}) {
        variants.push_back(
            variant_of(pass, shader.request(pass.program, stage, keyword_sets[i], reversed_z)));
        if (i > 0) variants.back().unit.keywords.emplace_back(techniques::alpha_test_keyword);
      }
  }
  return variants;
}

}  // namespace penumbra::validation
