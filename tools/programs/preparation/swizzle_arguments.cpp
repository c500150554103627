#include "preparation/swizzle_arguments.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "preparation/list_elements.h"
#include "preparation/postfix_expression.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

// Returns the number of elements of _m03_m13 or _14_24; 0 for other identifiers and for one element.
std::size_t matrix_swizzle(std::string_view word) {
  const std::size_t length = word.size() > 1 && word[1] == 'm' ? 4 : 3;
  if (word.size() < 2 * length || word.size() > 4 * length || word.size() % length != 0) return 0;
  for (std::size_t at = 0; at < word.size(); at += length) {
    const auto digit = [&](std::size_t i) { return word[at + i] >= '0' && word[at + i] <= '4'; };
    if (word[at] != '_' || !digit(length - 2) || !digit(length - 1)) return 0;
  }
  return word.size() / length;
}

bool may_be_argument(const TokenText& text, std::size_t at) {
  return text.lead(at) == '_' && text.is(at - 1, ".") && (text.is(at + 1, ",") || text.is(at + 1, ")")) &&
         matrix_swizzle(text[at].spelling) > 1;
}

class SwizzleArguments {
 public:
  explicit SwizzleArguments(TokenText& text) : text_(text), types_(text.types()) {
    for (const FunctionType& function : types_.functions())
      if (function.name != npos) functions_[text_[function.name].spelling].push_back(&function);
  }

  void run() {
    for (std::size_t at = 1; at + 1 < text_.size(); ++at) {
      const bool call =
          text_.is_identifier(at) && text_.is(at + 1, "(") && text_.matching_bracket(at + 1) != npos;
      const auto known = call ? functions_.find(text_[at].spelling) : functions_.end();
      if (known != functions_.end() && begins_statement(text_, at))
        (void)std::any_of(known->second.begin(), known->second.end(),
                          [&](const FunctionType* overload) { return rewrite(at, *overload); });
    }
    text_.apply();
  }

 private:
  struct Argument : ListElement {
    const DeclaredValue* parameter;
  };

  // Returns whether the overload is one that writes to a swizzle here.
  bool rewrite(std::size_t call, const FunctionType& function) {
    const std::size_t close = text_.matching_bracket(call + 1);
    if (!text_.is(close + 1, ";")) return false;
    std::string before;
    std::string after;
    for (const Argument& argument : written_swizzles(call + 1, function)) {
      const DeclaredValue& parameter = *argument.parameter;
      const std::string name = "penumbra_argument" + std::to_string(argument.first - call);
      const std::string given = text_.spelled(argument.first, argument.end - argument.first);
      before.append(text_.spelled(parameter.type_at, parameter.type_end - parameter.type_at)).append(" ");
      before.append(name).append(has_modifier(text_, parameter, "inout") ? " = " + given + "; " : "; ");
      after.append(" ").append(given).append(" = ").append(name).append(";");
      text_.replace(argument.first, argument.end - argument.first, name);
    }
    if (before.empty()) return false;
    text_.insert(call, "{ " + before);
    text_.insert(close + 2, after + " }");
    return true;
  }

  // The call has as many arguments as the overload has parameters.
  std::vector<Argument> written_swizzles(std::size_t open, const FunctionType& function) const {
    const std::vector<ListElement> given = list_elements(text_, open);
    if (given.size() != function.parameters.size()) return {};
    std::vector<Argument> found;
    for (std::size_t i = 0; i < given.size(); ++i) {
      const Argument argument{given[i], &types_.declared()[function.parameters[i]]};
      if (is_written_swizzle(argument)) found.push_back(argument);
    }
    return found;
  }

  bool is_written_swizzle(const Argument& argument) const {
    const std::size_t word = argument.end - 1;
    const std::size_t elements =
        argument.end >= argument.first + 3 ? matrix_swizzle(text_[word].spelling) : 0;
    const std::string_view type = argument.parameter->type.name;
    const bool fits = elements > 1 && !type.empty() && type.back() == static_cast<char>('0' + elements);
    return fits && text_.is(word - 1, ".") && postfix_begin(text_, word) == argument.first &&
           is_written_parameter(text_, *argument.parameter) &&
           may_be_repeated(text_, argument.first, argument.end);
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::map<std::string_view, std::vector<const FunctionType*>> functions_;  // overloads by name
};

}  // namespace

void pass_swizzles_in_variables(TokenText& text) {
  for (std::size_t at = 1; at < text.size(); ++at)
    if (may_be_argument(text, at)) return SwizzleArguments(text).run();
}

}  // namespace penumbra::preparation
