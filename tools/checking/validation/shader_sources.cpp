#include "validation/shader_sources.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "hlsl/source_text.h"
#include "input/input_error.h"
#include "project/include_bounds.h"
#include "shaderlab/compute.h"
#include "shaderlab/parse.h"
#include "shaderlab/programs.h"
#include "validation/unit_lint.h"
#include "variants/unity_asset.h"

namespace penumbra::validation {

namespace {

namespace fs = std::filesystem;

// Finds the files that #include_with_pragmas names.
variants::FindIncluded finder(project::IncludeRoots roots, const std::string& file) {
  roots.own.push_back(project::own_tree(file));
  roots.main_folder = fs::path(file).parent_path();
  return [roots = std::move(roots)](const std::string& name,
                                    const std::string& includer) -> std::optional<variants::IncludedText> {
    const project::IncludeSearch found = project::find_include(roots, name, includer);
    if (!found.file) return std::nullopt;
    hlsl::SourceRead source = hlsl::read_source(*found.file);
    if (!source.problem.empty()) return std::nullopt;
    return variants::IncludedText{found.file->string(), std::move(source.text)};
  };
}

std::string pass_label(const shaderlab::Program& program) {
  const std::string_view name = shaderlab::pass_name(program);
  if (!name.empty()) return std::string(name);
  return std::to_string(program.sub_shader_index) + "." + std::to_string(std::max(0, program.pass_index));
}

// Adds the includes that Unity puts before CGPROGRAM code (docs.unity3d.com/Manual/SL-BuiltinIncludes.html),
// in the blank lines before the program's block, so that its lines keep their numbers. A block in the file's
// first lines moves down.
std::string with_implicit_includes(std::string text) {
  std::size_t line = 0;
  for (const char* include :
       {"HLSLSupport.cginc", "UnityShaderVariables.cginc", "UnityShaderUtilities.cginc"}) {
    const std::string directive = "#include \"" + std::string(include) + "\"";
    const std::size_t end = text.find('\n', line);
    const bool blank = end != std::string::npos && text.find_first_not_of(" \t\r", line) >= end;
    text.replace(line, blank ? end - line : 0, directive + (blank ? "" : "\n"));
    line += directive.size() + 1;
  }
  return text;
}

hlsl::Diagnostic no_entry_point(const SourceProgram& program) {
  return {program.file,
          program.line,
          program.column,
          hlsl::Severity::error,
          fs::path(program.file).extension() == ".compute"
              ? "this file names no kernel: add #pragma kernel NAME"
              : "this program names no entry point: add #pragma vertex, #pragma fragment or similar",
          {}};
}

// Unity omits a pass with one stage: "Both vertex and fragment programs must be present in a shader snippet".
std::optional<hlsl::Diagnostic> missing_stage(const SourceProgram& program) {
  const auto has = [&](hlsl::Stage stage) {
    return std::any_of(program.entries.begin(), program.entries.end(),
                       [stage](const auto& entry) { return entry.second == stage; });
  };
  if (!program.is_pass || (has(hlsl::Stage::vertex) && has(hlsl::Stage::fragment))) return std::nullopt;
  const std::string stage =
      hlsl::stage_name(has(hlsl::Stage::vertex) ? hlsl::Stage::fragment : hlsl::Stage::vertex);
  return hlsl::Diagnostic{program.file,
                          program.line,
                          program.column,
                          hlsl::Severity::error,
                          "this program has no " + stage +
                              " stage, and Unity leaves such a pass out: add #pragma " + stage + " NAME",
                          {}};
}

// Returns the guid by which materials name the shader; empty without a .meta file.
std::string guid_of(const fs::path& shader) {
  const hlsl::SourceRead meta = hlsl::read_source(shader.string() + ".meta");
  return meta.problem.empty() ? variants::guid_in(meta.text) : std::string();
}

bool is_stripped(const shaderlab::Program& program, const std::vector<std::string>& passes) {
  const std::string* light_mode = shaderlab::effective_tag(program, "LightMode");
  return std::any_of(passes.begin(), passes.end(), [&](const std::string& pass) {
    return pass == shaderlab::pass_name(program) || (light_mode != nullptr && pass == *light_mode);
  });
}

bool has_attribute(const shaderlab::Property& property, const char* name) {
  return std::any_of(property.attributes.begin(), property.attributes.end(),
                     [name](const shaderlab::Attribute& attribute) { return attribute.name.text == name; });
}

// These are the material's properties: per-renderer ones come from a MaterialPropertyBlock.
std::vector<lint::MaterialProperty> numbers_of(const shaderlab::Shader& shader) {
  std::vector<lint::MaterialProperty> numbers;
  for (const shaderlab::Property& property : shader.properties)
    if (property.type != shaderlab::PropertyType::texture && !has_attribute(property, "PerRendererData"))
      numbers.push_back({property.name.text, property.name.place.line, property.name.place.column,
                         property.type == shaderlab::PropertyType::color    ? "Color"
                         : property.type == shaderlab::PropertyType::vector ? "Vector"
                                                                            : property.type_name});
  return numbers;
}

std::vector<lint::NamedPlace> declared_keywords(const variants::Pragmas& pragmas) {
  std::vector<lint::NamedPlace> declared;
  std::set<std::string> known;
  for (const variants::KeywordSet& set : pragmas.keyword_sets)
    for (const std::string& keyword : variants::keywords_of(set))
      if (known.insert(keyword).second)
        declared.push_back({keyword, set.place.line, set.place.column, set.place.file});
  return declared;
}

// Returns a sample of `most` of the `count` variants: the first, the last, and evenly spaced ones between.
std::vector<std::uint64_t> sampled(std::uint64_t count, std::uint64_t most) {
  std::vector<std::uint64_t> indices;
  const std::uint64_t taken = most == 0 ? count : std::min(count, most);
  for (std::uint64_t i = 0; i < taken; ++i) {
    const bool all = taken == count || taken == 1;
    // Quotient and remainder are multiplied separately, because count * i may overflow.
    const std::uint64_t steps = all ? 1 : taken - 1;
    const std::uint64_t reach = count - 1;
    indices.push_back(all ? i : reach / steps * i + reach % steps * i / steps);
  }
  return indices;
}

std::vector<variants::Keywords> chosen(const variants::VariantList& all, std::uint64_t most) {
  std::vector<variants::Keywords> list;
  for (const std::uint64_t index : sampled(all.count().value(), most)) list.push_back(all.at(index));
  return list;
}

std::string uniforms_of(const std::vector<variants::DynamicKeyword>& keywords) {
  std::string text;
  for (const variants::DynamicKeyword& keyword : keywords) text += "uniform int " + keyword.name + "; ";
  return text;
}

// Returns the location of a message about the entry point as a whole.
hlsl::TokenPlace place_of_entry(const variants::Pragmas& pragmas, const std::string& entry,
                                hlsl::Stage stage) {
  for (const variants::EntryPoint& found : pragmas.entry_points)
    if (found.function == entry && found.stage == stage)
      return {found.place.file, found.place.line, found.place.column};
  for (const variants::Kernel& kernel : pragmas.kernels)
    if (kernel.function == entry && stage == hlsl::Stage::compute)
      return {kernel.place.file, kernel.place.line, kernel.place.column};
  return {};
}

}  // namespace

void ShaderSources::add(const project::ShaderFile& file) {
  const hlsl::SourceRead source = hlsl::read_source(file.path);
  if (!source.problem.empty()) {
    const std::string problem = "cannot be read: " + source.problem;
    if (file.named) throw InputError(file.path.string(), problem);
    say(file.shown, {}, {}, {{file.path.string(), 0, 0, hlsl::Severity::error, problem, {}}});
    return;
  }
  const std::string& text = source.text;
  const std::string extension = file.path.extension().string();
  if (extension == ".shader") {
    add_shader(file, text);
  } else if (extension == ".compute" || extension == ".raytrace") {
    add_compute(file, text);
  } else {
    add_hlsl(file, text);
  }
}

// Records diagnostics of a file as a whole: it fails when one of them is an error.
void ShaderSources::say(const std::string& file, const std::string& shader, const std::string& pass,
                        std::vector<hlsl::Diagnostic> diagnostics) {
  if (diagnostics.empty()) return;
  VariantRecord record;
  record.file = file;
  record.shader = shader;
  record.pass = pass;
  record.target = whole_source;
  record.status = hlsl::has_errors(diagnostics) ? VariantStatus::failed : VariantStatus::passed;
  record.diagnostics = std::move(diagnostics);
  records_.push_back(std::move(record));
}

void ShaderSources::leave_unchecked(const SourceProgram& program, const std::string& reason) {
  VariantRecord record;
  record.file = program.file;
  record.shader = program.shader;
  record.pass = program.pass;
  record.target = whole_source;
  record.status = VariantStatus::unchecked;
  record.reason = reason;
  records_.push_back(std::move(record));
  knows_keywords_ = false;
}

SourceProgram ShaderSources::program_of(const project::ShaderFile& file) const {
  SourceProgram program;
  program.file = file.path.string();
  program.narrowing = options_.narrowing;
  return program;
}

void ShaderSources::add_shader(const project::ShaderFile& file, const std::string& text) {
  const std::string guid = options_.used ? guid_of(file.path) : std::string();
  shaderlab::ParsedShader parsed = shaderlab::parse_shader(text, file.path.string());
  const shaderlab::Shader& shader = parsed.shader;
  say(file.path.string(), shader.name.text, {}, std::move(parsed.diagnostics));
  knows_keywords_ &= parsed.complete;
  if (!parsed.complete) return;
  for (const shaderlab::Program& found : shaderlab::programs(shader)) {
    if (is_stripped(found, options_.narrowing.unused_passes)) {
      knows_keywords_ = false;
      continue;
    }
    SourceProgram program = program_of(file);
    program.shader = shader.name.text;
    program.pass = pass_label(found);
    program.sub_shader = found.sub_shader_index;
    program.line = found.place.line;
    program.column = found.place.column;
    program.is_pass = true;
    program.scriptable_pipeline = shaderlab::effective_tag(found, "RenderPipeline") != nullptr;
    program.properties = numbers_of(shader);
    program.includes_hlsl_support = found.implicit_includes;
    program.text = found.implicit_includes ? with_implicit_includes(found.text) : found.text;
    if (const std::string* mode = shaderlab::effective_tag(found, "LightMode")) program.light_mode = *mode;
    if (options_.used) {
      std::optional<variants::Narrowing> used =
          options_.used->narrow(options_.narrowing, program.shader, guid, program.pass);
      if (!used) {
        leave_unchecked(program, "the log of --used-by names no variant of this pass");
        continue;
      }
      program.narrowing = std::move(*used);
    }
    if (found.language == shaderlab::Language::glsl) {
      leave_unchecked(program, "a GLSLPROGRAM is for OpenGL only and is not compiled here");
    } else if (found.is_surface_shader) {
      leave_unchecked(program, "a surface shader: the Unity editor generates its passes");
    } else if (found.is_ray_tracing) {
      leave_unchecked(program, "a ray tracing program: no target here supports its stages");
    } else {
      add_program(program);
    }
  }
}

void ShaderSources::add_compute(const project::ShaderFile& file, const std::string& text) {
  shaderlab::ComputeKernels kernels = shaderlab::compute_kernels(text, file.path.string());
  const bool broken = hlsl::has_errors(kernels.diagnostics);
  say(file.path.string(), {}, {}, std::move(kernels.diagnostics));
  knows_keywords_ &= !broken;
  if (broken) return;
  SourceProgram program = program_of(file);
  program.text = text;
  add_program(program);
}

void ShaderSources::add_hlsl(const project::ShaderFile& file, const std::string& text) {
  SourceProgram program = program_of(file);
  program.text = text;
  program.outside_unity = options_.roots.project.empty();
  program.entries = options_.entries;
  program.keyword_sets = options_.keyword_sets;
  add_program(program);
}

void ShaderSources::add_program(const SourceProgram& program) {
  bool said = false;
  bool lacks_stage = false;
  bool is_for_another_api = true;
  std::set<variants::GraphicsApi> counted;
  const int source = programs_.empty() ? 0 : programs_.back().source + 1;
  for (const PlatformTargets& platform : options_.platforms) {
    SourceProgram built = program;
    built.platform = platform.platform;
    built.platform.light_mode = program.light_mode;
    built.platform.includes_hlsl_support = program.includes_hlsl_support;
    built.targets = platform.targets;
    built.vulkan = platform.vulkan;
    built.pragmas = variants::read_pragmas({built.file, *built.text, variants::pragma_defines(built.platform),
                                            finder(options_.roots, built.file)});
    variants::apply_overrides(options_.build_settings.overrides, built.pragmas);
    const bool broken = hlsl::has_errors(built.pragmas.diagnostics);
    const bool first = !std::exchange(said, true);
    if (first) say(built.file, built.shader, built.pass, built.pragmas.diagnostics);
    knows_keywords_ &= built.pragmas.diagnostics.empty();
    const bool skipped = !variants::compiles_for(built.pragmas, variants::renderer_name(built.platform.api));
    is_for_another_api = is_for_another_api && !broken && skipped;
    if (broken || skipped) continue;
    if (built.entries.empty())
      for (const variants::EntryPoint& entry : built.pragmas.entry_points)
        built.entries.emplace_back(entry.function, entry.stage);
    built.kernels = built.pragmas.kernels;
    if (built.entries.empty() && built.kernels.empty()) {
      if (first) say(built.file, built.shader, built.pass, {no_entry_point(built)});
      continue;
    }
    if (const std::optional<hlsl::Diagnostic> missing = missing_stage(built))
      if (!std::exchange(lacks_stage, true)) say(built.file, built.shader, built.pass, {*missing});
    built.space = std::make_shared<variants::KeywordSpace>(
        built.pragmas, variants::on_api(built.narrowing, built.platform.api));
    if (const std::string uniforms = uniforms_of(built.space->dynamic_keywords()); !uniforms.empty())
      built.text = uniforms + *built.text;
    built.number = static_cast<int>(programs_.size());
    built.source = source;
    built.counted_before = !counted.insert(built.platform.api).second;
    programs_.push_back(std::move(built));
  }
  if (is_for_another_api)
    leave_unchecked(program, "only_renderers or exclude_renderers leave out every graphics API of this run");
}

std::vector<const SourceProgram*> ShaderSources::counted() const {
  std::vector<const SourceProgram*> list;
  for (const SourceProgram& program : programs_)
    if (!program.counted_before) list.push_back(&program);
  return list;
}

std::size_t ShaderSources::program_count() const {
  std::set<int> sources;
  for (const SourceProgram& program : programs_) sources.insert(program.source);
  return sources.size();
}

ShaderSources::Spaces ShaderSources::spaces() const {
  Spaces spaces;
  for (const SourceProgram* program : counted()) spaces.push_back(program->space);
  return spaces;
}

std::vector<variants::PlannedProgram> ShaderSources::planned(const Spaces& spaces) const {
  std::vector<variants::PlannedProgram> list;
  const std::vector<const SourceProgram*> programs = counted();
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const SourceProgram& program = *programs[i];
    variants::PlannedProgram planned;
    planned.name = fs::path(program.file).filename().string();
    if (!program.pass.empty()) planned.name += ": " + program.pass;
    if (options_.platforms.size() > 1)
      planned.name += std::string(" for ") + variants::renderer_name(program.platform.api);
    planned.space = spaces[i].get();
    planned.targets = 0;
    for (std::size_t number = static_cast<std::size_t>(program.number);
         number < programs_.size() && programs_[number].source == program.source; ++number)
      if (programs_[number].platform.api == program.platform.api)
        planned.targets += programs_[number].targets.size();
    for (const auto& [function, stage] : program.entries) planned.stages.push_back(stage);
    planned.stages.insert(planned.stages.end(), program.kernels.size(), hlsl::Stage::compute);
    list.push_back(std::move(planned));
  }
  return list;
}

