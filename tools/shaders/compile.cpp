#include "shaders/compile.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>

#include "hlsl/precision_twins.h"
#include "hlsl/source_text.h"
#include "input/input_error.h"
#include "shaders/include_resolver.h"
#include "shaders/parse_failure.h"
#include "shaders/spirv_module.h"

namespace penumbra::shaders {

namespace {

constexpr int hlsl_version = 500;
constexpr auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules | EShMsgReadHlsl);

// glslang counts its users; the first and the last call need to be apart from every other.
void initialise_glslang_once() {
  struct Process {
    Process() { glslang::InitializeProcess(); }
    ~Process() { glslang::FinalizeProcess(); }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
  };
  static const Process process;
}

EShLanguage language(hlsl::Stage stage) {
  switch (stage) {
    case hlsl::Stage::vertex:
      return EShLangVertex;
    case hlsl::Stage::hull:
      return EShLangTessControl;
    case hlsl::Stage::domain:
      return EShLangTessEvaluation;
    case hlsl::Stage::geometry:
      return EShLangGeometry;
    case hlsl::Stage::fragment:
      return EShLangFragment;
    case hlsl::Stage::compute:
      break;
  }
  return EShLangCompute;
}

std::string preamble(const CompileRequest& request) {
  std::string text;
  for (const auto& [name, value] : request.defines)
    text.append("#define ").append(name).append(" ").append(value).append("\n");
  return text;
}

struct Source {
  const CompileRequest& request;
  std::string name;
  std::string text;
  std::string preamble;
};

// A TShader with everything of the request set but not parsed. glslang keeps the pointers it is given, the
// arrays of pointers included, so they stand here beside it and in the source, which outlives both.
class SourceShader {
 public:
  explicit SourceShader(const Source& source)
      : texts_{source.text.data()},
        names_{source.name.c_str()},
        lengths_{static_cast<int>(source.text.size())},
        shader_(language(source.request.stage)) {
    shader_.setStringsWithLengthsAndNames(texts_, lengths_, names_, 1);
    shader_.setPreamble(source.preamble.c_str());
    shader_.setEntryPoint(source.request.entry.c_str());
    shader_.setSourceEntryPoint(source.request.entry.c_str());
    shader_.setEnvInput(glslang::EShSourceHlsl, language(source.request.stage), glslang::EShClientVulkan,
                        100);
    shader_.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    shader_.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
    shader_.setAutoMapBindings(true);
    shader_.setAutoMapLocations(true);
  }
  SourceShader(const SourceShader&) = delete;
  SourceShader& operator=(const SourceShader&) = delete;

  glslang::TShader& get() { return shader_; }

