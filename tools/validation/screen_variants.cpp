#include "validation/screen_variants.h"

#include <algorithm>

#include "shaders/package_shader.h"
#include "shaders/technique_chain.h"

namespace penumbra::validation {

std::vector<SourceVariant> screen_variants(const ValidationRequest& request,
                                           const shaders::Technique& technique,
                                           const std::vector<std::string>& keywords) {
  const std::filesystem::path file =
      request.techniques->file.parent_path().parent_path() / "Shaders" / "PenumbraShadows.shader";
  const shaders::PackageShader shader(file.lexically_normal(), request.package_roots);
  const bool reversed_z = std::find(keywords.begin(), keywords.end(), "UNITY_REVERSED_Z") != keywords.end();
  std::vector<std::string> on = shaders::chain_keywords(technique);
  on.insert(on.begin(), keywords.begin(), keywords.end());
  std::vector<SourceVariant> variants;
  for (const shaders::TechniquePass& pass : technique.chain) {
    for (const std::string& name : shaders::pass_kind(pass.kind).shader_passes) {
      for (const hlsl::Stage stage : {hlsl::Stage::vertex, hlsl::Stage::fragment}) {
        SourceVariant variant;
        variant.technique = &technique;
        variant.unit.technique = technique.name;
        variant.unit.keywords = keywords;
        variant.unit.file = file.lexically_normal().string();
        variant.unit.pass = name;
        variant.unit.lint = request.lint;
        variant.unit.compile = shader.request(name, stage, on, reversed_z);
        variant.unit.compile.defines.insert(variant.unit.compile.defines.end(), request.defines.begin(),
                                            request.defines.end());
        variants.push_back(std::move(variant));
      }
    }
  }
  return variants;
}

}  // namespace penumbra::validation
