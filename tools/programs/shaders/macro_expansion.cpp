#include "shaders/macro_expansion.h"

#include <glslang/Public/ResourceLimits.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "preparation/bare_source.h"
#include "preparation/macro_arguments.h"
#include "preparation/macro_text.h"
#include "shaders/include_resolver.h"
#include "shaders/parse_failure.h"
#include "shaders/parse_log.h"
#include "shaders/source_memory.h"
#include "shaders/source_shader.h"

namespace penumbra::shaders {

namespace {

using preparation::MacroArguments;

// Each reading finds the calls of at least one more macro, and nearly always all of them.
constexpr int most_readings = 12;

// glslang prints column - 1 spaces before it.
constexpr const char* joined_in_first_column =
    "ERROR: a token begins in the first column of a line that '\\' joins to the line above; indent it";

bool is_redefinition(const LogLine& line) {
  return line.token == "#define" && line.message.starts_with("Macro redefined;");
}

bool lacks_arguments(const LogLine& line) {
  return line.token == "macro expansion" && line.message.starts_with("Too few args");
}

// Returns whether the line is "2 compilation errors.  No code generated."
bool is_count(const LogLine& line) {
  return line.file.empty() && line.message.ends_with("No code generated.");
}

// Returns the rest of a log without these.
std::string without_redefinitions(const std::string& log) {
  std::string rest;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (line.find("'#define' : Macro redefined;") == std::string::npos) rest.append(line).append("\n");
  return rest;
}

using Place = std::pair<std::string, int>;  // file and line
// The places of each macro's definitions, whatever the conditions.
using Definitions = std::map<std::string, std::vector<Place>>;

// A reading of the source by glslang's preprocessor.
struct Reading {
  std::string text;
  std::vector<LogLine> errors;
  std::string log;
  std::optional<std::string> include_failure;
};

class MacroExpansion {
 public:
  MacroExpansion(const Source& source, SourceMemory& memory, PreprocessedSource& out)
      : source_(source), memory_(memory), out_(out) {}

  void run() {
    std::optional<Reading> own = read_by_own();
    Reading reading = own ? *std::move(own) : read(false);
    if (source_.request.prepare && forgivable(reading)) reading = read_to_the_end();
    if (!reading.errors.empty()) return fail(reading);
    out_.text = std::move(reading.text);
    if (std::optional<hlsl::Diagnostic> bad = bad_character(out_.text, source_.name, out_.sources)) {
      out_.diagnostics.push_back(*std::move(bad));
      out_.text.clear();
    }
  }

 private:
  // Returns nothing if glslang's preprocessor has to read the source.
  std::optional<Reading> read_by_own() {
    const CompileRequest& request = source_.request;
    if (memory_.glslang_alone() || !request.prepare) return std::nullopt;
    hlsl::SourceFiles sources = out_.sources;
    IncludeResolver resolver(request, sources, memory_, arguments_,
                             preparation::undefined_macros(source_.text));
    preprocessing::Preprocessor& preprocessor = memory_.preprocessor();
    std::optional<std::string> text = preprocessor.run(
        preprocessor.cut(source_.preamble), memory_.cut_text(source_.text), source_.name, resolver);
    if (!text) {
      memory_.count_left_to_glslang();
      return std::nullopt;
    }
    out_.sources = std::move(sources);
    Reading reading;
    reading.text = preparation::without_marks(*std::move(text));
    take_includes(resolver);
    return reading;
  }

  void take_includes(const IncludeResolver& resolver) {
    out_.diagnostics.insert(out_.diagnostics.end(), resolver.warnings().begin(), resolver.warnings().end());
    out_.missing_editor_include = resolver.missing_editor_include();
    out_.absent.assign(resolver.absent().begin(), resolver.absent().end());
    out_.found_by_case = resolver.found_by_case();
  }

