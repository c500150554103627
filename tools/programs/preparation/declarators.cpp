#include "preparation/declarators.h"

#include "hlsl/name_set.h"

namespace penumbra::preparation {

namespace {

bool is_storage_modifier(std::string_view word) {
  static constexpr hlsl::NameSet modifiers("static", "const", "uniform", "extern", "precise", "groupshared",
                                           "volatile", "row_major", "column_major", "snorm", "unorm",
                                           "linear", "centroid", "shared", "sample", "nointerpolation",
                                           "noperspective", "inline", "globallycoherent");
  return modifiers.contains(word);
}

// Skips `<...>`; returns the index after it.
std::size_t skip_angles(const TokenText& text, std::size_t at, std::size_t last) {
  int depth = 0;
  for (; at < last; ++at) {
    if (text.is(at, "<")) ++depth;
    if (text.is(at, ">") && --depth == 0) return at + 1;
  }
  return last;
}

// Skips to the ',' or ';' that ends a declarator.
std::size_t skip_to_end(const TokenText& text, std::size_t at, std::size_t last) {
  while (at < last && !text.is(at, ",")) at = text.after(at);
  return std::min(at, last);
}

}  // namespace

std::vector<Declarator> declarators(const TokenText& text, std::size_t first, std::size_t last) {
  std::vector<Declarator> found;
  Declarator common;
  std::size_t at = first;
  at = text.after_subscripts(at);
  for (; at < last && text.is_identifier(at) && is_storage_modifier(text.word(at)); ++at) {
    common.is_static = common.is_static || text.is(at, "static");
    common.is_const = common.is_const || text.is(at, "const");
    common.is_groupshared = common.is_groupshared || text.is(at, "groupshared");
  }
  if (!text.is_identifier(at)) return {};
  const std::size_t type = at++;
  if (text.is(type, "struct")) ++at;
  if (text.is(at, "<")) at = skip_angles(text, at, last);
  common.type = text.spelled(type, at - type);
  while (at < last) {
    if (!text.is_identifier(at)) return {};
    Declarator declarator = common;
    declarator.name = at++;
    declarator.dimensions = at;
    while (at < last && text.is(at, "[") && text.matching_bracket(at) != npos)
      at = text.matching_bracket(at) + 1;
    declarator.dimension_count = at - declarator.dimensions;
    if (text.is(at, "(")) return {};                       // a function
    while (at < last && !text.is_any(at, ",", "=")) ++at;  // : register(c1)
    if (text.is(at, "=")) declarator.initialiser = at + 1;
    at = skip_to_end(text, at, last);
    declarator.end = at++;
    found.push_back(std::move(declarator));
  }
  return found;
}

bool is_number_type(std::string_view word) {
  static constexpr hlsl::NameSet scalars("float", "half", "int", "uint", "bool", "double", "min16float",
                                         "min10float", "min16int", "min12int", "min16uint", "dword");
  const auto size = [](char c) { return c >= '1' && c <= '4'; };
  if (!word.empty() && size(word.back())) {  // no scalar ends with a number
    const std::size_t length = word.size();
    const bool matrix = length > 3 && word[length - 2] == 'x' && size(word[length - 3]);
    word.remove_suffix(matrix ? 3 : 1);
  }
  return scalars.contains(word);
}

}  // namespace penumbra::preparation
