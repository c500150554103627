#include "preparation/resource_arrays.h"

#include <algorithm>
#include <string>

#include "preparation/resource_types.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

bool is_handle(const ValueType& type) {
  return is_texture(type.name) || is_sampler(type.name);
}

void assign_elements(TokenText& text, const DeclaredValue& value) {
  const std::size_t open = value.end + 1;
  const std::size_t close = text.matching_bracket(open);
  const bool alone = value.first != npos && close != npos && text.is(close + 1, ";");
  if (!text.is(value.end, "=") || !text.is(open, "{") || !alone || value.type.dimensions > 1) return;
  const std::string name(text[value.name].spelling);
  std::string assignments;
  int index = 0;
  for (std::size_t first = open + 1; first < close; ++index) {
    std::size_t end = first;
    while (end < close && !text.is(end, ",")) {
      const std::size_t match = text.matching_bracket(end);
      end = match == npos || match < end ? end + 1 : match + 1;
    }
    assignments.append(" ").append(name);
    if (value.type.dimensions > 0) assignments.append("[").append(std::to_string(index)).append("]");
    assignments.append(" = ").append(text.spelled(first, end - first)).append(";");
    first = end + 1;
  }
  const bool sized = value.type.dimensions == 0 || !text.is(value.end - 2, "[");
  text.erase(value.end, close + 1 - value.end);
  if (!sized) text.insert(value.end - 1, std::to_string(index));
  text.insert(close + 2, assignments);
}

// Returns whether `c ? a : b).Load(` stands at the end of b.
bool reads_a_choice(const TokenText& text, const ValueTypes& types, std::size_t at) {
  if (!text.is(at + 1, ")") || !text.is(at + 2, ".")) return false;
  const std::size_t first = types.begin(at);
  return is_texture(types.at(at).name) && first != npos && first > 0 && text.is(first - 1, ":");
}

}  // namespace

void assign_resource_arrays(TokenText& text) {
  const ValueTypes& types = text.types();
  for (const DeclaredValue& value : types.declared())
    if (value.place == DeclaredValue::Place::local && !value.is_static && is_handle(value.type))
      assign_elements(text, value);
  for (std::size_t at = 0; at < text.size(); ++at)
    if (reads_a_choice(text, types, at))
      text.note(at, hlsl::Severity::error,
                "a texture is selected at run time, which HLSL does not allow; read both and select between "
                "the results");
  text.apply();
}

}  // namespace penumbra::preparation
