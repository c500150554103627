#include <algorithm>
#include <map>
#include <utility>

#include "hlsl/declarations.h"
#include "preparation/number_shape.h"
#include "preparation/passes.h"
#include "preparation/postfix_expression.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

bool is_zero(const TokenText& text, std::size_t at) {
  return at < text.size() && text.is_number(at) &&
         text.word(at).find_first_not_of("0.fFhHuU") == std::string_view::npos;
}

// Returns the '0' of `(type[2][3])0` if such a cast begins at this '('; else npos.
std::size_t cast_zero(const TokenText& text, std::size_t open) {
  if (!text.is(open, "(") || !text.is_identifier(open + 1) || !text.is(open + 2, "[")) return npos;
  std::size_t at = open + 2;
  while (text.is(at, "[") && text.matching_bracket(at) != npos && !text.is(at + 1, "]"))
    at = text.matching_bracket(at) + 1;
  return text.is(at, ")") && is_zero(text, at + 1) ? at + 1 : npos;
}

class ArrayCasts {
 public:
  explicit ArrayCasts(TokenText& text) : text_(text) {}

  void run() {
    for (const hlsl::Declaration& declaration : text_.declarations())
      for (std::size_t at = declaration.first; at <= declaration.last; ++at) rewrite(at, declaration.first);
    text_.apply();
  }

 private:
  void rewrite(std::size_t open, std::size_t before) {
    const std::size_t zero = cast_zero(text_, open);
    if (zero == npos) return;
    const std::string type = text_.name(open + 1);
    const std::string sizes = text_.spelled(open + 2, zero - open - 3);
    const auto [known, added] = structs_.emplace(type + " " + sizes, std::string{});
    if (added) {
      known->second = text_.free_name("penumbra_zeroes" + std::to_string(structs_.size() - 1));
      text_.insert(before, "struct " + known->second + " { " + type + " value" + sizes + "; }; ");
    }
    text_.replace(open, zero - open + 1, "((" + known->second + ")0).value");
  }

  TokenText& text_;
  std::map<std::string, std::string> structs_;  // by type and sizes
};

class StructCasts {
 public:
  explicit StructCasts(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    for (std::size_t at = 1; at + 3 < text_.size(); ++at)
      if (text_.is(at, "(") && text_.is(at + 2, ")") && is_operand(at + 3) && !called(at)) rewrite(at);
    for (const auto& [cast, name] : functions_) define(cast.first, cast.second, name);
    text_.apply();
  }

 private:
  using Cast = std::pair<std::string_view, std::string_view>;  // to, from

  bool is_operand(std::size_t at) const { return text_.is_identifier(at) || text_.is(at, "("); }

  // Returns whether it is f(S) or if (S), which are no casts.
  bool called(std::size_t open) const {
    return text_.is_identifier(open - 1) && !text_.is(open - 1, "return");
  }

  void rewrite(std::size_t at) {
    const std::string_view to = text_.word(at + 1);
    if (types_.find_struct(to) == nullptr) return;
    const std::size_t end =
        text_.is(at + 3, "(") ? text_.matching_bracket(at + 3) : postfix_end(text_, at + 3) - 1;
    if (end == npos || types_.begin(end) != at + 3 || postfix_end(text_, end) != end + 1) return;
    const ValueType& from = types_.at(end);
    if (from.dimensions > 0 || types_.find_struct(from.name) == nullptr) return;
    if (from.name == to) return text_.erase(at, 3);
    if (!agree(to, from.name)) return;
    std::string& name = functions_[{to, from.name}];
    if (name.empty()) name = text_.free_name(std::string(to) + "_of_" + std::string(from.name));
    text_.replace(at, 3, name + "(");
    text_.insert(end + 1, ")");
  }

  bool agree(std::string_view to, std::string_view from) const {
    const std::vector<std::size_t> a = types_.members_with_bases(to);
    const std::vector<std::size_t> b = types_.members_with_bases(from);
    if (a.empty() || a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
      if (!agree(types_.declared()[a[i]], types_.declared()[b[i]])) return false;
    return true;
  }

  bool agree(const DeclaredValue& a, const DeclaredValue& b) const {
    const NumberShape of_a = shape_of_type(a.type.name);
    const NumberShape of_b = shape_of_type(b.type.name);
    const bool numbers = of_a.known() && of_b.known() && a.type.dimensions == 0 && of_a.rows == of_b.rows &&
                         of_a.columns == of_b.columns;
    const bool alike = a.type.name == b.type.name && a.type.element == b.type.element;
    return (alike || numbers) && sizes(a) == sizes(b);
  }

  std::string sizes(const DeclaredValue& value) const {
    return text_.spelled(value.name + 1, value.end - value.name - 1);
  }

  std::size_t last_of(std::string_view type) const {
    return types_.declarations()[types_.structs().at(type).declaration].last;
  }

  void define(std::string_view to, std::string_view from, const std::string& name) {
    const std::vector<std::size_t> a = types_.members_with_bases(to);
    const std::vector<std::size_t> b = types_.members_with_bases(from);
    std::string copies;
    for (std::size_t i = 0; i < a.size(); ++i)
      copies.append("to.")
          .append(text_.word(types_.declared()[a[i]].name))
          .append(" = from.")
          .append(text_.word(types_.declared()[b[i]].name))
          .append("; ");
    const std::string type(to);
    text_.insert(std::max(last_of(to), last_of(from)) + 1, type + " " + name + "(" + std::string(from) +
                                                               " from) { " + type + " to; " + copies +
                                                               "return to; } ");
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::map<Cast, std::string> functions_;
};

}  // namespace

// Zero cast to an array, `(float3[4])0`, which glslang parses as a constructor with too few arguments. It
// becomes the member of a zeroed struct that contains such an array, `((penumbra_zeroes0)0).value`. The
// struct is inserted before the first function that uses it.
//
// Only a literal zero is rewritten: other casts to arrays remain errors.
void cast_zero_to_structs(TokenText& text) {
  ArrayCasts(text).run();
}

// A struct cast to another with the same members, `(Attributes)input`, which HLSL does member by member
// (docs.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-operators, casts) and glslang parses as a
// constructor with too few arguments. It becomes a call of a function that copies the members in order; a
// cast to the struct's own type is removed.
//
// The members must agree one by one: the same types, or numeric types of the same shape, and the same array
// sizes. The type of the cast expression must be known (value_types.h). Others are not changed, and remain
// errors.
void copy_cast_structs(TokenText& text) {
  StructCasts(text).run();
}

}  // namespace penumbra::preparation
