#include "shaders/error_recovery.h"

#include <glslang/Public/ResourceLimits.h>

#include <algorithm>

#include "shaders/error_removal.h"

namespace penumbra::shaders {

namespace {

constexpr std::size_t most_errors = 8;
constexpr std::size_t most_rounds = 16;

struct Parse {
  bool accepted = false;
  std::string log;
};

Parse parse_again(const Source& source, const std::string& text) {
  glslang::TShader::ForbidIncluder nothing_left_to_include;
  const Source rest{source.request, source.name, text, {}};
  SourceShader shader(rest);
  Parse parse;
  parse.accepted = shader.get().parse(GetDefaultResources(), hlsl_version, false, messages_of(source.request),
                                      nothing_left_to_include);
  parse.log = shader.get().getInfoLog();
  return parse;
}

bool has_message(const std::vector<hlsl::Diagnostic>& errors, const std::string& message) {
  return std::any_of(errors.begin(), errors.end(),
                     [&](const hlsl::Diagnostic& error) { return error.message == message; });
}

bool is_of_syntax(const hlsl::Diagnostic& error) {
  return error.message.starts_with("expected") || error.message.starts_with("unexpected");
}

// Returns whether the error results from removing a return statement.
bool is_own_making(const hlsl::Diagnostic& error) {
  return error.message.starts_with("function '") && error.message.ends_with("' must return a value");
}

// Returns whether an error is the previous one, or a consequence of its removal.
bool is_still_there(const hlsl::Diagnostic& before, const hlsl::Diagnostic& now) {
  if (now.file != before.file || now.line != before.line) return false;
  return now.message == before.message || is_of_syntax(now) || is_of_syntax(before);
}

}  // namespace

FoundErrors errors_of(const Source& source, const std::string& log, const hlsl::SourceFiles& sources) {
  PlacedError found = placed_error(failure_of(source, log, source.text), sources);
  FoundErrors all{{found.diagnostic}};
  bool repeated = false;
  ErrorRemoval rest(source.text);
  const auto accepts = [&](const Parse& parse) {
    if (parse.accepted && !repeated) all.rest = rest.text();
    return parse.accepted;
  };
  for (std::size_t round = 0; round < most_rounds && all.errors.size() < most_errors && found.offset;
       ++round) {
    const hlsl::Diagnostic before = found.diagnostic;
    const bool lacks_semicolon = before.message.starts_with("expected ';'");
    if (!rest.remove_part(*found.offset, lacks_semicolon)) break;
    Parse parse = parse_again(source, rest.text());
    if (accepts(parse)) break;
    found = placed_error(failure_of(source, parse.log, rest.text()), sources);
    if (found.offset && is_still_there(before, found.diagnostic)) {  // the removed code was not the cause
      if (!rest.remove_body(*found.offset)) break;
      parse = parse_again(source, rest.text());
      if (accepts(parse)) break;
      found = placed_error(failure_of(source, parse.log, rest.text()), sources);
    }
    const bool is_news = found.diagnostic.line > 0 && !is_own_making(found.diagnostic);
    const bool is_told = has_message(all.errors, found.diagnostic.message);
    if (is_news && !is_told) all.errors.push_back(found.diagnostic);
    repeated = repeated || !is_news || is_told;
  }
  return all;
}

}  // namespace penumbra::shaders
