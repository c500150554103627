// Merges overloads that differ only in precision.
//
// HLSL distinguishes f(half) from f(float); a front end that treats half as float reports a redefinition.
// Shader libraries define both on purpose. Definitions count as equal if their name and parameter types agree
// once half, min16float and min10float are read as float (min16int and min12int as int, min16uint as uint).
// The one with the most full-precision parameters keeps its body, the first of several; one that calls its
// own name, and so may forward to another overload, only if all do. The others become declarations, each with
// a note. If the two bodies differ in more than the spelling of types (HALF_EPS against FLT_EPS), the choice
// matters: the kept body is the one that overload resolution selects for the calls that the entry point
// reaches, and the note is a warning if it reaches any of them. Definitions with identical parameter types
// are not merged: every compiler rejects them.

#include <algorithm>
#include <array>
#include <utility>

#include "hlsl/declarations.h"
#include "hlsl/tokens.h"
#include "preparation/declarators.h"
#include "preparation/passes.h"
#include "preparation/postfix_expression.h"
#include "preparation/token_text.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

// HLSL's view of a call's argument as half or as float, for overloads that differ only in precision.

enum class Precision { full, narrow };

// Returns the numeric type of the cast, variable, member, element or function result that ends at a token.
std::string_view type_ending_at(const TokenText& text, std::size_t at) {
  const std::string_view word = text.word(at);
  if (text.is_identifier(at) && is_number_type(word)) return word;
  const std::string_view type = text.is_any(at + 1, "[", "(") ? "" : text.types().at(at).name;
  return is_number_type(type) ? type : std::string_view();
}

// Returns whether the type is half2, min16float, min10float3x3, min16int or similar.
bool is_narrow_type(std::string_view type) {
  return type.substr(0, 4) == "half" || type.substr(0, 3) == "min";
}

