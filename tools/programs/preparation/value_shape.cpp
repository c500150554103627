#include "preparation/value_shape.h"

#include <charconv>

#include "preparation/declarators.h"

namespace penumbra::preparation {

namespace {

constexpr std::size_t most_numbers = 4096;
constexpr int deepest = 16;

std::optional<ValueShape> shape_of_type(const TokenText& text, std::string_view type, int depth);

std::optional<ValueShape> shape_of_value(const TokenText& text, const DeclaredValue& value, int depth) {
  std::optional<ValueShape> element = shape_of_type(text, value.type.name, depth);
  std::vector<std::size_t> sizes;
  for (std::size_t at = value.name + 1; element && at < value.end; at += 3) {
    std::size_t size = 0;
    const std::string_view number = at + 2 < value.end ? text[at + 1].spelling : std::string_view();
    const auto read = std::from_chars(number.data(), number.data() + number.size(), size);
    const bool plain = text.is(at, "[") && text.is(at + 2, "]") && read.ec == std::errc();
    if (!plain || size == 0 || size > most_numbers) return std::nullopt;
    sizes.push_back(size);
  }
  for (auto size = sizes.rbegin(); element && size != sizes.rend(); ++size) {
    ValueShape array;
    array.numbers = element->numbers * *size;
    if (array.numbers > most_numbers) return std::nullopt;
    array.parts.assign(*size, *element);
    element = std::move(array);
  }
  return element;
}

std::optional<ValueShape> shape_of_type(const TokenText& text, std::string_view type, int depth) {
  if (is_number_type(type)) return ValueShape{type, components(type), {}};
  const auto known = text.types().structs().find(type);
  if (known == text.types().structs().end() || depth > deepest || !known->second.base.empty())
    return std::nullopt;
  ValueShape shape{type, 0, {}};
  for (const std::size_t index : known->second.members) {
    std::optional<ValueShape> member = shape_of_value(text, text.types().declared()[index], depth + 1);
    if (!member) return std::nullopt;
    shape.numbers += member->numbers;
    if (shape.numbers > most_numbers) return std::nullopt;
    shape.parts.push_back(*std::move(member));
  }
  return shape.parts.empty() ? std::nullopt : std::optional(shape);
}

}  // namespace

std::size_t components(std::string_view type) {
  const auto size = [](char c) { return static_cast<std::size_t>(c - '0'); };
  const std::size_t digits = type.find_last_not_of("1234x") + 1;
  const std::string_view shape = type.substr(digits);
  if (shape.size() == 1) return size(shape[0]);
  return shape.size() == 3 ? size(shape[0]) * size(shape[2]) : 1;
}

std::optional<ValueShape> shape_of(const TokenText& text, const DeclaredValue& value) {
  return shape_of_value(text, value, 0);
}

}  // namespace penumbra::preparation
