#include "preparation/number_shape.h"

#include <algorithm>
#include <charconv>

#include "preparation/declarators.h"

namespace penumbra::preparation {

namespace {

using Base = NumberShape::Base;

Base base_of(std::string_view scalar) {
  if (scalar == "bool") return Base::boolean;
  if (scalar == "uint" || scalar == "min16uint" || scalar == "dword") return Base::natural;
  return scalar == "int" || scalar == "min16int" || scalar == "min12int" ? Base::integer : Base::real;
}

constexpr std::size_t most_numbers = 4096;
constexpr int deepest_value = 16;

std::optional<ValueShape> shape_of_named(const TokenText& text, std::string_view type, int depth);

std::optional<ValueShape> shape_of_value(const TokenText& text, const DeclaredValue& value, int depth) {
  std::optional<ValueShape> element = shape_of_named(text, value.type.name, depth);
  std::vector<std::size_t> sizes;
  for (std::size_t at = value.name + 1; element && at < value.end; at += 3) {
    std::size_t size = 0;
    const std::string_view number = at + 2 < value.end ? text.word(at + 1) : std::string_view();
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

std::optional<ValueShape> shape_of_named(const TokenText& text, std::string_view type, int depth) {
  if (is_number_type(type)) return ValueShape{type, components(type), {}};
  const StructType* known = text.types().find_struct(type);
  if (known == nullptr || depth > deepest_value || !known->base.empty()) return std::nullopt;
  ValueShape shape{type, 0, {}};
  for (const std::size_t index : known->members) {
    std::optional<ValueShape> member = shape_of_value(text, text.types().declared()[index], depth + 1);
    if (!member) return std::nullopt;
    shape.numbers += member->numbers;
    if (shape.numbers > most_numbers) return std::nullopt;
    shape.parts.push_back(*std::move(member));
  }
  return shape.parts.empty() ? std::nullopt : std::optional(shape);
}

}  // namespace

NumberShape shape_of_type(std::string_view type) {
  if (!is_number_type(type)) return {};
  const auto digit = [&](std::size_t from_end) { return type[type.size() - from_end] - '0'; };
  const bool sized = type.back() >= '1' && type.back() <= '4';
  if (!sized) return {base_of(type)};
  const bool matrix = type.size() > 3 && type[type.size() - 2] == 'x';
  const Base base = base_of(type.substr(0, type.size() - (matrix ? 3 : 1)));
  return matrix ? NumberShape{base, digit(3), digit(1)} : NumberShape{base, 0, digit(1)};
}

NumberShape shape_of_number(std::string_view number) {
  const bool hexadecimal = number.size() > 1 && (number[1] == 'x' || number[1] == 'X');
  if (!hexadecimal && number.find_first_of(".eEfFhH") != std::string_view::npos) return {Base::real};
  return {number.find_first_of("uU") != std::string_view::npos ? Base::natural : Base::integer};
}

std::string type_of_shape(const NumberShape& shape) {
  std::string type = shape.base == Base::boolean   ? "bool"
                     : shape.base == Base::integer ? "int"
                     : shape.base == Base::natural ? "uint"
                                                   : "float";
  if (shape.rows > 0) type += std::to_string(shape.rows) + "x";
  if (shape.columns > 0) type += std::to_string(shape.columns);
  return type;
}

NumberShape combined_shape(const NumberShape& a, const NumberShape& b) {
  if (!a.known() || !b.known()) return {};
  const Base base = std::max({a.base, b.base, Base::integer});
  if (a.is_scalar()) return b.of_base(base);
  if (b.is_scalar()) return a.of_base(base);
  if (a.is_matrix() != b.is_matrix()) return {};
  return {base, std::min(a.rows, b.rows), std::min(a.columns, b.columns)};
}

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
