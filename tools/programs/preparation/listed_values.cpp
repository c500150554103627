#include "preparation/listed_values.h"

#include <optional>
#include <string_view>

#include "preparation/declarators.h"
#include "preparation/postfix_expression.h"
#include "preparation/value_shape.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

// Returns the numbers in the chain that ends here.
std::size_t numbers_in(const TokenText& text, std::size_t last) {
  const ValueType& type = text.types().at(last);
  if (type.dimensions > 0) return 0;
  if (is_number_type(type.name)) return components(type.name);
  const std::size_t index = text.types().named(last);
  if (index == npos || text.types().structs().count(type.name) == 0) return 0;
  const std::optional<ValueShape> shape = shape_of(text, text.types().declared()[index]);
  return shape ? shape->numbers : 0;
}

// Returns whether it is `.xyz` of a vector.
bool is_swizzle(const TokenText& text, std::size_t first, std::size_t last) {
  if (last < first + 2 || !text.is(last - 1, ".")) return false;
  const bool letters = text[last].spelling.size() <= 4 &&
                       text[last].spelling.find_first_not_of("xyzwrgba") == std::string_view::npos;
  const ValueType& of = text.types().at(last - 2);
  return letters && text.types().begin(last - 2) == first && of.dimensions == 0 && is_number_type(of.name) &&
         of.name.find('x') == std::string_view::npos;
}

void append_flat(const TokenText& text, std::size_t open, std::vector<ListedValue>& to) {
  for (const ListElement& element : list_elements(text, open)) {
    if (text.is(element.first, "{"))
      append_flat(text, element.first, to);
    else
      to.push_back({element, numbers_of(text, element.first, element.end)});
  }
}

}  // namespace

std::vector<ListedValue> flat_values(const TokenText& text, std::size_t open) {
  std::vector<ListedValue> values;
  append_flat(text, open, values);
  return values;
}

std::size_t numbers_of(const TokenText& text, std::size_t first, std::size_t end) {
  while (text.is(first, "-") || text.is(first, "+")) ++first;
  if (first + 1 == end && text[first].kind == hlsl::Token::Kind::number) return 1;
  if (!text.is_identifier(first)) return 0;
  const std::string_view word = text[first].spelling;
  if (is_number_type(word) && text.is(first + 1, "("))
    return text.matching_bracket(first + 1) == end - 1 ? components(word) : 0;
  const std::size_t last = end - 1;
  if (postfix_end(text, first) != end) return 0;
  if (text.types().begin(last) == first && !text.types().at(last).name.empty()) return numbers_in(text, last);
  return is_swizzle(text, first, last) ? text[last].spelling.size() : 0;
}

}  // namespace penumbra::preparation
