#include <optional>
#include <string>
#include <vector>

#include "preparation/declarators.h"
#include "preparation/listed_values.h"
#include "preparation/source_checks.h"
#include "preparation/value_shape.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

std::string counted(std::size_t numbers) {
  return std::to_string(numbers) + (numbers == 1 ? " number" : " numbers");
}

// Describes the problem with a list for a value of `wanted` numbers; empty if there is none, or it is
// unknown.
std::string problem_of(const std::vector<ListedValue>& values, std::size_t wanted) {
  std::size_t least = 0;
  bool all_known = true;
  for (const ListedValue& value : values) {
    least += value.numbers == 0 ? 1 : value.numbers;
    all_known = all_known && value.numbers != 0;
  }
  if (values.empty() || (least <= wanted && !(all_known && least < wanted))) return {};
  return "holds " + counted(wanted) + ", and its initialiser has " + (all_known ? "" : "at least ") +
         std::to_string(least);
}

// Checks `float3(1, 2)`, `float4(0)`: fewer numbers than the type has. glslang itself reports too many.
void check_constructor(TokenText& text, std::size_t type) {
  const std::size_t wanted = components(text[type].spelling);
  const std::size_t close = text.matching_bracket(type + 1);
  if (wanted < 2 || close == npos) return;
  std::size_t given = 0;
  for (const ListElement& argument : list_elements(text, type + 1)) {
    const std::size_t numbers = numbers_of(text, argument.first, argument.end);
    if (numbers == 0) return;
    given += numbers;
  }
  if (given == 0 || given >= wanted) return;
  const std::string name(text[type].spelling);
  text.note(type, hlsl::Severity::error,
            "the constructor " + name + " takes " + std::to_string(wanted) + " numbers, and has " +
                std::to_string(given) + (given == 1 ? "; to repeat it, write (" + name + ")x" : ""));
}

}  // namespace

void check_constructor_counts(TokenText& text) {
  for (std::size_t at = 0; at + 1 < text.size(); ++at)
    if (text.is(at + 1, "(") && text.is_identifier(at) && is_number_type(text[at].spelling))
      check_constructor(text, at);
}

void check_initialiser_counts(TokenText& text) {
  for (const DeclaredValue& value : text.types().declared()) {
    if (value.name == npos || !text.is(value.end, "=") || !text.is(value.end + 1, "{")) continue;
    if (text.matching_bracket(value.end + 1) == npos) continue;
    const std::optional<ValueShape> shape = shape_of(text, value);
    if (!shape) continue;
    const std::string problem = problem_of(flat_values(text, value.end + 1), shape->numbers);
    if (!problem.empty())
      text.note(value.name, hlsl::Severity::error,
                "'" + std::string(text[value.name].spelling) + "' " + problem +
                    "; give it one value for each, or cast one to the whole type");
  }
}

}  // namespace penumbra::preparation
