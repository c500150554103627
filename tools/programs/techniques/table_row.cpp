#include "techniques/table_row.h"

#include <array>
#include <charconv>
#include <stdexcept>

#include "input/text_line.h"

namespace penumbra::techniques {

std::string table_number(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), static_cast<float>(value)).ptr;
  return {text.data(), end};
}

TableRow::TableRow(const std::string& kind) : text_(kind) {}

TableRow& TableRow::add(std::string_view column) {
  if (!is_one_line(column)) throw std::invalid_argument("a column of a table is one line without tabs");
  text_.append("\t").append(column);
  return *this;
}

TableRow& TableRow::option(const std::string& name, const std::string& value) {
  return value.empty() ? *this : add(name + "=" + value);
}

TableRow& TableRow::option(const std::string& name, int value, int otherwise) {
  return value == otherwise ? *this : add(name + "=" + std::to_string(value));
}

TableRow& TableRow::option(const std::string& name, bool is_set) {
  return is_set ? add(name) : *this;
}

}  // namespace penumbra::techniques