  Reading read(bool past_errors) {
    IncludeResolver resolver(source_.request, out_.sources, memory_, arguments_,
                             preparation::undefined_macros(source_.text));
    const std::string text = arguments_.rewritten(source_.text);
    const std::string preamble = arguments_.definitions() + arguments_.rewritten(source_.preamble);
    const Source rewritten{source_.request, source_.name, text, preamble};
    SourceShader shader(rewritten);
    Reading reading;
    const int messages = messages_of(source_.request) | (past_errors ? EShMsgCascadingErrors : EShMsgDefault);
    bool expanded = false;
    try {
      expanded = shader.get().preprocess(GetDefaultResources(), hlsl_version, ENoProfile, false, false,
                                         static_cast<EShMessages>(messages), &reading.text, resolver);
    } catch (const std::length_error&) {
      reading.log = joined_in_first_column;
    }
    if (source_.request.prepare) reading.text = preparation::without_marks(std::move(reading.text));
    if (reading.log.empty()) reading.log = shader.get().getInfoLog();
    reading.include_failure = resolver.failure();
    for (LogLine& line : parse_log(reading.log, out_.sources))
      if (line.severity == hlsl::Severity::error && !is_count(line))
        reading.errors.push_back(std::move(line));
    if (reading.errors.empty() && (!expanded || resolver.failure())) reading.errors.emplace_back();
    out_.diagnostics = warnings(reading.log, out_.sources);
    take_includes(resolver);
    return reading;
  }

  static bool forgivable(const Reading& reading) {
    return !reading.include_failure && !reading.errors.empty() &&
           (is_redefinition(reading.errors.front()) || lacks_arguments(reading.errors.front()));
  }

  Reading read_to_the_end() {
    Reading reading = read(true);
    for (int again = 1; again < most_readings && !reading.include_failure; ++again) {
      for (const LogLine& error : reading.errors)
        if (lacks_arguments(error)) arguments_.spread(last_word(error.message));
      if (!any_to_spread(reading) || !learn()) break;
      reading = read(true);
    }
    warn_of_redefinitions(reading);
    return reading;
  }

  static bool any_to_spread(const Reading& reading) {
    return std::any_of(reading.errors.begin(), reading.errors.end(), lacks_arguments);
  }

  // Records the definitions of the files read so far; returns true if the set of calls to rewrite has
  // changed.
  bool learn() {
    for (const std::string& name : out_.sources.names())
      if (known_.insert(name).second) arguments_.read(out_.sources.text(name));
    if (known_.insert(std::string()).second) arguments_.read(source_.preamble);
    return arguments_.settle();
  }

  // glslang has used the later definition each time, and continued.
  void warn_of_redefinitions(Reading& reading) {
    const auto forgiven = std::stable_partition(reading.errors.begin(), reading.errors.end(),
                                                [](const LogLine& line) { return !is_redefinition(line); });
    if (forgiven == reading.errors.end()) return;
    const Definitions definitions = all_definitions();
    std::set<Place> told;
    for (auto line = forgiven; line != reading.errors.end(); ++line)
      if (told.emplace(line->file, line->line).second)
        out_.diagnostics.push_back(redefinition(*line, definitions));
    reading.errors.erase(forgiven, reading.errors.end());
  }

  Definitions all_definitions() const {
    Definitions definitions;
    for (const auto& [name, value] : source_.request.defines)
      definitions[name.substr(0, name.find('('))].emplace_back("", 0);
    for (const std::string& file : out_.sources.names())
      for (const auto& definition : preparation::read_macro_text(out_.sources.text(file)).definitions)
        definitions[std::string(definition.name)].emplace_back(file, definition.line);
    return definitions;
  }

  // The other definition is named if there is only one.
  hlsl::Diagnostic redefinition(const LogLine& line, const Definitions& definitions) const {
    const std::string name = last_word(line.message);
    std::string other;
    const auto known = definitions.find(name);
    if (known != definitions.end() && known->second.size() == 2) {
      const Place here(line.file, line.line);
      const auto& [file, number] = known->second[known->second.front() == here ? 1 : 0];
      other = file.empty() ? " before the first line" : " at " + file + ":" + std::to_string(number);
    }
    const std::string text = out_.sources.line(line.file, line.line);
    return {line.file,
            line.line,
            column_of(name, text),
            hlsl::Severity::warning,
            "macro '" + name + "' is defined as something else" + other +
                "; from here on this definition is used",
            text};
  }

  void fail(const Reading& reading) {
    const std::string log = without_redefinitions(reading.log);
    ParseFailure failure = failure_of(source_, source_.request.prepare ? log : reading.log, reading.text);
    failure.include_failure = reading.include_failure;
    out_.diagnostics.push_back(first_error(failure, out_.sources));
  }

  const Source& source_;
  SourceMemory& memory_;
  PreprocessedSource& out_;
  MacroArguments arguments_;
  std::set<std::string> known_;  // files whose definitions have been recorded
};

}  // namespace

void expand_macros(const Source& source, SourceMemory& memory, PreprocessedSource& out) {
  MacroExpansion(source, memory, out).run();
}

}  // namespace penumbra::shaders
