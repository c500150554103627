#include "preparation/number_shape.h"

#include <algorithm>

#include "preparation/declarators.h"

namespace penumbra::preparation {

namespace {

using Base = NumberShape::Base;

Base base_of(std::string_view scalar) {
  if (scalar == "bool") return Base::boolean;
  if (scalar == "uint" || scalar == "min16uint" || scalar == "dword") return Base::natural;
  return scalar == "int" || scalar == "min16int" || scalar == "min12int" ? Base::integer : Base::real;
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

std::size_t components(std::string_view type) {
  const NumberShape shape = shape_of_type(type);
  return static_cast<std::size_t>(std::max(shape.rows, 1) * std::max(shape.columns, 1));
}

}  // namespace penumbra::preparation
