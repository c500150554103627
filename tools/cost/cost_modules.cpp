#include "cost/cost_modules.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "cost/worker_threads.h"
#include "input/input_error.h"
#include "validation/source_variants.h"

namespace penumbra::cost {
namespace {

validation::ValidationRequest as_validated(const CostRequest& request) {
  validation::ValidationRequest validated;
  validated.techniques = request.techniques;
  validated.defines = request.defines;
  validated.package_roots = request.package_roots;
  validated.include_directories = request.include_directories;
  for (const ShaderFile& shader : request.files)
    validated.files.push_back({shader.file, shader.entry, shader.stage, shader.keyword_sets});
  return validated;
}

// The library's file without the folder it happens to lie in.
std::string shown_file(const validation::SourceVariant& variant) {
  if (variant.technique == nullptr) return variant.unit.file;
  return "ShaderLibrary/" + variant.technique->chain.back().file;
}

void add_new(std::vector<hlsl::Diagnostic>& said, const std::vector<hlsl::Diagnostic>& more) {
  for (const hlsl::Diagnostic& diagnostic : more) {
    const bool known = std::any_of(said.begin(), said.end(), [&](const hlsl::Diagnostic& other) {
      return hlsl::format(other) == hlsl::format(diagnostic);
    });
    if (diagnostic.severity == hlsl::Severity::error && !known) said.push_back(diagnostic);
  }
}

}  // namespace

CostModules compile_modules(const CostRequest& request) {
  const validation::ValidationRequest validated = as_validated(request);
  std::vector<validation::SourceVariant> variants = validation::source_variants(validated);
  // Techniques are per-pixel functions: their cost is that of the fragment shader that calls them.
  std::erase_if(variants, [](const validation::SourceVariant& variant) {
    return variant.technique != nullptr && variant.unit.compile.stage != hlsl::Stage::fragment;
  });
  std::vector<shaders::CompileResult> compiled(variants.size());
  run_all(variants.size(), request.jobs,
          [&](std::size_t i) { compiled[i] = shaders::compile(variants[i].unit.compile); });

  CostModules made;
  std::map<std::tuple<std::string, hlsl::Stage, std::string, std::vector<std::uint32_t>>, std::size_t> places;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const validation::SourceVariant& variant = variants[i];
    if (compiled[i].spirv.empty()) {
      add_new(made.diagnostics, compiled[i].diagnostics);
      continue;
    }
    const std::string file = shown_file(variant);
    const auto [place, is_new] = places.try_emplace(
        {file, variant.unit.compile.stage, variant.unit.compile.entry, compiled[i].spirv}, made.modules.size());
    if (is_new)
      made.modules.push_back(
          {file, variant.unit.compile.entry, variant.unit.compile.stage, {}, std::move(compiled[i].spirv)});
    made.modules[place->second].variants.push_back(
        {variant.technique == nullptr ? "" : variant.technique->name, variant.unit.keywords});
  }
  return made;
}

}  // namespace penumbra::cost
