#include "validation/screen_variants.h"

#include <algorithm>
#include <map>

#include "shaders/package_shader.h"

namespace penumbra::validation {

std::vector<SourceVariant> screen_variants(const ValidationRequest& request,
                                           const techniques::Technique& technique,
                                           const std::vector<std::string>& keywords) {
  const bool reversed_z = std::find(keywords.begin(), keywords.end(), "UNITY_REVERSED_Z") != keywords.end();
  std::vector<std::string> on = keywords;
  on.insert(on.end(), technique.graph.keywords.begin(), technique.graph.keywords.end());
  std::map<std::filesystem::path, shaders::PackageShader> parsed;
  std::vector<SourceVariant> variants;
  for (const techniques::GraphPass& pass : technique.graph.passes) {
    const std::filesystem::path file = (request.techniques->package / pass.file).lexically_normal();
    const shaders::PackageShader& shader =
        parsed.try_emplace(file, file, request.package_roots).first->second;
    for (const hlsl::Stage stage : {hlsl::Stage::vertex, hlsl::Stage::fragment}) {
      SourceVariant variant;
      variant.technique = &technique;
      variant.unit.technique = technique.name;
      variant.unit.keywords = keywords;
      variant.unit.file = file.string();
      variant.unit.pass = pass.program;
      variant.unit.lint = request.lint;
      variant.unit.compile = shader.request(pass.program, stage, on, reversed_z);
      variant.unit.compile.defines.insert(variant.unit.compile.defines.end(), request.defines.begin(),
                                          request.defines.end());
      variants.push_back(std::move(variant));
    }
  }
  return variants;
}

}  // namespace penumbra::validation