variants::Plan ShaderSources::plan() const {
  return variants::plan(planned(spaces()));
}

variants::Plan ShaderSources::plan(const std::vector<variants::Clause>& more) const {
  Spaces spaces;
  for (const SourceProgram* program : counted()) {
    variants::Narrowing narrowing = variants::on_api(program->narrowing, program->platform.api);
    narrowing.clauses.insert(narrowing.clauses.end(), more.begin(), more.end());
    spaces.push_back(std::make_shared<variants::KeywordSpace>(program->pragmas, narrowing));
  }
  return variants::plan(planned(spaces));
}

std::string ShaderSources::refusal(std::uint64_t limit) const {
  return variants::refusal(planned(spaces()), limit);
}

CompileUnit ShaderSources::unit(const SourceProgram& program, const std::string& entry, hlsl::Stage stage,
                                const variants::Keywords& keywords) const {
  CompileUnit unit;
  unit.file = program.file;
  unit.shader = program.shader;
  unit.pass = program.pass;
  unit.sub_shader = program.sub_shader;
  unit.keywords = keywords;
  unit.targets = program.targets;
  unit.compile.file = program.file;
  unit.compile.text = program.text;
  unit.compile.entry = entry;
  unit.compile.stage = stage;
  unit.compile.entry_place = place_of_entry(program.pragmas, entry, stage);
  const auto compiler = options_.build_settings.dxc.find(program.platform.api);
  unit.compile.dxc =
      variants::compiles_with_dxc(program.pragmas, variants::renderer_name(program.platform.api)) ||
      (compiler != options_.build_settings.dxc.end() && compiler->second);
  unit.compile.rasterized =
      std::none_of(program.entries.begin(), program.entries.end(), [](const auto& named) {
        return named.second == hlsl::Stage::hull || named.second == hlsl::Stage::geometry;
      });
  unit.compile.prepare = true;
  unit.compile.vulkan = program.vulkan;
  const int target = variants::shader_target(program.pragmas, keywords);
  unit.program = program.number;
  unit.stage_keywords = variants::keeps_stage_keywords(program.platform.api);
  unit.lint = options_.lint;
  if (program.outside_unity) leave_unity_out(unit.lint);
  unit.lint.shader_target = program.pragmas.targets.empty() ? 0 : target;
  for (const auto& [name, value] : variants::platform_defines(program.platform, stage, target))
    unit.compile.defines.emplace_back(name, value);
  for (const auto* defines : {&options_.build_settings.defines, &options_.defines})
    unit.compile.defines.insert(unit.compile.defines.end(), defines->begin(), defines->end());
  // With instancing_options procedural:NAME, the instancing library calls NAME by this macro.
  if (!program.pragmas.procedural_function.empty())
    unit.compile.defines.emplace_back("UNITY_INSTANCING_PROCEDURAL_FUNC",
                                      program.pragmas.procedural_function);
  for (const std::string& keyword : keywords) unit.compile.defines.emplace_back(keyword, "1");
  unit.compile.package_roots = options_.roots.packages;
  unit.compile.include_directories = options_.roots.directories;
  unit.compile.project = options_.roots.project;
  unit.compile.cginc_root = options_.roots.cginc;
  return unit;
}

