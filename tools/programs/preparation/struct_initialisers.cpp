#include "preparation/struct_initialisers.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "preparation/list_elements.h"
#include "preparation/listed_values.h"
#include "preparation/postfix_expression.h"
#include "preparation/value_shape.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

class List {
 public:
  List(const TokenText& text, const ValueShape& shape, std::size_t open)
      : text_(text), shape_(shape), open_(open) {}

  // Returns the list in glslang's form; nothing if it already has it, or cannot be rewritten.
  std::optional<std::string> matched() {
    if (matches(shape_, open_)) return std::nullopt;
    elements_ = flat_values(text_, open_);
    if (!count_numbers()) return std::nullopt;
    std::string written = write(shape_, true);
    return failed_ || at_ != elements_.size() ? std::nullopt : std::optional(written);
  }

 private:
  bool is_list(const ListElement& element) const { return text_.is(element.first, "{"); }

  bool matches(const ValueShape& shape, std::size_t open) const {
    const std::vector<ListElement> elements = list_elements(text_, open);
    if (shape.parts.empty()) return true;
    if (elements.size() != shape.parts.size()) return false;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const ValueShape& part = shape.parts[i];
      if (is_list(elements[i])) {
        if (!matches(part, elements[i].first)) return false;
        continue;
      }
      const std::size_t numbers = numbers_of(text_, elements[i].first, elements[i].end);
      const bool spread = numbers == 1 && part.parts.empty();  // a number for all components
      if (numbers != 0 && numbers != part.numbers && !spread) return false;
    }
    return true;
  }

  // Returns whether the elements have as many scalars as the value; if one element's number is unknown, it
  // gets the rest.
  bool count_numbers() {
    std::size_t known = 0;
    std::size_t unknown = 0;
    for (const ListedValue& element : elements_) {
      known += element.numbers;
      unknown += element.numbers == 0 ? 1 : 0;
    }
    if (unknown == 0) return known == shape_.numbers;
    const bool all_single = known + unknown == shape_.numbers;
    if (!all_single && (unknown > 1 || known >= shape_.numbers)) return false;
    for (ListedValue& element : elements_)
      if (element.numbers == 0) element.numbers = all_single ? 1 : shape_.numbers - known;
    return true;
  }

  std::string spelled(const ListedValue& element) const {
    return text_.spelled(element.first, element.end - element.first);
  }

  // Writes one struct member or array element, from the next elements.
  std::string write(const ValueShape& shape, bool outermost) {
    if (failed_ || at_ >= elements_.size()) {
      failed_ = true;
      return {};
    }
    const bool whole = used_ == 0 && elements_[at_].numbers == shape.numbers && !outermost;
    if (whole && (shape.parts.empty() || is_of_type(elements_[at_], shape.type)))
      return spelled(elements_[at_++]);
    if (shape.parts.empty()) return write_numbers(shape);
    std::string list = "{ ";
    for (const ValueShape& part : shape.parts) list += write(part, false) + ", ";
    list.replace(list.size() - 2, 1, " }");
    return list;
  }

  bool is_of_type(const ListedValue& element, std::string_view type) const {
    const std::size_t last = element.end - 1;
    return text_.types().begin(last) == element.first && text_.types().at(last).is(type);
  }

  std::string write_numbers(const ValueShape& shape) {
    std::string list = std::string(shape.type) + "(";
    for (std::size_t left = shape.numbers; left > 0 && !failed_;) {
      if (at_ >= elements_.size()) failed_ = true;
      if (failed_) break;
      const ListedValue& element = elements_[at_];
      const std::size_t taken = std::min(left, element.numbers - used_);
      list += part_of(element, taken) + (taken == left ? ")" : ", ");
      used_ += taken;
      left -= taken;
      if (used_ == element.numbers) {
        used_ = 0;
        ++at_;
      }
    }
    return list;
  }

  std::string part_of(const ListedValue& element, std::size_t taken) {
    if (taken == element.numbers) return spelled(element);
    const bool can_be_split = element.numbers <= 4 && may_be_repeated(text_, element.first, element.end);
    if (!can_be_split) failed_ = true;
    if (failed_) return {};
    return "(" + spelled(element) + ")." + std::string("xyzw").substr(used_, taken);
  }

  const TokenText& text_;
  const ValueShape& shape_;
  const std::size_t open_;
  std::vector<ListedValue> elements_;
  std::size_t at_ = 0;    // index in elements_
  std::size_t used_ = 0;  // numbers of that element
  bool failed_ = false;
};

bool holds_structs(const ValueShape& shape) {
  if (!shape.type.empty()) return !shape.parts.empty();
  return !shape.parts.empty() && holds_structs(shape.parts.front());
}

}  // namespace

void match_struct_initialisers(TokenText& text) {
  const ValueTypes& types = text.types();
  if (types.structs().empty()) return;
  for (const DeclaredValue& value : types.declared()) {
    const std::size_t open = value.end == npos ? npos : value.end + 1;
    if (value.name == npos || types.structs().count(value.type.name) == 0) continue;
    if (!text.is(value.end, "=") || !text.is(open, "{") || text.matching_bracket(open) == npos) continue;
    const std::optional<ValueShape> shape = shape_of(text, value);
    if (!shape || !holds_structs(*shape)) continue;
    if (const std::optional<std::string> list = List(text, *shape, open).matched())
      text.replace(open, text.matching_bracket(open) - open + 1, *list);
  }
  text.apply();
}

}  // namespace penumbra::preparation
