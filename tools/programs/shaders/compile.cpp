#include "shaders/compile.h"

#include <algorithm>
#include <sstream>

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv-tools/libspirv.hpp>

#include "hlsl/source_text.h"
#include "input/input_error.h"
#include "preparation/prepare.h"
#include "shaders/generated_words.h"
#include "shaders/hlsl_problems.h"
#include "shaders/include_resolver.h"
#include "shaders/module_corrections.h"
#include "shaders/parse_failure.h"
#include "shaders/source_memory.h"
#include "shaders/source_shader.h"
#include "shaders/spirv_module.h"
#include "shaders/target_problems.h"
#include "shaders/tree_problems.h"
#include "shaders/tree_signature.h"

namespace penumbra::shaders {

namespace {

// glslang counts its users; the first and the last call must not run concurrently with any other.
void initialise_glslang_once() {
  struct Process {
    Process() { glslang::InitializeProcess(); }
    ~Process() { glslang::FinalizeProcess(); }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
  };
  static const Process process;
}

std::string preamble(const CompileRequest& request) {
  std::string text;
  for (const auto& [name, value] : request.defines)
    text.append("#define ").append(name).append(" ").append(value).append("\n");
  return text;
}

hlsl::Diagnostic whole_file(const Source& source, hlsl::Severity severity, std::string message) {
  return {source.name, 0, 0, severity, std::move(message), {}};
}

bool parse(const Source& source, glslang::TShader& shader, const hlsl::SourceFiles& sources,
           CompileResult& result) {
  glslang::TShader::ForbidIncluder nothing_left_to_include;
  const bool parsed = shader.parse(GetDefaultResources(), hlsl_version, false, messages_of(source.request),
                                   nothing_left_to_include);
  const std::string log = shader.getInfoLog();
  for (hlsl::Diagnostic& warning : warnings(log, sources)) result.diagnostics.push_back(std::move(warning));
  if (parsed && !has_error(log, sources)) return true;
  result.diagnostics.push_back(first_error(failure_of(source, log, source.text), sources));
  return false;
}

bool link(const Source& source, const hlsl::SourceFiles& sources, glslang::TProgram& program,
          CompileResult& result) {
  const bool linked = program.link(messages_of(source.request)) && program.mapIO();
  const std::string log = program.getInfoLog();
  if (linked && !has_error(log, sources)) return true;
  result.diagnostics.push_back(link_error(failure_of(source, log, source.text),
                                          {source.request.entry, source.request.entry_place}, sources));
  return false;
}

// Anything that the SPIR-V back end reports as not supported is an error, otherwise the module would silently
// lack it.
bool generate(const Source& source, const glslang::TIntermediate& tree, CompileResult& result) {
  spv::SpvBuildLogger logger;
  result.spirv = generated_words(tree, source.request.debug_lines, logger);
  std::istringstream lines(logger.getAllMessages());
  bool complete = true;
  for (std::string line; std::getline(lines, line);) {
    const bool note = line.compare(0, 8, "warning:") == 0;
    result.diagnostics.push_back(whole_file(source, note ? hlsl::Severity::warning : hlsl::Severity::error,
                                            "SPIR-V back end: " + line));
    complete = complete && note;
  }
  return complete;
}

// With the text of its line; of the whole file when it has no line of the sources.
hlsl::Diagnostic quoted(hlsl::Diagnostic problem, const Source& source, const hlsl::SourceFiles& sources) {
  if (problem.line == 0 || !sources.contains(problem.file))
    return whole_file(source, problem.severity, std::move(problem.message));
  problem.source_line = sources.line(problem.file, problem.line);
  return problem;
}

bool report(const Source& source, const hlsl::SourceFiles& sources,
            const std::vector<hlsl::Diagnostic>& problems, CompileResult& result) {
  for (const hlsl::Diagnostic& problem : problems)
    result.diagnostics.push_back(quoted(problem, source, sources));
  return !problems.empty();
}

bool finish_module(const Source& source, const hlsl::SourceFiles& sources, const glslang::TIntermediate& tree,
                   CompileResult& result) {
  std::vector<std::string> problems;
  const bool wanted = source.request.optimise;
  std::vector<std::uint32_t>* const kept = source.request.keep_unoptimised ? &result.legalised : nullptr;
  const bool optimised = !wanted || finish(result.spirv, source.request.vulkan, problems, kept);
  if (!wanted) number_bindings(result.spirv);
  if (optimised && wanted) report(source, sources, hlsl_problems(source.request, tree, result.spirv), result);
  if (hlsl::has_errors(result.diagnostics)) return false;
  if (optimised) problems = validation_problems(result.spirv, source.request.vulkan, !wanted);
  const std::string validation =
      std::string("SPIR-V validation for Vulkan ") + vulkan_version_name(source.request.vulkan) + ": ";
  const SourcePlace place =
      problems.empty()
          ? SourcePlace{}
          : problem_place(words_with_lines(tree, wanted, source.request.vulkan), source.request.vulkan);
  for (const std::string& problem : problems)
    result.diagnostics.push_back(quoted(error_at(place, validation + problem), source, sources));
  return optimised && problems.empty();
}

void find_target_problems(const Source& source, const hlsl::SourceFiles& sources,
                          const glslang::TIntermediate& tree, CompileResult& result) {
  if (target_problems(result.spirv, source.text, source.name).empty()) return;
  const SpirvModule lined = words_with_lines(tree, true, source.request.vulkan);
  const std::vector<TargetProblem> problems = target_problems(lined, source.text, source.name);
  for (const Target target : all_targets) {
    TargetDiagnostics of{target_name(target), {}};
    for (const auto& [targets, problem] : problems)
      if (std::find(targets.begin(), targets.end(), target) != targets.end())
        of.diagnostics.push_back(quoted(problem, source, sources));
    if (!of.diagnostics.empty()) result.of_targets.push_back(std::move(of));
  }
}

bool build(const Source& source, const hlsl::SourceFiles& sources, CompileResult& result) {
  SourceShader shader(source);  // outlives the program that uses it
  if (!parse(source, shader.get(), sources, result)) return false;
  glslang::TProgram program;
  program.addShader(&shader.get());
  if (!link(source, sources, program, result)) return false;
  glslang::TIntermediate& tree = *program.getIntermediate(language(source.request.stage));
  if (report(source, sources, reads_without_comparing(tree), result)) return false;
  if (report(source, sources, converted_arguments(tree), result)) return false;
  if (report(source, sources, operations_on_matrices(tree, source.text, source.name), result)) return false;
  // finish_module() makes such layouts valid in what it optimises.
  if (source.request.optimise && report(source, sources, lay_out_cbuffers(tree), result)) return false;
  correct_operations(tree);
  lay_out_buffers(tree);
  if (!generate(source, tree, result) || !finish_module(source, sources, tree, result)) return false;
  if (source.request.optimise) find_target_problems(source, sources, tree, result);
  result.signature = tree_signature(tree, result.spirv);
  if (!source.request.keep_unoptimised) return true;
  spv::SpvBuildLogger messages;
  result.unoptimised = generated_words(tree, true, messages);
  number_bindings(result.unoptimised);
  return true;
}

std::string source_text(const CompileRequest& request, SourceMemory& memory) {
  if (request.text) return hlsl::normalise_source(*request.text);
  const KnownSource& read = memory.read(request.file.string());
  if (!read.problem.empty()) throw InputError(request.file.string(), "cannot be read: " + read.problem);
  return *read.text;
}

// A token that occurs once in the line is taken, however often a macro repeats it: the text may contain only
// some of the declarations that the line expands to, and which ones depends on earlier compilations.
int column_of(const preparation::Note& note) {
  const int alone = hlsl::column_in(note.source_line, note.spelling, 0, 1);
  return alone != 0 ? alone : hlsl::column_in(note.source_line, note.spelling, note.rank, note.count);
}

}  // namespace

PreprocessedSource expand(const CompileRequest& request, SourceMemory& memory) {
  const std::string name = request.file.string();
  const std::string text = source_text(request, memory);
  PreprocessedSource out;
  out.sources.add(name, text);
  IncludeResolver resolver(request, out.sources, memory);
  preprocessing::Preprocessor& preprocessor = memory.preprocessor();
  preprocessing::Preprocessed read = preprocessor.run(preprocessor.cut(preamble(request)),
                                                      memory.cut_text(text, request.prepare), name, resolver);
  out.text = std::move(read.text);
  out.diagnostics = resolver.warnings();
  for (hlsl::Diagnostic& said : read.diagnostics) {
    said.source_line = out.sources.line(said.file, said.line);
    out.diagnostics.push_back(std::move(said));
  }
  out.missing_editor_include = resolver.missing_editor_include();
  out.absent.assign(resolver.absent().begin(), resolver.absent().end());
  out.found_by_case = resolver.found_by_case();
  for (const std::string& file : out.sources.names())
    if (!request.text || file != name) out.dependencies.emplace_back(file);
  return out;
}

void prepare(const CompileRequest& request, PreprocessedSource& expanded) {
  if (!request.prepare || expanded.text.empty()) return;
  preparation::PreparedShader prepared = preparation::prepare(
      std::move(expanded.text), request.file.string(),
      preparation::EntryPoint{request.entry, request.stage, request.dxc, request.rasterized});
  expanded.text = std::move(prepared.text);
  expanded.semantics = std::move(prepared.semantics);
  for (preparation::Note& note : prepared.notes) {
    note.source_line = expanded.sources.line(note.file, note.line);
    if (note.count > 0) note.column = column_of(note);
    expanded.diagnostics.push_back(std::move(note));
  }
}

PreprocessedSource preprocess(const CompileRequest& request) {
  SourceMemory memory;
  PreprocessedSource source = expand(request, memory);
  prepare(request, source);
  return source;
}

CompileResult compile(const CompileRequest& request, PreprocessedSource source) {
  initialise_glslang_once();
  CompileResult result;
  result.diagnostics = std::move(source.diagnostics);
  result.dependencies = std::move(source.dependencies);
  result.missing_editor_include = std::move(source.missing_editor_include);
  const bool refused = hlsl::has_errors(result.diagnostics);
  if (refused || !build({request, request.file.string(), source.text}, source.sources, result)) {
    result.spirv.clear();
    result.signature.clear();
  }
  add_places(source.semantics, result.signature);
  result.sources = std::move(source.sources);
  return result;
}

CompileResult compile(const CompileRequest& request) {
  return compile(request, preprocess(request));
}

std::vector<hlsl::Diagnostic> front_end_messages(const CompileRequest& request,
                                                 const PreprocessedSource& source) {
  initialise_glslang_once();
  CompileResult result;
  result.diagnostics = source.diagnostics;
  if (hlsl::has_errors(result.diagnostics)) return std::move(result.diagnostics);
  const Source whole{request, request.file.string(), source.text};
  SourceShader shader(whole);
  if (parse(whole, shader.get(), source.sources, result)) {
    glslang::TProgram program;
    program.addShader(&shader.get());
    link(whole, source.sources, program, result);
  }
  return std::move(result.diagnostics);
}

std::string compiler_version() {
  const glslang::Version version = glslang::GetVersion();
  const std::string tools = spvSoftwareVersionString();
  return "glslang " + std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
         std::to_string(version.patch) + ", SPIRV-Tools " + tools.substr(0, tools.find(' '));
}

}  // namespace penumbra::shaders
