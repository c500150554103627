#include "variants/keyword_expression.h"

#include <map>
#include <set>

#include "hlsl/identifier.h"
#include "input/input_error.h"
#include "input/nearest_name.h"

namespace penumbra::variants {
namespace {

constexpr const char* grammar = "write +NAME (always on), -NAME (never on) or A|B (only these of their set)";

[[noreturn]] void fail(const std::string& word, const std::string& problem) {
  throw InputError("--keywords", "'" + word + "' " + problem, grammar);
}

std::vector<std::string> words_of(std::string_view expression) {
  std::vector<std::string> words{""};
  for (const char c : expression) {
    const bool separates = c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',';
    if (!separates) words.back() += c;
    if (separates && !words.back().empty()) words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

Clause choice_of(const std::string& word) {
  Clause clause;
  clause.of_their_sets = true;
  clause.said_by = "--keywords " + word;
  for (std::size_t at = 0; at <= word.size();) {
    const std::size_t end = std::min(word.find('|', at), word.size());
    const std::string name = word.substr(at, end - at);
    if (is_empty_keyword(name)) {
      clause.or_none = true;
    } else if (hlsl::is_identifier(name)) {
      clause.any_of.push_back(name);
    } else {
      fail(word, name.empty() ? "lacks a name next to '|'" : "holds '" + name + "', which is not a keyword");
    }
    at = end + 1;
  }
  if (clause.any_of.empty()) fail(word, "names no keyword, so it is not known which sets it is for");
  return clause;
}

}  // namespace

std::vector<Clause> parse_keyword_expression(std::string_view expression) {
  std::vector<Clause> clauses;
  std::map<std::string, char> signs;
  for (const std::string& word : words_of(expression)) {
    const char sign = word.front();
    if (sign != '+' && sign != '-') {
      if (word.find('|') == std::string::npos) fail(word, "does not say whether it is on or off");
      clauses.push_back(choice_of(word));
      continue;
    }
    const std::string name = word.substr(1);
    if (!hlsl::is_identifier(name) || is_empty_keyword(name)) fail(word, "does not name a keyword");
    const auto [known, is_new] = signs.try_emplace(name, sign);
    if (is_new) {
      const std::string said_by = "--keywords " + word;
      clauses.push_back(sign == '+' ? always(name, said_by) : never(name, said_by));
    } else if (known->second != sign) {
      fail(word, "contradicts '" + std::string(1, known->second) + name + "'");
    }
  }
  return clauses;
}

std::vector<std::string> unknown_keywords(const std::vector<Clause>& clauses,
                                          const std::vector<const Pragmas*>& programs) {
  std::set<std::string> declared;
  for (const Pragmas* program : programs) {
    for (const KeywordSet& set : program->keyword_sets)
      for (const std::string& keyword : keywords_of(set)) declared.insert(keyword);
    for (const DynamicKeyword& keyword : program->dynamic_keywords) declared.insert(keyword.name);
  }
  const std::vector<std::string> known(declared.begin(), declared.end());
  std::vector<std::string> messages;
  for (const Clause& clause : clauses) {
    Keywords named = clause.any_of;
    if (!clause.when.empty()) named.insert(named.begin(), clause.when);
    for (const std::string& keyword : named) {
      if (declared.contains(keyword)) continue;
      const std::string nearest = nearest_name(keyword, known);
      messages.push_back(clause.said_by + ": no program declares '" + keyword + "'" +
                         (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
    }
  }
  return messages;
}

}  // namespace penumbra::variants