 private:
  const char* texts_[1];
  const char* names_[1];
  int lengths_[1];
  glslang::TShader shader_;
};

hlsl::Diagnostic whole_file(const Source& source, hlsl::Severity severity, std::string message) {
  return {source.name, 0, 0, severity, std::move(message), {}};
}

// The text after includes and macros; empty when that fails.
std::string preprocess(const Source& source, hlsl::SourceFiles& sources) {
  IncludeResolver resolver(source.request, sources);
  SourceShader shader(source);
  std::string text;
  const bool done = shader.get().preprocess(GetDefaultResources(), hlsl_version, ENoProfile, false, false,
                                            messages, &text, resolver);
  return done ? text : std::string();
}

// For the diagnosis of a parse that failed.
std::string preprocess_again(const Source& source) {
  hlsl::SourceFiles sources;
  return preprocess(source, sources);
}

bool parse(const Source& source, glslang::TShader& shader, hlsl::SourceFiles& sources,
           CompileResult& result) {
  IncludeResolver resolver(source.request, sources);
  const bool parsed = shader.parse(GetDefaultResources(), hlsl_version, false, messages, resolver);
  const std::string log = shader.getInfoLog();
  for (hlsl::Diagnostic& warning : warnings(log, sources)) result.diagnostics.push_back(std::move(warning));
  if (parsed && !resolver.failure()) return true;
  const std::string expanded = resolver.failure() ? std::string() : preprocess_again(source);
  result.diagnostics.push_back(first_error({log, source.name, resolver.failure(), expanded}, sources));
  return false;
}

bool link(const Source& source, glslang::TProgram& program, CompileResult& result) {
  if (program.link(messages) && program.mapIO()) return true;
  const std::string log = program.getInfoLog();
  const bool no_entry = log.find("Entry point not found") != std::string::npos;
  result.diagnostics.push_back(whole_file(
      source, hlsl::Severity::error,
      no_entry ? "there is no function '" + source.request.entry + "' to enter at" : "link: " + log));
  return false;
}

// What the SPIR-V back end says: anything it leaves out is an error, or the module would quietly lack it.
bool generate(const Source& source, const glslang::TIntermediate& tree, CompileResult& result) {
  glslang::SpvOptions options;
  options.disableOptimizer = true;  // SPIRV-Tools is called by ourselves
  options.generateDebugInfo = source.request.debug_lines;
  spv::SpvBuildLogger logger;
  std::vector<unsigned int> words;
  glslang::GlslangToSpv(tree, words, &logger, &options);
  result.spirv.assign(words.begin(), words.end());
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

bool finish_module(const Source& source, CompileResult& result) {
  std::vector<std::string> problems;
  const bool optimised = !source.request.optimise || optimise(result.spirv, problems);
  number_bindings(result.spirv);  // after the unused ones are gone
  if (optimised) problems = validation_problems(result.spirv, !source.request.optimise);
  for (const std::string& problem : problems)
    result.diagnostics.push_back(whole_file(source, hlsl::Severity::error, "SPIR-V validation: " + problem));
  return optimised && problems.empty();
}

bool build(const Source& source, hlsl::SourceFiles& sources, CompileResult& result) {
  SourceShader shader(source);  // outlives the program that uses it
  if (!parse(source, shader.get(), sources, result)) return false;
  glslang::TProgram program;
  program.addShader(&shader.get());
  return link(source, program, result) &&
         generate(source, *program.getIntermediate(language(source.request.stage)), result) &&
         finish_module(source, result);
}

// What the parser reads: the source, or its expansion with one body for each group of precision twins. A
// source that does not expand is left as it is, for the parser to say why.
Source with_twins_merged(const Source& source, hlsl::SourceFiles& sources, CompileResult& result) {
  if (!source.request.merge_precision_twins) return source;
  const std::string expanded = preprocess(source, sources);
  if (expanded.empty()) return source;
  hlsl::MergedTwins merged = hlsl::merge_precision_twins(expanded, source.name);
  for (hlsl::Diagnostic& note : merged.notes) {
    note.source_line = sources.line(note.file, note.line);
    result.diagnostics.push_back(std::move(note));
  }
  return {source.request, source.name, std::move(merged.text), {}};
}

// glslang stops reading at a NUL byte without a word.
std::optional<hlsl::Diagnostic> nul_byte(const hlsl::SourceFiles& sources) {
  for (const std::string& name : sources.names()) {
    const std::string& text = sources.text(name);
    const std::size_t at = text.find('\0');
    if (at == std::string::npos) continue;
    const auto before = text.begin() + static_cast<std::ptrdiff_t>(at);
    const auto line = static_cast<int>(std::count(text.begin(), before, '\n')) + 1;
    return hlsl::Diagnostic{name, line, 0, hlsl::Severity::error, "a NUL byte; is this a text file?", {}};
  }
  return std::nullopt;
}

std::string source_text(const CompileRequest& request) {
  if (request.text) return hlsl::normalise_source(*request.text);
  hlsl::SourceRead read = hlsl::read_source(request.file);
  if (!read.problem.empty()) throw InputError(request.file.string(), "cannot be read: " + read.problem);
  return std::move(read.text);
}

}  // namespace

CompileResult compile(const CompileRequest& request) {
  initialise_glslang_once();
  const Source source{request, request.file.string(), source_text(request), preamble(request)};
  hlsl::SourceFiles sources;
  sources.add(source.name, source.text);
  CompileResult result;
  bool built = build(with_twins_merged(source, sources, result), sources, result);
  if (const std::optional<hlsl::Diagnostic> nul = nul_byte(sources)) {
    result.diagnostics = {*nul};
    built = false;
  }
  if (!built) result.spirv.clear();
  for (const std::string& name : sources.names())
    if (!request.text || name != source.name) result.dependencies.emplace_back(name);
  result.sources = std::move(sources);
  return result;
}

}  // namespace penumbra::shaders
