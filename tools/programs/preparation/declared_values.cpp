#include "preparation/declared_values.h"

#include "hlsl/name_set.h"

namespace penumbra::preparation {

namespace {

constexpr std::size_t longest_template = 12;  // tokens of Texture2DMS<float4, 4>, with room

// Reads a declarator from its name; returns the ',' ';' or end after it.
std::size_t read_declarator(const TokenText& text, std::size_t at, std::size_t end, DeclaredValue value,
                            std::vector<DeclaredValue>& to) {
  const bool named = at < end && text.is_identifier(at);
  if (named) value.name = at++;
  for (; at < end && text.is(at, "["); at = text.after(at)) ++value.type.dimensions;
  value.end = at;
  while (at < end && !text.is_any(at, ";", ",")) at = text.after(at);
  value.last = at;
  const bool unnamed_parameter = value.place == DeclaredValue::Place::parameter && value.type_at != npos;
  if (named || unnamed_parameter) to.push_back(value);
  return at;
}

// Skips modifiers and type; returns where the first name should be.
std::size_t read_type(const TokenText& text, const DeclarationRange& range, DeclaredValue& value) {
  std::size_t at = range.first;
  while (at < range.end && text.is(at, "[")) at = text.after(at);
  for (; at < range.end && is_modifier(text.word(at)); ++at) {
    value.type.constant = value.type.constant || text.is(at, "const");
    value.is_static = value.is_static || text.is(at, "static");
    value.is_groupshared = value.is_groupshared || text.is(at, "groupshared");
  }
  value.type.name = range.type;
  if (!range.type.empty()) return at;
  if (at < range.end && text.is(at, "struct")) ++at;
  if (at >= range.end || !text.is_identifier(at)) return at;
  value.type_at = at;
  value.type.name = text.word(at);
  value.type_end = after_template(text, at + 1, range.end);
  if (value.type_end > at + 1 && text.is_identifier(at + 2)) value.type.element = text.word(at + 2);
  return value.type_end;
}

}  // namespace

bool is_modifier(std::string_view word) {
  static constexpr hlsl::NameSet modifiers(
      "in", "out", "inout", "const", "uniform", "static", "extern", "precise", "linear", "centroid", "sample",
      "nointerpolation", "noperspective", "volatile", "shared", "groupshared", "snorm", "unorm", "row_major",
      "column_major", "unsigned", "globallycoherent", "inline");
  return modifiers.contains(word);
}

bool has_modifier(const TokenText& text, const DeclaredValue& value, std::string_view modifier) {
  if (value.first == npos || value.type_at == npos) return false;
  return text.has(value.first, value.type_at, modifier);
}

bool is_written_parameter(const TokenText& text, const DeclaredValue& parameter) {
  return has_modifier(text, parameter, "out") || has_modifier(text, parameter, "inout");
}

std::size_t after_template(const TokenText& text, std::size_t at, std::size_t end) {
  if (!text.is(at, "<")) return at;
  int depth = 0;
  for (std::size_t i = at; i < std::min(end, at + longest_template); ++i) {
    const bool argument = text.is_identifier(i) || text.is(i, ",") || text.is_number(i);
    if (!argument && !text.is_any(i, "<", ">")) return at;  // a comparison
    depth += text.is(i, "<") ? 1 : text.is(i, ">") ? -1 : 0;
    if (depth == 0) return i + 1;
  }
  return at;
}

std::size_t read_declaration(const TokenText& text, const DeclarationRange& range,
                             std::vector<DeclaredValue>& to) {
  DeclaredValue value;
  value.place = range.place;
  value.first = range.first;
  const bool parameter = range.place == DeclaredValue::Place::parameter;
  std::size_t at = read_type(text, range, value);
  if (at >= range.end && parameter) read_declarator(text, at, range.end, value, to);
  while (at < range.end) {
    at = read_declarator(text, at, range.end, value, to);
    const bool more = at < range.end && text.is(at, ",") && !parameter;
    if (!more) return at + 1;
    ++at;
    value.first = npos;
  }
  return range.end;
}

}  // namespace penumbra::preparation
