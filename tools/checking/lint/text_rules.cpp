#include "lint/text_rules.h"

#include <algorithm>
#include <utility>

#include "hlsl/token_place.h"
#include "hlsl/tokens.h"
#include "lint/source_place.h"

namespace penumbra::lint {

namespace {

constexpr std::string_view version_macro = "UNITY_VERSION";

// Returns the names that are declared groupshared with an initialiser.
std::vector<std::size_t> initialised_names(const hlsl::TokenPlaces& tokens) {
  std::vector<std::size_t> found;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (tokens[at].spelling != "groupshared") continue;
    std::size_t name = at;
    for (int depth = 0; ++at < tokens.size() && tokens[at].spelling != ";";) {
      const std::string_view token = tokens[at].spelling;
      if (token == "[" || token == "{" || token == "<") ++depth;
      if (token == "]" || token == "}" || token == ">") --depth;
      if (depth == 0 && tokens[at].kind == hlsl::Token::Kind::identifier) name = at;
      if (depth == 0 && token == "=") found.push_back(name);
    }
  }
  return found;
}

// Returns whether the number has the digits of a version, in another form than UNITY_VERSION. 600000 and
// 6000000 are no such number: they are between the versions of 2023 and those of Unity 6.
bool is_no_version(std::string_view digits) {
  const bool is_year = digits.size() >= 4 && digits.starts_with("20") && digits[2] >= '1' && digits[2] <= '2';
  if (is_year) return digits.size() != 6;
  if (!digits.starts_with("6000") || digits == "600000" || digits == "6000000") return false;
  return digits.size() != 8 || digits[4] != '0';  // four digits of a patch
}

// Returns the number that the condition compares with UNITY_VERSION at that place; empty if there is none.
std::string_view compared_number(const std::vector<hlsl::Token>& tokens, std::size_t at) {
  const auto is_operator = [&](std::size_t i) {
    return i < tokens.size() && std::string_view("<>=!").find(tokens[i].spelling) != std::string_view::npos;
  };
  std::size_t after = at + 1;
  while (is_operator(after)) ++after;
  if (after > at + 1 && after < tokens.size() && tokens[after].kind == hlsl::Token::Kind::number)
    return tokens[after].spelling;
  std::size_t before = at;
  while (before > 0 && is_operator(before - 1)) --before;
  if (before > 0 && before < at && tokens[before - 1].kind == hlsl::Token::Kind::number)
    return tokens[before - 1].spelling;
  return {};
}

// Returns what is behind #if or #elif, without a comment; empty for other lines.
std::string condition_of(std::string_view line) {
  const auto skip_blanks = [&] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
  skip_blanks();
  if (!line.starts_with('#')) return {};
  line.remove_prefix(1);
  skip_blanks();
  for (const std::string_view word : {"if ", "if(", "elif ", "elif("})
    if (line.starts_with(word)) return std::string(line.substr(word.size() - 1, line.find("//")));
  return {};
}

void add_versions(const std::string& file, int number, const std::string& line,
                  std::vector<hlsl::Diagnostic>& findings) {
  const std::string condition = condition_of(line);
  const std::vector<hlsl::Token> tokens = hlsl::lex(condition);
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (tokens[at].spelling != version_macro) continue;
    const std::string_view compared = compared_number(tokens, at);
    if (!is_no_version(compared)) continue;
    findings.push_back({file, number, hlsl::column_of_word(compared, line), hlsl::Severity::warning,
                        std::string(compared) +
                            " is no value of UNITY_VERSION: that is 202230 for Unity 2022.3.0, 60000000 for "
                            "6000.0.0 and 60010000 for 6000.1.0",
                        line, "unity-version"});
  }
}

}  // namespace

std::vector<hlsl::Diagnostic> groupshared_initialiser_findings(const std::string& expanded,
                                                               const std::string& main_file,
                                                               const hlsl::SourceFiles& sources) {
  if (expanded.find("groupshared") == std::string::npos) return {};
  std::vector<hlsl::Diagnostic> findings;
  const hlsl::TokenPlaces tokens(expanded, main_file);
  for (const std::size_t at : initialised_names(tokens)) {
    const hlsl::TokenPlace place = tokens.at(at, sources);
    findings.push_back(
        {place.file, place.line, place.column, hlsl::Severity::warning,
         "every thread writes the initialiser of the groupshared '" + std::string(tokens[at].spelling) +
             "' when it starts, also over what others have written since (DXC ignores it): let one "
             "thread write it, and put GroupMemoryBarrierWithGroupSync() behind",
         sources.line(place.file, place.line), "groupshared-initialiser"});
  }
  return findings;
}

bool compares_unity_version(std::string_view source) {
  return source.find(version_macro) != std::string_view::npos;
}

std::vector<hlsl::Diagnostic> unity_version_findings(const hlsl::SourceFiles& sources) {
  std::vector<hlsl::Diagnostic> findings;
  for (const std::string& file : sources.names()) {
    const std::string& text = sources.text(file);
    int number = 1;
    for (std::size_t start = 0, at; (at = text.find(version_macro, start)) != std::string::npos;) {
      const std::size_t begin = text.rfind('\n', at) + 1;
      const std::size_t end = std::min(text.find('\n', at), text.size());
      number += static_cast<int>(std::count(text.data() + start, text.data() + at, '\n'));
      add_versions(file, number, text.substr(begin, end - begin), findings);
      start = end;
    }
  }
  return findings;
}

std::vector<hlsl::Diagnostic> text_findings(const std::string& expanded, const std::string& main_file,
                                            const hlsl::SourceFiles& sources) {
  std::vector<hlsl::Diagnostic> findings = groupshared_initialiser_findings(expanded, main_file, sources);
  for (hlsl::Diagnostic& finding : unity_version_findings(sources)) findings.push_back(std::move(finding));
  return findings;
}

}  // namespace penumbra::lint
