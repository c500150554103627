#include "cost/cost_modules.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "cost/module_compiler.h"
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

struct Source {
  shaders::CompileRequest compile;
  std::string file;
  CostVariant variant;
};

std::string file_in_package(const shaders::Technique& technique) {
  return technique.screen ? "Shaders/PenumbraShadows.shader" : "ShaderLibrary/" + technique.resolve().file;
}

// Techniques are per-pixel functions: their cost is that of the fragment shader that calls them, or of each
// pass that runs over the screen, and their file is the library's, without the folder it happens to lie in.
std::vector<Source> sources_of(const CostRequest& request) {
  const validation::ValidationRequest validated = as_validated(request);
  std::vector<Source> sources;
  for (validation::SourceVariant& variant : validation::source_variants(validated)) {
    const shaders::Technique* technique = variant.technique;
    validation::CompileUnit& unit = variant.unit;
    if (technique == nullptr) unit.compile.prepare = true;
    if (technique != nullptr && unit.compile.stage != hlsl::Stage::fragment) continue;
    std::string file = technique == nullptr ? unit.file : file_in_package(*technique);
    sources.push_back({std::move(unit.compile),
                       std::move(file),
                       {technique == nullptr ? "" : technique->name, std::move(unit.keywords)}});
  }
  return sources;
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
  const std::vector<Source> sources = sources_of(request);
  std::vector<shaders::CompileRequest> requests;
  for (const Source& source : sources) requests.push_back(source.compile);
  const std::vector<CompiledModule> compiled =
      compile_all(requests, {request.compiler, request.jobs, request.compiler_limits});

  CostModules made;
  std::map<std::tuple<std::string, hlsl::Stage, std::string, std::vector<std::uint32_t>>, std::size_t> places;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto& [compile, file, variant] = sources[i];
    const std::vector<std::uint32_t>& spirv = compiled[i].spirv;
    if (spirv.empty()) {
      add_new(made.diagnostics, compiled[i].diagnostics);
      continue;
    }
    const auto [place, is_new] =
        places.try_emplace({file, compile.stage, compile.entry, spirv}, made.modules.size());
    if (is_new) made.modules.push_back({file, compile.entry, compile.stage, {}, spirv, compiled[i].counts});
    made.modules[place->second].variants.push_back(variant);
  }
  return made;
}

}  // namespace penumbra::cost
