#include "preparation/member_calls.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

using Place = DeclaredValue::Place;

enum class Receiver { variable, value, writable };  // a variable: glslang handles the call correctly

class MemberCalls {
 public:
  explicit MemberCalls(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    for (std::size_t dot = 1; dot + 2 < text_.size(); ++dot)
      if (text_.is(dot, ".") && text_.is_identifier(dot + 1) && text_.is(dot + 2, "(")) call(dot);
    for (const auto& [type, receiver] : needed_) define(type, receiver);
    text_.apply();
  }

 private:
  std::string_view word(std::size_t at) const { return text_[at].spelling; }

  void call(std::size_t dot) {
    const ValueType& type = types_.at(dot - 1);
    const std::size_t first = types_.begin(dot - 1);
    const auto known = types_.structs().find(type.name);
    if (first == npos || type.dimensions > 0 || known == types_.structs().end()) return;
    const auto& functions = known->second.functions;
    const bool is_member =
        std::any_of(functions.begin(), functions.end(), [&](const hlsl::Declaration& function) {
          return word(function.name) == word(dot + 1) && can_be_forwarded(function);
        });
    const Receiver receiver = receiver_of(first, dot - 1);
    if (!is_member || receiver == Receiver::variable) return;
    needed_.emplace(type.name, receiver);
    text_.insert(first, function_name(type.name, word(dot + 1), receiver) + "(");
    const bool has_arguments = text_.matching_bracket(dot + 2) != dot + 3;
    text_.replace(dot, 3, has_arguments ? "," : "");
  }

  // Constants and results of calls are passed by value; otherwise the chain's first name decides.
  Receiver receiver_of(std::size_t first, std::size_t last) const {
    if (types_.at(last).constant) return Receiver::value;
    for (std::size_t at = last; at > first; --at) {
      if (text_.is(at, ")") && text_.matching_bracket(at) > first) return Receiver::value;
      if (text_.matching_bracket(at) != npos && text_.matching_bracket(at) < at)
        at = text_.matching_bracket(at);
    }
    while (text_.is(first, "(")) ++first;
    const std::size_t index = types_.named(first);
    if (index == npos) return text_.is(first, "this") ? Receiver::variable : Receiver::value;
    const DeclaredValue& value = types_.declared()[index];
    if (value.type.constant) return Receiver::value;
    if (value.place != Place::global && !value.is_static) return Receiver::variable;
    const bool writable = value.is_static || value.type.name == "RWStructuredBuffer" || value.is_groupshared;
    return writable ? Receiver::writable : Receiver::value;
  }

  std::string function_name(std::string_view type, std::string_view member, Receiver receiver) const {
    std::string name = std::string(type) + "_" + std::string(member) +
                       (receiver == Receiver::value ? "_of_value" : "_of_variable");
    return text_.free_name(std::move(name));
  }

  const FunctionType* parameters_of(const hlsl::Declaration& function) const {
    const auto& all = types_.functions();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const FunctionType& known) { return known.name == function.name; });
    return found == all.end() ? nullptr : &*found;
  }

  bool can_be_forwarded(const hlsl::Declaration& function) const {
    const FunctionType* type = parameters_of(function);
    return type != nullptr &&
           std::all_of(type->parameters.begin(), type->parameters.end(),
                       [&](std::size_t index) { return types_.declared()[index].name != npos; });
  }

  // Defines functions for all member functions: the compiler resolves overloads.
  void define(std::string_view type, Receiver receiver) {
    const StructType& known = types_.structs().find(type)->second;
    std::string functions;
    for (const hlsl::Declaration& function : known.functions)
      if (can_be_forwarded(function)) functions += definition(type, function, receiver);
    text_.insert(types_.declarations()[known.declaration].last + 1, functions);
  }

  std::string definition(std::string_view type, const hlsl::Declaration& function, Receiver receiver) const {
    std::size_t returned = function.type;
    while (text_.is(returned, "static") || text_.is(returned, "inline")) ++returned;
    const std::string self = text_.free_name("receiver");
    std::string arguments;
    for (const std::size_t index : parameters_of(function)->parameters)
      arguments += (arguments.empty() ? "" : ", ") + std::string(word(types_.declared()[index].name));
    const std::size_t first = function.parameters_open + 1;
    std::string parameters = text_.spelled(first, function.parameters_close - first);
    if (arguments.empty()) parameters.clear();  // (void)
    std::string text = text_.spelled(returned, function.name - returned) + " " +
                       function_name(type, word(function.name), receiver);
    text.append("(")
        .append(receiver == Receiver::writable ? "inout " : "")
        .append(type)
        .append(" ")
        .append(self);
    text.append(parameters.empty() ? "" : ", ").append(parameters).append(") { ");
    text.append(text_.is(returned, "void") ? "" : "return ").append(self).append(".");
    return text.append(word(function.name)).append("(").append(arguments).append("); } ");
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::set<std::pair<std::string_view, Receiver>> needed_;
};

}  // namespace

void call_members_on_variables(TokenText& text) {
  const auto& tokens = text.tokens();
  const bool any = std::any_of(tokens.begin(), tokens.end(),
                               [](const hlsl::Token& token) { return token.spelling == "struct"; });
  if (any) MemberCalls(text).run();
}

}  // namespace penumbra::preparation
