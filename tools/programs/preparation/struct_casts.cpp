#include "preparation/struct_casts.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "preparation/declarators.h"
#include "preparation/postfix_expression.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

// Returns "3" for half3 and "4x4" for float4x4.
std::string_view shape_of(std::string_view number_type) {
  constexpr std::string_view digits = "1234";
  const std::size_t by = number_type.size() - 2;
  const bool matrix = number_type.size() > 3 && number_type[by] == 'x';
  if (matrix) return number_type.substr(number_type.size() - 3);
  const bool vector = digits.find(number_type.back()) != std::string_view::npos;
  return vector ? number_type.substr(number_type.size() - 1) : std::string_view{};
}

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

  std::string_view word(std::size_t at) const { return text_[at].spelling; }
  bool is_operand(std::size_t at) const { return text_.is_identifier(at) || text_.is(at, "("); }

  // Returns whether it is f(S) or if (S), which are no casts.
  bool called(std::size_t open) const {
    return text_.is_identifier(open - 1) && !text_.is(open - 1, "return");
  }

  void rewrite(std::size_t at) {
    const std::string_view to = word(at + 1);
    if (types_.structs().count(to) == 0) return;
    const std::size_t end =
        text_.is(at + 3, "(") ? text_.matching_bracket(at + 3) : postfix_end(text_, at + 3) - 1;
    if (end == npos || types_.begin(end) != at + 3 || postfix_end(text_, end) != end + 1) return;
    const ValueType& from = types_.at(end);
    if (from.dimensions > 0 || types_.structs().count(from.name) == 0) return;
    if (from.name == to) return text_.erase(at, 3);
    if (!agree(to, from.name)) return;
    std::string& name = functions_[{to, from.name}];
    if (name.empty()) name = text_.free_name(std::string(to) + "_of_" + std::string(from.name));
    text_.replace(at, 3, name + "(");
    text_.insert(end + 1, ")");
  }

  // The members of its bases come first.
  std::vector<std::size_t> members(std::string_view type) const {
    constexpr int deepest = 16;
    std::vector<std::size_t> all;
    for (int depth = 0; depth < deepest; ++depth) {
      const auto known = types_.structs().find(type);
      if (known == types_.structs().end()) break;
      all.insert(all.begin(), known->second.members.begin(), known->second.members.end());
      type = known->second.base;
    }
    return all;
  }

  bool agree(std::string_view to, std::string_view from) const {
    const std::vector<std::size_t> a = members(to);
    const std::vector<std::size_t> b = members(from);
    if (a.empty() || a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
      if (!agree(types_.declared()[a[i]], types_.declared()[b[i]])) return false;
    return true;
  }

  bool agree(const DeclaredValue& a, const DeclaredValue& b) const {
    const bool numbers = is_number_type(a.type.name) && is_number_type(b.type.name) &&
                         a.type.dimensions == 0 && shape_of(a.type.name) == shape_of(b.type.name);
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
    const std::vector<std::size_t> a = members(to);
    const std::vector<std::size_t> b = members(from);
    std::string copies;
    for (std::size_t i = 0; i < a.size(); ++i)
      copies.append("to.")
          .append(word(types_.declared()[a[i]].name))
          .append(" = from.")
          .append(word(types_.declared()[b[i]].name))
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

void copy_cast_structs(TokenText& text) {
  StructCasts(text).run();
}

}  // namespace penumbra::preparation
