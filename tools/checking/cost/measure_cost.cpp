#include "cost/measure_cost.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <tuple>

#include "cost/families.h"
#include "cost/module_compiler.h"
#include "fxc/bytecode.h"
#include "fxc/fxc.h"
#include "input/input_error.h"
#include "platform/interrupt.h"
#include "platform/thread_group.h"
#include "shaders/compile.h"
#include "validation/shader_sources.h"
#include "validation/source_variants.h"
#include "validation/spirv_target.h"

namespace penumbra::cost {
namespace {

// The distinct modules of a request, before any driver sees them.
struct CostModule {
  std::string file;
  std::string entry;
  hlsl::Stage stage = hlsl::Stage::fragment;
  std::vector<CostVariant> variants;
  CompiledModule compiled;  // the module without diagnostics
};

struct CostModules {
  std::vector<CostModule> modules;  // modules in the order of the request, by their first variant
  std::vector<hlsl::Diagnostic> diagnostics;
};

// Returns the name that `penumbra validate` gives the target.
std::string target_of(Compiler compiler) {
  return std::string(compiler == Compiler::fxc ? validation::fxc_target
                                               : validation::spirv_targets().front());
}

validation::ValidationRequest as_validated(const CostRequest& request, Compiler compiler) {
  validation::ValidationRequest validated;
  validated.targets = {target_of(compiler)};
  validated.techniques = request.techniques;
  validated.defines = request.defines;
  validated.package_roots = request.package_roots;
  validated.include_directories = request.include_directories;
  return validated;
}

struct Source {
  shaders::CompileRequest compile;
  std::string file;
  CostVariant variant;
};

// The path is relative to the folder in which the package is installed.
std::string file_in_package(const techniques::Technique& technique, const std::string& program) {
  for (const techniques::GraphPass& pass : technique.graph.passes)
    if (!program.empty() && pass.program == program) return pass.file;
  return technique.file();
}

// The cost of a technique is that of each program of its passes; the cost of a filter is that of the fragment
// shader that calls it.
std::vector<Source> sources_of(const CostRequest& request, Compiler compiler) {
  const validation::ValidationRequest validated = as_validated(request, compiler);
  std::vector<Source> sources;
  for (validation::SourceVariant& variant : validation::source_variants(validated)) {
    validation::CompileUnit& unit = variant.unit;
    const bool kernel = unit.compile.stage == hlsl::Stage::compute && !unit.pass.empty();
    if (unit.compile.stage != hlsl::Stage::fragment && !kernel) continue;
    std::string file = file_in_package(*variant.technique, unit.pass);
    sources.push_back(
        {std::move(unit.compile), std::move(file), {variant.technique->name, std::move(unit.keywords)}});
  }
  return sources;
}

// A pass of a .shader is treated as a file of its own: passes may have entry points of the same name.
std::string file_and_pass(const validation::SourceProgram& program) {
  return program.pass.empty() ? program.file : program.file + ": " + program.pass;
}

bool is_measured(hlsl::Stage stage) {
  return stage == hlsl::Stage::vertex || stage == hlsl::Stage::fragment || stage == hlsl::Stage::compute;
}

std::vector<hlsl::Diagnostic> errors_of(std::vector<hlsl::Diagnostic> said) {
  std::erase_if(said, [](const hlsl::Diagnostic& one) { return one.severity != hlsl::Severity::error; });
  return said;
}

// Adds those of `more` that are not there yet: two variants, or two compilers, may refuse a file for the same
// reason.
void add_new(std::vector<hlsl::Diagnostic>& said, const std::vector<hlsl::Diagnostic>& more) {
  for (const hlsl::Diagnostic& diagnostic : more) {
    const bool known = std::any_of(said.begin(), said.end(), [&](const hlsl::Diagnostic& other) {
      return hlsl::format(other) == hlsl::format(diagnostic);
    });
    if (!known) said.push_back(diagnostic);
  }
}

// The file is compiled as `penumbra validate` compiles it for Vulkan or Direct3D 11: with its pragmas and
// Unity's macros. Without keyword sets, a program of a .shader or .compute is its first variant, the one with
// the fewest keywords.
void add_file(const CostRequest& request, const ShaderFile& shader, Compiler compiler,
              std::vector<Source>& sources, std::vector<hlsl::Diagnostic>& said) {
  validation::SourceOptions options;
  options.platforms = validation::platform_targets({target_of(compiler)}, {});
  options.roots.packages = request.package_roots;
  options.roots.directories = request.include_directories;
  options.defines = request.defines;
  options.entries = {{shader.entry, shader.stage}};
  validation::ShaderSources file(std::move(options));
  file.add({shader.file, shader.file.string(), true});
  for (const validation::VariantRecord& record : file.records()) {
    add_new(said, errors_of(record.diagnostics));
    if (!record.reason.empty())
      said.push_back({record.file, 0, 0, hlsl::Severity::error, "not measured: " + record.reason, {}});
  }
  for (const validation::SourceProgram& program : file.programs()) {
    for (std::size_t i = 0; i < program.entries.size() + program.kernels.size(); ++i) {
      const hlsl::Stage stage = i < program.entries.size() ? program.entries[i].second : hlsl::Stage::compute;
      if (!is_measured(stage)) {
        said.push_back({program.file,
                        program.line,
                        program.column,
                        hlsl::Severity::warning,
                        std::string("the ") + hlsl::stage_name(stage) + " program '" +
                            program.entries[i].first +
                            "' is not measured: only vertex, fragment and compute programs are",
                        {}});
        continue;
      }
      std::vector<variants::Keywords> sets = shader.keyword_sets;
      if (sets.empty()) sets.push_back(program.space->variants(stage).at(0));
      for (const variants::Keywords& keywords : sets)
        sources.push_back(
            {file.entry_unit(program, i, keywords).compile, file_and_pass(program), {"", keywords}});
    }
  }
}

CostModules compile_modules(const CostRequest& request, Compiler compiler) {
  CostModules made;
  std::vector<Source> sources = sources_of(request, compiler);
  std::vector<hlsl::Diagnostic> said;
  for (const ShaderFile& shader : request.files) add_file(request, shader, compiler, sources, said);
  add_new(made.diagnostics, said);
  std::vector<shaders::CompileRequest> requests;
  for (const Source& source : sources) requests.push_back(source.compile);
  std::vector<CompiledModule> compiled =
      compile_all(requests, compiler, {request.compiler, request.jobs, request.compiler_limits});

  using Code = std::pair<std::vector<std::uint32_t>, std::string>;
  std::map<std::tuple<std::string, hlsl::Stage, std::string, Code>, std::size_t> places;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto& [compile, file, variant] = sources[i];
    if (!compiled[i].is_compiled()) {
      add_new(made.diagnostics, errors_of(compiled[i].diagnostics));
      continue;
    }
    compiled[i].diagnostics.clear();
    const auto [place, is_new] = places.try_emplace(
        {file, compile.stage, compile.entry, {compiled[i].spirv, compiled[i].bytecode}}, made.modules.size());
    if (is_new) made.modules.push_back({file, compile.entry, compile.stage, {}, std::move(compiled[i])});
    made.modules[place->second].variants.push_back(variant);
  }
  return made;
}

constexpr std::size_t kLargestBatch = 12;

std::vector<CostRow> empty_rows(const std::string& family, const std::vector<CostModule>& modules) {
  std::vector<CostRow> rows;
  rows.reserve(modules.size());
  for (const CostModule& module : modules)
    rows.push_back({family, module.file, module.entry, hlsl::stage_name(module.stage), module.variants, {}});
  return rows;
}

Measurement measurement_of(const fxc::BytecodeCost& cost) {
  Measurement measurement;
  measurement.statistics = {
      {"Instructions", cost.instructions},       {"Arithmetic instructions", cost.arithmetic},
      {"Texture instructions", cost.textures},   {"Dynamic branches", cost.branches},
      {"Temporary registers", cost.temporaries}, {"LDS size", cost.group_shared}};
  measurement.figures = figures_of(measurement.statistics);
  return measurement;
}

bool is_direct3d(const std::string& family) {
  return family == direct3d_family.name;
}

// Returns the rows of RADV's families, in the order of the request.
std::vector<CostRow> measured_by_radv(const CostRequest& request, const std::vector<std::string>& families,
                                      const std::vector<CostModule>& modules) {
  std::vector<CostRow> rows;
  for (const std::string& family : families)
    for (CostRow& row : empty_rows(family, modules)) rows.push_back(std::move(row));
  // Modules of one family run in batches, because the driver takes longer to start than most of them to
  // compile.
  const std::size_t largest = std::clamp<std::size_t>(rows.size() / request.jobs, 1, kLargestBatch);
  std::vector<std::vector<std::size_t>> batches;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i % modules.size() == 0 || batches.back().size() == largest) batches.emplace_back();
    batches.back().push_back(i);
  }
  std::mutex mutex;
  std::size_t done = 0;
  platform::run_all(batches.size(), static_cast<int>(request.jobs), [&](std::size_t batch) {
    platform::throw_if_interrupted();
    std::vector<ModuleToMeasure> measured;
    for (const std::size_t i : batches[batch]) {
      const CostModule& module = modules[i % modules.size()];
      measured.push_back({module.compiled.spirv, module.stage, module.entry});
    }
    const std::string& family = rows[batches[batch].front()].family;
    std::vector<Measurement> results = measure({family, request.worker, request.time_limit}, measured);
    const std::lock_guard<std::mutex> lock(mutex);
    for (std::size_t k = 0; k < results.size(); ++k) rows[batches[batch][k]].measured = std::move(results[k]);
    done += results.size();
    if (request.progress) request.progress(done, rows.size());
  });
  return rows;
}

