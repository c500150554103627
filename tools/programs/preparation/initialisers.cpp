#include <algorithm>
#include <charconv>
#include <unordered_set>

#include "preparation/declarators.h"
#include "preparation/number_shape.h"
#include "preparation/passes.h"
#include "preparation/postfix_expression.h"
#include "preparation/source_checks.h"
#include "preparation/token_text.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

// The values of an initialiser list.

// An expression of a list, without the braces around it.
struct ListedValue : ListElement {
  std::size_t numbers = 0;  // 0 if not known
};

// Returns the numbers in the chain that ends here.
std::size_t numbers_in(const TokenText& text, std::size_t last) {
  const ValueType& type = text.types().at(last);
  if (type.dimensions > 0) return 0;
  if (is_number_type(type.name)) return components(type.name);
  const std::size_t index = text.types().named(last);
  if (index == npos || text.types().find_struct(type.name) == nullptr) return 0;
  const std::optional<ValueShape> shape = shape_of(text, text.types().declared()[index]);
  return shape ? shape->numbers : 0;
}

// Returns whether it is `.xyz` of a vector.
bool is_swizzle(const TokenText& text, std::size_t first, std::size_t last) {
  if (last < first + 2 || !text.is(last - 1, ".")) return false;
  const bool letters =
      text.word(last).size() <= 4 && text.word(last).find_first_not_of("xyzwrgba") == std::string_view::npos;
  const ValueType& of = text.types().at(last - 2);
  return letters && text.types().begin(last - 2) == first && of.dimensions == 0 && is_number_type(of.name) &&
         of.name.find('x') == std::string_view::npos;
}

// Returns the number of scalars in the expression [first, end); 0 if unknown.
std::size_t numbers_of(const TokenText& text, std::size_t first, std::size_t end) {
  while (text.is_any(first, "-", "+")) ++first;
  if (first + 1 == end && text.is_number(first)) return 1;
  if (!text.is_identifier(first)) return 0;
  const std::string_view word = text.word(first);
  if (is_number_type(word) && text.is(first + 1, "("))
    return text.matching_bracket(first + 1) == end - 1 ? components(word) : 0;
  const std::size_t last = end - 1;
  if (postfix_end(text, first) != end) return 0;
  if (text.types().begin(last) == first && !text.types().at(last).name.empty()) return numbers_in(text, last);
  return is_swizzle(text, first, last) ? text.word(last).size() : 0;
}

void append_flat(const TokenText& text, std::size_t open, std::vector<ListedValue>& to) {
  for (const ListElement& element : list_elements(text, open)) {
    if (text.is(element.first, "{"))
      append_flat(text, element.first, to);
    else
      to.push_back({element, numbers_of(text, element.first, element.end)});
  }
}

// Returns the values between the '{' at `open`, which must have a match, and its match, including those of
// nested lists.
std::vector<ListedValue> flat_values(const TokenText& text, std::size_t open) {
  std::vector<ListedValue> values;
  append_flat(text, open, values);
  return values;
}

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

// Returns the sizes [2][3]; empty if one is not a literal. `at` is the first '[' and advances past the last
// ']'.
std::vector<std::size_t> sizes(const TokenText& text, std::size_t& at) {
  std::vector<std::size_t> list;
  for (; text.is(at, "["); at += 3) {
    std::size_t size = 0;
    if (at + 2 >= text.size() || !text.is(at + 2, "]")) return {};
    const std::string_view number = text.word(at + 1);
    if (std::from_chars(number.data(), number.data() + number.size(), size).ec != std::errc() || size == 0)
      return {};
    list.push_back(size);
  }
  return list;
}

// Returns the first token of each element of the list between the braces; empty when one is itself a list.
std::vector<std::size_t> elements(const TokenText& text, std::size_t open) {
  std::vector<std::size_t> firsts;
  bool at_start = true;
  for (std::size_t at = open + 1; at < text.matching_bracket(open); ++at) {
    if (at_start && text.is(at, "{")) return {};
    if (at_start) firsts.push_back(at);
    at_start = text.is(at, ",");
    if (text.matching_bracket(at) != npos && text.matching_bracket(at) > at) at = text.matching_bracket(at);
  }
  return firsts;
}

