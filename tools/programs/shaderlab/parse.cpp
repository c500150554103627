#include "shaderlab/parse.h"

#include <algorithm>
#include <utility>

#include "hlsl/source_text.h"
#include "shaderlab/cursor.h"
#include "shaderlab/lexer.h"
#include "shaderlab/structure.h"

namespace penumbra::shaderlab {

namespace {

// Every program's text keeps the lines of the whole file, so many programs in a long file take much memory.
constexpr std::size_t kMostProgramText = std::size_t{256} << 20;

void limit_programs(const Cursor& cursor, const Lexed& lexed, std::size_t length) {
  const std::size_t most = kMostProgramText / std::max<std::size_t>(length, 1);
  if (lexed.programs.size() <= most) return;
  cursor.fail_at(lexed.programs[most].keyword,
                 "more than " + std::to_string(most) + " programs in a file of this length: split the file");
}

bool has_program(const Lexed& lexed, Language language) {
  return std::any_of(lexed.programs.begin(), lexed.programs.end(),
                     [&](const CodeBlock& program) { return program.language == language; });
}

void warn_of_idle_includes(Cursor& cursor, const Lexed& lexed) {
  if (lexed.programs.empty()) return;
  for (const CodeBlock& include : lexed.includes) {
    if (has_program(lexed, include.language)) continue;
    const std::string name = language_name(include.language);
    std::string message = name + "INCLUDE goes into ";
    message += name + "PROGRAM blocks, of which this file has none";
    cursor.warn(include.keyword, message);
  }
}

bool stands_before(const hlsl::Diagnostic& a, const hlsl::Diagnostic& b) {
  if ((a.line == 0) != (b.line == 0)) return b.line == 0;  // messages about the whole file come last
  return std::pair(a.line, a.column) < std::pair(b.line, b.column);
}

}  // namespace

ParsedShader parse_shader(std::string_view bytes, const std::string& file) {
  ParsedShader parsed;
  Shader& shader = parsed.shader;
  shader.file = file;
  shader.text = hlsl::normalise_source(bytes);
  Lexed lexed = lex(shader.text);
  Cursor cursor(file, shader.text, lexed);
  Place end{0, 0, shader.text.size()};
  try {
    parse_structure(cursor, shader);
    limit_programs(cursor, lexed, shader.text.size());
    warn_of_idle_includes(cursor, lexed);
  } catch (const SyntaxError& error) {
    end = error.place;
    parsed.complete = false;
    parsed.diagnostics.push_back(cursor.diagnostic(error.place, hlsl::Severity::error, error.message));
  }
  for (const Remark& warning : lexed.warnings)
    if (warning.place.offset < end.offset) cursor.warn(warning.place, warning.message);
  for (hlsl::Diagnostic& message : cursor.take_diagnostics()) {
    // The error that ends the parse and the unknown names before it often have one cause: only one error is
    // reported.
    if (!parsed.complete && message.severity == hlsl::Severity::error)
      message.severity = hlsl::Severity::warning;
    parsed.diagnostics.push_back(std::move(message));
  }
  std::stable_sort(parsed.diagnostics.begin(), parsed.diagnostics.end(), stands_before);
  shader.includes = std::move(lexed.includes);
  return parsed;
}

}  // namespace penumbra::shaderlab