// Returns one result for each argument in the parentheses that open at `open`: narrow if it has variables,
// casts or calls and all of them are narrow; literals alone are full.
std::vector<Precision> argument_precisions(const TokenText& text, std::size_t open) {
  const std::size_t close = text.matching_bracket(open);
  std::vector<Precision> all;
  bool narrow = false;
  bool full = false;
  const auto end_argument = [&] {
    all.push_back(narrow && !full ? Precision::narrow : Precision::full);
    narrow = full = false;
  };
  const auto look = [&](std::size_t at) {
    const std::string_view type = type_ending_at(text, at);
    narrow = narrow || (!type.empty() && is_narrow_type(type));
    full = full || (!type.empty() && !is_narrow_type(type));
  };
  for (std::size_t at = open + 1; at < close; ++at) {
    const std::size_t match = text.matching_bracket(at);
    const bool opens = match != npos && match > at;
    if (text.is(at, ",")) {
      end_argument();
    } else if (opens && match == at + 2 && text.is_identifier(at + 1) && is_number_type(text.word(at + 1))) {
      look(at + 1);  // a cast, whose operand does not matter
      const std::size_t operand = match + 1;
      const bool group = text.is(operand, "(") && text.matching_bracket(operand) != npos;
      at = postfix_end(text, group ? text.matching_bracket(operand) : operand) - 1;
    } else if (opens && (text.is(at, "[") || !text.types().at(match).name.empty())) {
      look(match);  // a subscript, or the arguments of a known function, do not matter
      at = match;
    } else if (opens) {
      for (; at < match; ++at) look(at);  // its commas do not separate the call's arguments
    } else {
      look(at);
    }
  }
  if (close > open + 1) end_argument();
  return all;
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> full_precision{
    {{"half", "float"},
     {"min16float", "float"},
     {"min10float", "float"},
     {"min16int", "int"},
     {"min12int", "int"},
     {"min16uint", "uint"}}};

// Returns whether the text is "", "3" or "4x4": the end of the name of a vector or matrix, after its
// scalar's.
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

// Returns a parameter as parameter_types() spells it, with every type widened to full precision.
std::string widened(const std::string& parameter) {
  const bool one_word = std::all_of(parameter.begin(), parameter.end(), hlsl::continues_identifier);
  if (one_word) return widened_word(parameter);
  std::string result;
  for (const hlsl::Token& token : hlsl::lex(parameter)) {
    result += widened_word(token.spelling);
    if (token.spelling == "out" || token.spelling == "inout") result += ' ';
  }
  return result;
}

struct OverloadedFunction {
  const hlsl::Declaration* declaration;
  std::string name;  // the name with its namespaces
  std::vector<std::string> parameters;
  std::vector<std::string> widened_parameters;
};

OverloadedFunction read_function(const TokenText& text, const hlsl::Declaration& declaration) {
  OverloadedFunction function{&declaration,
                              declaration.scope + text.name(declaration.name),
                              hlsl::parameter_types(text.tokens(), declaration),
                              {}};
  for (const std::string& type : function.parameters) function.widened_parameters.push_back(widened(type));
  return function;
}

// Returns the functions that share their name with another; only they can be overloads.
std::vector<OverloadedFunction> overloaded_functions(const TokenText& text) {
  std::unordered_map<std::string_view, int> definitions;  // by name, for all namespaces together
  for (const hlsl::Declaration& declaration : text.declarations())
    if (declaration.kind == hlsl::Declaration::Kind::function) ++definitions[text.word(declaration.name)];
  std::vector<OverloadedFunction> functions;
  for (const hlsl::Declaration& declaration : text.declarations()) {
    if (declaration.kind != hlsl::Declaration::Kind::function) continue;
    if (definitions[text.word(declaration.name)] > 1) functions.push_back(read_function(text, declaration));
  }
  return functions;
}

int narrow_parameters(const OverloadedFunction& function) {
  int count = 0;
  for (std::size_t i = 0; i < function.parameters.size(); ++i)
    count += function.parameters[i] != function.widened_parameters[i] ? 1 : 0;
  return count;
}

// In float f(float x) { return f(half(x)); }, the function would call itself with one body left.
bool calls_its_name(const TokenText& text, const OverloadedFunction& function) {
  const hlsl::Declaration& declaration = *function.declaration;
  const std::string_view name = text.word(declaration.name);
  for (std::size_t at = declaration.open; at < declaration.close; ++at)
    if (text.is(at, name) && text.is(at + 1, "(") && !text.is(at - 1, ".")) return true;
  return false;
}

// Returns which of two overloads keeps its body: one that does not forward to the other, then the one with
// more full-precision parameters.
bool better(const TokenText& text, const OverloadedFunction& a, const OverloadedFunction& b) {
  const bool a_calls = calls_its_name(text, a);
  const bool b_calls = calls_its_name(text, b);
  return a_calls != b_calls ? b_calls : narrow_parameters(a) < narrow_parameters(b);
}

std::string list(const std::vector<std::string>& types) {
  std::string text;
  for (const std::string& type : types) text += (text.empty() ? "" : ", ") + type;
  return "(" + text + ")";
}

std::string widened_signature(const OverloadedFunction& function) {
  return function.name + list(function.widened_parameters);
}

// The suffix of a literal only sets its precision: 1.0f and 1.0 are equal.
std::string_view without_suffix(std::string_view number) {
  const bool hexadecimal = number.size() > 1 && (number[1] == 'x' || number[1] == 'X');
  if (!hexadecimal && (number.back() == 'f' || number.back() == 'F')) number.remove_suffix(1);
  return number;
}

// Returns the numbers of the parameters, from 1 on, by name.
std::unordered_map<std::string_view, int> parameter_numbers(const TokenText& text,
                                                            const hlsl::Declaration& function) {
  std::unordered_map<std::string_view, int> numbers;
  int number = 1;
  for (std::size_t at = function.parameters_open + 1; at < function.parameters_close; ++at) {
    if (text.is(at, ",")) ++number;
    const bool ends = text.is_any(at + 1, ",", ")", "[", ":");
    if (ends && text.is_identifier(at)) numbers.emplace(text.word(at), number);
  }
  return numbers;
}

bool same_bodies(const TokenText& text, const hlsl::Declaration& a, const hlsl::Declaration& b) {
  if (a.close - a.open != b.close - b.open) return false;
  const auto of_a = parameter_numbers(text, a);
  const auto of_b = parameter_numbers(text, b);
  for (std::size_t i = 0; i <= a.close - a.open; ++i) {
    const hlsl::Token& left = text[a.open + i];
    const hlsl::Token& right = text[b.open + i];
    const auto left_number = of_a.find(left.spelling);
    const auto right_number = of_b.find(right.spelling);
    if (left_number != of_a.end() || right_number != of_b.end()) {
      if (left_number == of_a.end() || right_number == of_b.end() ||
          left_number->second != right_number->second)
        return false;
      continue;
    }
    const bool number = left.kind == hlsl::Token::Kind::number && right.kind == left.kind;
    if (left.spelling == right.spelling) continue;
    const bool same = number ? without_suffix(left.spelling) == without_suffix(right.spelling)
                             : widened_word(left.spelling) == widened_word(right.spelling);
    if (!same) return false;
  }
  return true;
}

// Returns which tokens may be executed: those outside of functions, and those of functions that the entry
// point reaches by their names. Without an entry point, all may be.
std::vector<bool> reached_tokens(const TokenText& text) {
  std::vector<bool> reached(text.size(), true);
  if (text.entry().empty()) return reached;
  std::unordered_map<std::string_view, std::vector<const hlsl::Declaration*>> functions;
  for (const hlsl::Declaration& declaration : text.declarations()) {
    const bool is_function = declaration.kind == hlsl::Declaration::Kind::function;
    if (is_function) functions[text.word(declaration.name)].push_back(&declaration);
    if (is_function || declaration.kind == hlsl::Declaration::Kind::prototype)
      std::fill(reached.begin() + static_cast<std::ptrdiff_t>(declaration.first),
                reached.begin() + static_cast<std::ptrdiff_t>(declaration.last) + 1, false);
  }
  std::vector<std::string_view> wanted{text.entry()};
  for (std::size_t at = 0; at < text.size(); ++at)
    if (reached[at] && text.is_identifier(at)) wanted.push_back(text.word(at));
  while (!wanted.empty()) {
    const auto found = functions.find(wanted.back());
    wanted.pop_back();
    if (found == functions.end()) continue;
    for (const hlsl::Declaration* function : found->second)
      for (std::size_t at = function->first; at <= function->last; ++at) {
        reached[at] = true;
        if (text.is_identifier(at)) wanted.push_back(text.word(at));
      }
    functions.erase(found);
  }
  return reached;
}

// Records a warning if it may change what the entry point does. `reached` is empty, or the result of
// reached_tokens().
void drop(TokenText& text, const OverloadedFunction& gone, const OverloadedFunction& kept,
          std::vector<bool>& reached) {
  const std::size_t kept_at = kept.declaration->name;
  const bool same = same_bodies(text, *gone.declaration, *kept.declaration);
  if (!same && reached.empty()) reached = reached_tokens(text);
  const bool matters = !same && reached[gone.declaration->name];
  text.note(gone.declaration->name, matters ? hlsl::Severity::warning : hlsl::Severity::note,
            "'" + gone.name + list(gone.parameters) + "' differs from '" + kept.name + list(kept.parameters) +
                "' only in precision, which is ignored here; the body at " + text.file_of(kept_at) + ":" +
                std::to_string(text[kept_at].line) + " is used for both" +
                (same ? "" : ", and the two bodies differ in more than their types"));
  text.replace(gone.declaration->open, gone.declaration->close - gone.declaration->open + 1, ";");
}

// Overloads that differ only in precision, in source order.
using Overloads = std::vector<const OverloadedFunction*>;

bool bodies_differ(const TokenText& text, const Overloads& overloads) {
  return std::any_of(overloads.begin(), overloads.end(), [&](const OverloadedFunction* overload) {
    return !same_bodies(text, *overload->declaration, *overloads[0]->declaration);
  });
}

bool is_in_one(const Overloads& overloads, std::size_t at) {
  return std::any_of(overloads.begin(), overloads.end(), [&](const OverloadedFunction* overload) {
    return at >= overload->declaration->first && at <= overload->declaration->last;
  });
}

// Returns the overload with the most parameters as narrow as the arguments.
const OverloadedFunction* chosen_by(const std::vector<Precision>& arguments, const Overloads& overloads) {
  const OverloadedFunction* best = nullptr;
  int most = -1;
  for (const OverloadedFunction* overload : overloads) {
    if (overload->parameters.size() != arguments.size()) return nullptr;
    int matches = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const bool narrow = overload->parameters[i] != overload->widened_parameters[i];
      matches += narrow == (arguments[i] == Precision::narrow) ? 1 : 0;
    }
    if (matches > most) best = overload;
    most = std::max(most, matches);
  }
  return best;
}

