#include "hlsl/precision_twins.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "hlsl/function_definitions.h"
#include "hlsl/tokens.h"

namespace penumbra::hlsl {

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> full_precision{
    {{"half", "float"},
     {"min16float", "float"},
     {"min10float", "float"},
     {"min16int", "int"},
     {"min12int", "int"},
     {"min16uint", "uint"}}};

// "", "3" or "4x4": what follows a scalar's name in that of its vectors and matrices.
bool is_shape(std::string_view text) {
  const auto size = [](char c) { return c >= '1' && c <= '4'; };
  return text.empty() || (text.size() == 1 && size(text[0])) ||
         (text.size() == 3 && size(text[0]) && text[1] == 'x' && size(text[2]));
}

std::string widened_word(std::string_view word) {
  for (const auto& [narrow, wide] : full_precision) {
    const bool matches = word.substr(0, narrow.size()) == narrow && is_shape(word.substr(narrow.size()));
    if (matches) return std::string(wide) + std::string(word.substr(narrow.size()));
  }
  return std::string(word);
}

// A parameter as function_definitions() spells it, every word of it widened.
std::string widened(const std::string& parameter) {
  std::string result;
  for (const Token& token : lex(parameter)) {
    result += widened_word(token.spelling);
    if (token.spelling == "out" || token.spelling == "inout") result += ' ';
  }
  return result;
}

int narrow_parameters(const FunctionDefinition& function) {
  return static_cast<int>(std::count_if(function.parameters.begin(), function.parameters.end(),
                                        [](const std::string& type) { return widened(type) != type; }));
}

std::string list(const std::vector<std::string>& types) {
  std::string text;
  for (const std::string& type : types) text += (text.empty() ? "" : ", ") + type;
  return "(" + text + ")";
}

std::string widened_signature(const FunctionDefinition& function) {
  std::vector<std::string> types;
  for (const std::string& type : function.parameters) types.push_back(widened(type));
  return function.name + list(types);
}

std::string file_of(const FunctionDefinition& function, const std::string& main_file) {
  const std::string_view file = function.name_token->file;
  return file.empty() ? main_file : std::string(file);
}

Diagnostic note(const FunctionDefinition& gone, const FunctionDefinition& kept,
                const std::string& main_file) {
  return {file_of(gone, main_file),
          gone.name_token->line,
          0,
          Severity::note,
          "'" + gone.name + list(gone.parameters) + "' differs from '" + kept.name + list(kept.parameters) +
              "' in precision alone, which is not told apart here; the body at " + file_of(kept, main_file) +
              ":" + std::to_string(kept.name_token->line) + " is used for both",
          {}};
}

// Newlines and #line directives inside the body stay, or the lines after it would lose their numbers.
void drop_body(std::string& text, const FunctionDefinition& function) {
  bool line_is_empty = false;
  bool directive = false;
  for (std::size_t i = function.body_begin->offset; i <= function.body_end->offset; ++i) {
    if (text[i] == '\n') {
      line_is_empty = true;
      directive = false;
      continue;
    }
    directive = directive || (line_is_empty && text[i] == '#');
    line_is_empty = line_is_empty && (text[i] == ' ' || text[i] == '\t');
    if (!directive) text[i] = ' ';
  }
  text[function.body_begin->offset] = ';';
}

}  // namespace

MergedTwins merge_precision_twins(const std::string& preprocessed, const std::string& main_file) {
  const std::vector<Token> tokens = lex(preprocessed);
  const std::vector<FunctionDefinition> functions = function_definitions(tokens);
  std::map<std::string, const FunctionDefinition*> kept;
  for (const FunctionDefinition& function : functions) {
    const FunctionDefinition*& best = kept[widened_signature(function)];
    if (best == nullptr || narrow_parameters(function) < narrow_parameters(*best)) best = &function;
  }
  MergedTwins merged{preprocessed, {}};
  for (const FunctionDefinition& function : functions) {
    const FunctionDefinition& best = *kept[widened_signature(function)];
    if (function.parameters == best.parameters) continue;  // itself, or a definition spelled alike
    drop_body(merged.text, function);
    merged.notes.push_back(note(function, best, main_file));
  }
  return merged;
}

}  // namespace penumbra::hlsl