void group(TokenText& text, std::size_t open, const std::vector<std::size_t>& firsts, std::size_t run) {
  for (std::size_t i = 0; i < firsts.size(); i += run) {
    text.insert(firsts[i], "{");
    const bool last = i + run >= firsts.size();
    std::size_t end = last ? text.matching_bracket(open) : firsts[i + run] - 1;
    if (last && text.is(end - 1, ",")) --end;
    text.insert(end, "}");
  }
}

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
  const std::size_t wanted = components(text.word(type));
  const std::size_t close = text.matching_bracket(type + 1);
  if (wanted < 2 || close == npos) return;
  std::size_t given = 0;
  for (const ListElement& argument : list_elements(text, type + 1)) {
    const std::size_t numbers = numbers_of(text, argument.first, argument.end);
    if (numbers == 0) return;
    given += numbers;
  }
  if (given == 0 || given >= wanted) return;
  const std::string name = text.name(type);
  text.error(type, "the constructor " + name + " takes " + std::to_string(wanted) + " numbers, and has " +
                       std::to_string(given) + (given == 1 ? "; to repeat it, write (" + name + ")x" : ""));
}

}  // namespace

// Initialiser lists of structs and of arrays of structs. HLSL fills the scalars of a value in order, whatever
// the braces: `struct Ray { float3 origin; float t; }; Ray r = { 0, 0, 0, 1 };`. glslang expects one list
// element per member. A list of another form is rewritten with one element per member: `{ float3(0, 0, 0), 1
// }`.
//
// An element that is split among members must be a vector without side effects: no call, ++ or -- in it. The
// number of scalars of every element must be known: for literals, constructors, and values that value_types.h
// knows; for one element of another kind it follows from the others.
void match_struct_initialisers(TokenText& text) {
  const ValueTypes& types = text.types();
  if (types.structs().empty()) return;
  for (const DeclaredValue& value : types.declared()) {
    const std::size_t open = value.end == npos ? npos : value.end + 1;
    if (value.name == npos || types.find_struct(value.type.name) == nullptr) continue;
    if (!text.is(value.end, "=") || !text.is(open, "{") || text.matching_bracket(open) == npos) continue;
    const std::optional<ValueShape> shape = shape_of(text, value);
    if (!shape || !holds_structs(*shape)) continue;
    if (const std::optional<std::string> list = List(text, *shape, open).matched())
      text.replace(open, text.matching_bracket(open) - open + 1, *list);
  }
  text.apply();
}

// Arrays with a flat initialiser list, `float2 a[2] = { 1, 2, 3, 4 };` and `float b[2][3] = { 1, 2, 3, 4, 5,
// 6 };`: HLSL fills the components in order; glslang expects one list element per array element. If the sizes
// are literals and the list has exactly one element per component, braces are put around those of each array
// element.
void group_flat_initialisers(TokenText& text) {
  for (std::size_t type = 0; type + 2 < text.size(); ++type) {
    if (!text.is(type + 2, "[") || !text.is_identifier(type) || !text.is_identifier(type + 1)) continue;
    if (!is_number_type(text.word(type))) continue;
    std::size_t at = type + 2;
    const std::vector<std::size_t> dimensions = sizes(text, at);
    if (dimensions.empty() || !text.is(at, "=") || !text.is(at + 1, "{") ||
        text.matching_bracket(at + 1) == npos)
      continue;
    std::size_t run = components(text.word(type));  // numbers of an element of the first dimension
    for (std::size_t i = 1; i < dimensions.size(); ++i) run *= dimensions[i];
    const std::vector<std::size_t> firsts = elements(text, at + 1);
    const bool deeper = dimensions.size() > 2 || (dimensions.size() == 2 && components(text.word(type)) > 1);
    if (run > 1 && !deeper && firsts.size() == run * dimensions[0]) group(text, at + 1, firsts, run);
  }
  text.apply();
}

void check_constructor_counts(TokenText& text) {
  for (std::size_t at = 0; at + 1 < text.size(); ++at)
    if (text.is(at + 1, "(") && text.is_identifier(at) && is_number_type(text.word(at)))
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
      text.error(value.name, "'" + text.name(value.name) + "' " + problem +
                                 "; give it one value for each, or cast one to the whole type");
  }
}

void check_struct_constructors(TokenText& text) {
  const ValueTypes& types = text.types();
  std::unordered_set<std::string_view> functions;
  for (const FunctionType& function : types.functions()) functions.insert(text.word(function.name));
  for (std::size_t at = 1; at + 1 < text.size(); ++at) {
    if (!text.is_identifier(at) || !text.is(at + 1, "(") || types.begin(at) == npos) continue;
    const std::string_view name = text.word(at);
    if (types.find_struct(name) == nullptr || functions.contains(name)) continue;
    text.error(at, "HLSL has no constructors of structs: write " + std::string(name) +
                       " value = {...}; or assign the members of a '" + std::string(name) + "' one by one");
  }
}

}  // namespace penumbra::preparation