CompileUnit ShaderSources::entry_unit(const SourceProgram& program, std::size_t index,
                                      const variants::Keywords& keywords) const {
  if (index < program.entries.size())
    return unit(program, program.entries[index].first, program.entries[index].second, keywords);
  const variants::Kernel& kernel = program.kernels[index - program.entries.size()];
  CompileUnit made = unit(program, kernel.function, hlsl::Stage::compute, keywords);
  made.compile.defines.insert(made.compile.defines.end(), kernel.defines.begin(), kernel.defines.end());
  return made;
}

std::vector<CompileUnit> ShaderSources::units() const {
  std::vector<CompileUnit> units;
  for (const SourceProgram& program : programs_) {
    for (std::size_t i = 0; i < program.entries.size() + program.kernels.size(); ++i) {
      const hlsl::Stage stage = i < program.entries.size() ? program.entries[i].second : hlsl::Stage::compute;
      const std::vector<variants::Keywords> all =
          program.keyword_sets.empty() ? chosen(program.space->variants(stage), options_.sample)
                                       : program.keyword_sets;
      for (const variants::Keywords& keywords : all) units.push_back(entry_unit(program, i, keywords));
    }
  }
  return units;
}

std::vector<ProgramToLint> ShaderSources::to_lint() const {
  const bool all_variants = options_.sample == 0 && options_.narrowing.clauses.empty() && !options_.used;
  std::vector<ProgramToLint> programs;
  std::set<std::tuple<std::string, std::string, int, std::string>> known;
  for (const SourceProgram& program : programs_) {
    if (program.outside_unity) continue;
    if (!known.emplace(program.file, program.shader, program.sub_shader, program.pass).second) continue;
    ProgramToLint& made = programs.emplace_back();
    made.file = program.file;
    made.shader = program.shader;
    made.pass = program.pass;
    made.sub_shader = program.sub_shader;
    made.scriptable_pipeline = program.scriptable_pipeline;
    made.keywords = declared_keywords(program.pragmas);
    made.is_whole = all_variants && program.keyword_sets.empty();
    made.properties = program.properties;
  }
  return programs;
}

}  // namespace penumbra::validation
