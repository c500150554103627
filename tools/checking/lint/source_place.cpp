#include "lint/source_place.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "hlsl/token_place.h"
#include "lint/rule.h"

namespace penumbra::lint {

namespace {

std::string_view without_comment(std::string_view line) {
  return line.substr(0, line.find("//"));
}

hlsl::Severity severity_of(const std::string& rule) {
  const RuleInfo* info = find_rule(rule);
  return info == nullptr ? hlsl::Severity::warning : info->severity;
}

}  // namespace

std::string place_in_words(const LintedCode& linted, spirv::Place place, spirv::Place from) {
  if (place.line == 0) return "";
  const std::string line = std::to_string(place.line);
  return place.file == from.file ? " at line " + line
                                 : " at " + linted.code.file_name(place.file) + ":" + line;
}

hlsl::Diagnostic finding_at(const LintedCode& linted, const std::string& rule, spirv::Place place,
                            const std::vector<std::string>& words, std::string message) {
  std::string file = linted.code.file_name(place.file);
  if (file.empty()) file = linted.main_file;
  const std::string line = linted.sources.line(file, place.line);
  int column = 0;
  for (const std::string& word : words)
    if (column == 0) column = hlsl::column_of_word(word, without_comment(line));
  return {file, place.line, column, severity_of(rule), std::move(message), line, rule};
}

hlsl::Diagnostic finding_at_declaration(const LintedCode& linted, const std::string& rule,
                                        const std::string& name, const std::vector<std::string>& declaring,
                                        std::string message) {
  for (const std::string& file : linted.sources.names()) {
    const std::string& text = linted.sources.text(file);
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
      if (!hlsl::is_whole_word(text, at, name.size())) continue;
      const std::size_t start = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
      const std::string line = text.substr(start, text.find('\n', start) - start);
      const std::string_view code = without_comment(line);
      const bool declares = at - start < code.size() &&
                            std::any_of(declaring.begin(), declaring.end(), [&](const std::string& word) {
                              return code.find(word) != std::string_view::npos;
                            });
      if (!declares) continue;
      const auto end_of_start = text.begin() + static_cast<std::ptrdiff_t>(start);
      const int number = static_cast<int>(std::count(text.begin(), end_of_start, '\n')) + 1;
      const int column = static_cast<int>(at - start) + 1;
      return {file, number, column, severity_of(rule), std::move(message), line, rule};
    }
  }
  return {linted.main_file, 0, 0, severity_of(rule), std::move(message), {}, rule};
}

}  // namespace penumbra::lint