std::vector<CostRow> counted_in_bytecode(const std::vector<CostModule>& modules) {
  std::vector<CostRow> rows = empty_rows(direct3d_family.name, modules);
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i].measured = measurement_of(modules[i].compiled.direct3d);
  return rows;
}

}  // namespace

std::string driver_of(const std::vector<RadvFamily>& families) {
  for (const RadvFamily& family : families)
    if (!is_direct3d(family.name)) return family.driver;
  return families.empty() ? "" : families.front().driver;
}

std::vector<RadvFamily> open_families(const CostRequest& request) {
  std::vector<RadvFamily> families;
  for (const std::string& family : request.families)
    families.push_back(is_direct3d(family) ? RadvFamily{family, direct3d_family.architecture,
                                                        fxc::name_of(fxc::require_fxc())}
                                           : open_family({family, request.worker, request.time_limit}));
  return families;
}

CostOutcome measure_cost(const CostRequest& request) {
  CostOutcome outcome;
  outcome.report.families = open_families(request);
  outcome.report.driver = driver_of(outcome.report.families);
  std::vector<std::string> of_radv = request.families;
  std::erase_if(of_radv, is_direct3d);
  // Without modules of glslang, FXC is the compiler, too.
  outcome.report.compiler = of_radv.empty() ? outcome.report.driver : shaders::compiler_version();
  std::vector<CostRow> radv;
  if (!of_radv.empty()) {
    CostModules compiled = compile_modules(request, Compiler::glslang);
    outcome.diagnostics = std::move(compiled.diagnostics);
    radv = measured_by_radv(request, of_radv, compiled.modules);
  }
  std::vector<CostRow> direct3d;
  if (of_radv.size() != request.families.size()) {
    CostModules compiled = compile_modules(request, Compiler::fxc);
    add_new(outcome.diagnostics, compiled.diagnostics);
    direct3d = counted_in_bytecode(compiled.modules);
  }
  for (const RadvFamily& family : outcome.report.families)
    for (const CostRow& row : is_direct3d(family.name) ? direct3d : radv)
      if (row.family == family.name) outcome.report.rows.push_back(row);
  return outcome;
}

}  // namespace penumbra::cost
