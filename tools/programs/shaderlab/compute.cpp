#include "shaderlab/compute.h"

#include <optional>
#include <set>
#include <utility>

#include "hlsl/identifier.h"
#include "hlsl/source_text.h"
#include "preprocessing/directive_lines.h"
#include "shaderlab/characters.h"
#include "shaderlab/cursor.h"

namespace penumbra::shaderlab {

namespace {

bool is_ray_tracing_file(std::string_view file) {
  constexpr std::string_view extension = ".raytrace";
  return file.size() >= extension.size() &&
         same_keyword(file.substr(file.size() - extension.size()), extension);
}

using preprocessing::DirectiveLine;
using preprocessing::Word;

Place place_of(const Word& word) {
  return {word.line, word.column, word.offset};
}

Name name_of(const Word& word) {
  return {word.text, place_of(word)};
}

class KernelReader {
 public:
  KernelReader(std::string_view bytes, const std::string& file) : file_(file) {
    result_.text = hlsl::normalise_source(bytes);
  }

  ComputeKernels run() {
    std::vector<DirectiveLine> lines = preprocessing::directive_lines(result_.text);
    std::erase_if(lines, [](const DirectiveLine& line) {
      return line.name != "pragma" || line.words.empty() || line.words[0].text != "kernel";
    });
    for (DirectiveLine& line : lines) {
      // Unity takes a line that ends as a statement; the reader of the program's pragmas warns about it.
      std::string& last = line.words.back().text;
      if (last.back() == ';' && (last.size() > 1 || line.words.size() > 2)) last.pop_back();
      if (last.empty()) line.words.pop_back();
      if (std::optional<Kernel> kernel = read(line)) result_.kernels.push_back(std::move(*kernel));
      if (line.line_comment && lines.size() > 1)
        say(hlsl::Severity::warning, {line.line, line.column, line.offset},
            "with several kernels Unity's manual allows no // comment on a line with #pragma kernel");
    }
    return std::move(result_);
  }

 private:
  void say(hlsl::Severity severity, const Place& place, const std::string& message) {
    result_.diagnostics.push_back(diagnostic_at(file_, result_.text, place, severity, message));
  }

  std::optional<Kernel> read(const DirectiveLine& line) {
    if (line.words.size() < 2) {
      say(hlsl::Severity::error, place_of(line.end), "expected the kernel's function after #pragma kernel");
      return std::nullopt;
    }
    Kernel kernel{name_of(line.words[1]), {line.line, line.column, line.offset}, {}};
    if (!hlsl::is_identifier(kernel.function.text)) {
      say(hlsl::Severity::error, kernel.function.place,
          "expected the kernel's function after #pragma kernel, found '" + kernel.function.text + "'");
      return std::nullopt;
    }
    std::set<std::string> macros;
    for (std::size_t i = 2; i < line.words.size(); ++i)
      if (!define(name_of(line.words[i]), kernel, macros)) return std::nullopt;
    return kernel;
  }

  bool define(const Name& word, Kernel& kernel, std::set<std::string>& macros) {
    const std::size_t equals = std::min(word.text.find('='), word.text.size());
    const std::string macro = word.text.substr(0, equals);
    if (!hlsl::is_identifier(macro)) {
      say(hlsl::Severity::error, word.place,
          "expected MACRO or MACRO=VALUE without blanks for the kernel " + kernel.function.text +
              ", found '" + word.text + "'");
      return false;
    }
    if (!macros.insert(macro).second) {
      say(hlsl::Severity::error, word.place,
          "the kernel " + kernel.function.text + " defines " + macro + " twice");
      return false;
    }
    kernel.defines.push_back(
        {{macro, word.place}, equals < word.text.size() ? word.text.substr(equals + 1) : ""});
    return true;
  }

  std::string file_;
  ComputeKernels result_;
};

}  // namespace

ComputeKernels compute_kernels(std::string_view bytes, const std::string& file) {
  if (!is_ray_tracing_file(file)) return KernelReader(bytes, file).run();
  ComputeKernels refused;
  refused.diagnostics.push_back(
      {file,
       0,
       0,
       hlsl::Severity::error,
       "ray-tracing shaders are not supported: their stages need DXR; leave the file out",
       {}});
  return refused;
}

}  // namespace penumbra::shaderlab
