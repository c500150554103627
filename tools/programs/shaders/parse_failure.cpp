#include "shaders/parse_failure.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "hlsl/expanded_text.h"
#include "hlsl/token_place.h"
#include "shaders/parse_log.h"
#include "shaders/parse_message.h"

namespace penumbra::shaders {

namespace {

hlsl::Diagnostic at_line(const LogLine& line, const hlsl::SourceFiles& sources) {
  const std::string text = sources.line(line.file, line.line);
  const int column = line.message == "Expected" ? 0 : column_of(line.token, text);
  return {line.file, line.line, column, line.severity, sentence(line, {}), text};
}

const LogLine* first_error_line(const std::vector<LogLine>& lines) {
  const auto error = std::find_if(lines.begin(), lines.end(),
                                  [](const LogLine& line) { return line.severity == hlsl::Severity::error; });
  return error == lines.end() ? nullptr : &*error;
}

hlsl::Diagnostic at_place(const hlsl::TokenPlace& place, std::string message,
                          const hlsl::SourceFiles& sources) {
  return {place.file,         place.line,
          place.column,       hlsl::Severity::error,
          std::move(message), sources.line(place.file, place.line)};
}

// Returns the index of the token that the parser reported; nothing if it now reports another error.
std::optional<std::size_t> find_token(const ParseFailure& failure, const LogLine& error,
                                      const hlsl::TokenPlaces& places, const hlsl::SourceFiles& sources) {
  if (!failure.log_of || places.size() == 0) return std::nullopt;
  const std::vector<LogLine> lines = parse_log(failure.log_of(places.one_per_line()), sources);
  const LogLine* again = first_error_line(lines);
  const bool same = again != nullptr && again->message == error.message && again->token == error.token;
  if (!same || again->line < 1 || static_cast<std::size_t>(again->line) > places.size()) return std::nullopt;
  return static_cast<std::size_t>(again->line) - 1;
}

Surroundings surroundings(const hlsl::TokenPlaces& places, std::size_t at) {
  Surroundings around;
  around.found = places[at].spelling;
  around.found_is_identifier = places[at].kind == hlsl::Token::Kind::identifier;
  if (at + 1 < places.size()) {
    around.next = places[at + 1].spelling;
    around.next_is_identifier = places[at + 1].kind == hlsl::Token::Kind::identifier;
  }
  around.same_line_as_before =
      at > 0 && places[at - 1].line == places[at].line && places[at - 1].file == places[at].file;
  return around;
}

// The parser reads "1.5.5" as 1.5 and then .5; this returns both together, or empty.
std::string number_in_two(const hlsl::TokenPlaces& places, std::size_t at) {
  const bool numbers = at > 0 && places[at].kind == hlsl::Token::Kind::number &&
                       places[at - 1].kind == hlsl::Token::Kind::number;
  return numbers ? std::string(places[at - 1].spelling).append(places[at].spelling) : std::string();
}

// Returns the '-' of "float name[-2]": the parser accepts it and then finds every index outside.
std::optional<std::size_t> negative_size(const hlsl::TokenPlaces& places, std::size_t index) {
  std::size_t bracket = index;
  while (bracket > 0 && places[bracket].spelling != "[") --bracket;
  if (bracket == 0) return std::nullopt;
  const std::string_view name = places[bracket - 1].spelling;
  for (std::size_t i = 1; i + 2 < places.size(); ++i)
    if (places[i].spelling == name && places[i + 1].spelling == "[" && places[i + 2].spelling == "-" &&
        places[i - 1].kind == hlsl::Token::Kind::identifier)
      return i + 2;
  return std::nullopt;
}

// glslang reports a constructor after its ')'.
std::size_t start_of_call(const hlsl::TokenPlaces& places, std::size_t at) {
  std::size_t depth = 0;
  for (std::size_t i = at; i > 1; --i) {
    if (places[i].spelling == ")") ++depth;
    if (places[i].spelling == "(" && (depth == 0 || --depth == 0)) return i - 1;
  }
  return at;
}

// Returns "Blend(float a, float b)", from the function's name on.
std::string signature(const hlsl::TokenPlaces& places, std::size_t name) {
  constexpr std::size_t longest = 160;
  std::string text;
  for (std::size_t i = name; i < places.size() && text.size() < longest; ++i) {
    const std::string_view token = places[i].spelling;
    const bool apart = places[i].kind == hlsl::Token::Kind::identifier && i > name && text.back() != '(';
    text.append(apart ? " " : "").append(token);
    if (token == ")") return text;
  }
  return text + " ...";
}

bool names_something_unknown(const LogLine& error) {
  return error.message == "unknown variable" || error.message == "no matching overloaded function found" ||
         error.message == "no such field in structure";
}

// A method's name is printed as "__BI_Sample"; a function that the text does not declare is unknown.
std::string unknown_name(LogLine error, const Surroundings& around, const hlsl::TokenPlaces& places,
                         std::size_t at) {
  const std::string built_in = "__BI_";
  if (error.token.starts_with(built_in)) {
    error.token.erase(0, built_in.size());
    return "no method '" + error.token + "' takes these arguments" + nearest_method(error.token);
  }
  if (error.message != "no matching overloaded function found")
    return sentence(error, around) + nearest_word(error.token, places);
  if (const std::size_t first = places.first_declaration(error.token); first > at && first < places.size())
    return "'" + error.token + "' is declared only in line " + std::to_string(places[first].line) +
           (places[first].file == places[at].file ? "" : " of " + std::string(places[first].file)) +
           ": move it before its first use, or declare it there";
  const std::size_t function = places.function(error.token);
  if (function != places.size()) return sentence(error, around) + "; there is " + signature(places, function);
  return is_intrinsic(error.token)
             ? sentence(error, around)
             : "unknown function '" + error.token + "'" + nearest_word(error.token, places);
}

// A missing ';' is detected at the next token, often a line or a file later; it is reported after the
// previous token. So is the ';' of a list that continues on the next line without ','.
bool is_missing_semicolon(const LogLine& error, const Surroundings& around, std::size_t at) {
  return error.message == "Expected" && at > 0 &&
         (error.token == ";" || (error.token == "," && !around.same_line_as_before));
}

hlsl::Diagnostic missing_semicolon(LogLine error, std::size_t at, const Surroundings& around,
                                   const hlsl::TokenPlaces& places, const hlsl::SourceFiles& sources) {
  error.token = ";";
  if (const std::string number = number_in_two(places, at); !number.empty()) {
    hlsl::TokenPlace place = places.at(at, sources);
    place.column = column_of(number, sources.line(place.file, place.line));
    return at_place(place, "'" + number + "' is not a number", sources);
  }
  return at_place(places.after(at - 1, sources), sentence(error, around), sources);
}

hlsl::Diagnostic at_token(const LogLine& error, std::size_t at, const hlsl::TokenPlaces& places,
                          const hlsl::SourceFiles& sources) {
  const Surroundings around = surroundings(places, at);
  if (is_missing_semicolon(error, around, at)) return missing_semicolon(error, at, around, places, sources);
  if (error.message == "Expected" && error.token.starts_with("loop") && at > 0)  // detected after 'break'
    return at_place(places.at(at - 1, sources), sentence(error, around), sources);
  if (error.message.starts_with("array index out of range"))
    if (const std::optional<std::size_t> minus = negative_size(places, at))
      return at_place(places.at(*minus, sources), "an array's size must be positive", sources);
  hlsl::TokenPlace place = places.at(error.token == "constructor" ? start_of_call(places, at) : at, sources);
  if (error.message != "Expected" && place.file == error.file && place.line == error.line)
    if (const int column = column_of(error.token, sources.line(error.file, error.line)); column != 0)
      place.column = column;
  return at_place(
      place,
      names_something_unknown(error) ? unknown_name(error, around, places, at) : sentence(error, around),
      sources);
}

hlsl::Diagnostic of_open_place(const hlsl::OpenPlace& open, const hlsl::SourceFiles& sources) {
  return at_place({open.file, open.line, open.column}, open.message, sources);
}

// glslang continues after the last line, into text of its own.
bool past_the_end(const LogLine& error, const hlsl::SourceFiles& sources) {
  if (!sources.contains(error.file)) return false;
  const std::string& text = sources.text(error.file);
  return error.line > std::count(text.begin(), text.end(), '\n') + (text.ends_with('\n') ? 0 : 1);
}

// The text "Fade(f1;" is glslang's name of a function with its parameters' types, "@Main(" that of the entry
// point.
std::string plain_name(const std::string& mangled) {
  const std::size_t first = mangled.starts_with('@') ? 1 : 0;
  return mangled.substr(first, mangled.find('(') - first);
}

std::string recursion(const std::string& caller, const std::string& callee) {
  if (caller == callee) return "'" + caller + "' calls itself: HLSL has no recursion";
  return "'" + caller + "' calls '" + callee + "', which leads back to it: HLSL has no recursion";
}

}  // namespace

hlsl::Diagnostic first_error(const ParseFailure& failure, const hlsl::SourceFiles& sources) {
  const std::vector<LogLine> lines = parse_log(failure.log, sources);
  const LogLine* error = first_error_line(lines);
  const bool placed = error != nullptr && error->line > 0;
  // A bracket that is left open takes precedence over the parser's messages.
  if (!placed || error->message == "Expected" || past_the_end(*error, sources)) {
    const auto code = hlsl::expanded_lines(failure.preprocessed, failure.main_file);
    if (const std::optional<hlsl::OpenPlace> open = hlsl::unbalanced_bracket(code, sources))
      return of_open_place(*open, sources);
  }
  if (!placed)
    return at_place({failure.main_file, 0, 0}, "the HLSL front end gave up: " + std::string(failure.log),
                    sources);
  const hlsl::TokenPlaces places(failure.preprocessed, failure.main_file);
  if (const std::optional<std::size_t> at = find_token(failure, *error, places, sources))
    return at_token(*error, *at, places, sources);
  return at_line(*error, sources);
}

hlsl::Diagnostic link_error(const ParseFailure& failure, const NamedEntry& entry,
                            const hlsl::SourceFiles& sources) {
  const hlsl::TokenPlaces places(failure.preprocessed, failure.main_file);
  const auto at_function = [&](const std::string& name, const std::string& message) {
    const std::size_t at = places.function(name);
    if (at == places.size()) return at_place({failure.main_file, 0, 0}, message, sources);
    return at_place(places.at(at, sources), message, sources);
  };
  if (failure.log.find("Entry point not found") != std::string_view::npos)
    return at_place(
        entry.place.line > 0 ? entry.place : hlsl::TokenPlace{failure.main_file, 0, 0},
        "the entry point '" + entry.name + "' is not defined" + nearest_function(entry.name, places),
        sources);
  std::istringstream lines{std::string(failure.log)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string function;
    std::string calling;
    std::string callee;
    if (line.find("No function definition (body) found") != std::string::npos) {
      lines >> function;
      return at_function(plain_name(function),
                         "function '" + plain_name(function) + "' is called and has no body");
    }
    if (words >> function >> calling >> callee && calling == "calling")
      return at_function(plain_name(function), recursion(plain_name(function), plain_name(callee)));
  }
  return at_place({failure.main_file, 0, 0}, "link: " + std::string(failure.log), sources);
}

std::vector<hlsl::Diagnostic> warnings(std::string_view log, const hlsl::SourceFiles& sources) {
  std::vector<hlsl::Diagnostic> diagnostics;
  std::vector<std::string> seen;
  for (const LogLine& line : parse_log(log, sources)) {
    if (line.severity != hlsl::Severity::warning) continue;
    const hlsl::Diagnostic diagnostic = at_line(line, sources);
    if (std::find(seen.begin(), seen.end(), format(diagnostic)) != seen.end()) continue;
    seen.push_back(format(diagnostic));
    diagnostics.push_back(diagnostic);
  }
  return diagnostics;
}

}  // namespace penumbra::shaders