// Returns the overload that all reached calls outside of these overloads select; null if they select several,
// or there is no call.
const OverloadedFunction* called_overload(const TokenText& text, const Overloads& overloads,
                                          const std::vector<bool>& reached) {
  const std::string_view name = text.word(overloads[0]->declaration->name);
  const OverloadedFunction* called = nullptr;
  for (std::size_t at = 1; at + 1 < text.size(); ++at) {
    const bool call = text.is(at, name) && text.is(at + 1, "(") && text.matching_bracket(at + 1) != npos &&
                      !text.is(at - 1, ".");
    if (!call || !reached[at] || is_in_one(overloads, at)) continue;
    const OverloadedFunction* chosen = chosen_by(argument_precisions(text, at + 1), overloads);
    if (chosen == nullptr || chosen == called) continue;
    if (called != nullptr) return nullptr;
    called = chosen;
  }
  return called;
}

// Returns which of them keeps its body.
const OverloadedFunction* kept_overload(const TokenText& text, const Overloads& overloads,
                                        std::vector<bool>& reached) {
  const OverloadedFunction* best = overloads[0];
  for (const OverloadedFunction* overload : overloads)
    if (better(text, *overload, *best)) best = overload;
  const bool forwards = std::any_of(overloads.begin(), overloads.end(),
                                    [&](const auto* overload) { return calls_its_name(text, *overload); });
  if (overloads.size() == 1 || forwards || !bodies_differ(text, overloads)) return best;
  if (reached.empty()) reached = reached_tokens(text);
  const OverloadedFunction* called = called_overload(text, overloads, reached);
  return called != nullptr ? called : best;
}

}  // namespace

void merge_precision_overloads(TokenText& text) {
  const std::vector<OverloadedFunction> functions = overloaded_functions(text);
  std::unordered_map<std::string, Overloads> groups;
  for (const OverloadedFunction& function : functions)
    groups[widened_signature(function)].push_back(&function);
  std::unordered_map<std::string, const OverloadedFunction*> kept;
  std::vector<bool> reached;  // computed when a group asks for it
  for (const OverloadedFunction& function : functions) {
    const OverloadedFunction*& best = kept[widened_signature(function)];
    if (best == nullptr) best = kept_overload(text, groups[widened_signature(function)], reached);
    if (function.parameters == best->parameters)
      continue;  // itself, or a definition with identical parameter types
    drop(text, function, *best, reached);
  }
  text.apply();
}

}  // namespace penumbra::preparation
