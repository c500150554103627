// Struct inheritance, `struct B : A { ... };`. glslang parses the base and ignores it: a member of A is an
// unknown variable in B. The members and functions of A are copied to the beginning of B, where HLSL also
// places them, and the base is removed. A function declared in B hides A's function of that name.
//
// Where an A is expected, a B is converted by a call of a function that copies the members of A: in a cast,
// `(A)b`, in a function's argument, and in an initialiser or an assignment, `A a = b;`. The type of the
// converted expression must be known (value_types.h).

#include "preparation/passes.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "preparation/postfix_expression.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

constexpr std::size_t most_bases =
    16;  // limit for one struct; each base's members are copied to all structs derived from it

class BaseMembers {
 public:
  explicit BaseMembers(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    const auto& structs = types_.structs();
    if (std::none_of(structs.begin(), structs.end(),
                     [](const auto& type) { return !type.second.base.empty(); }))
      return;
    for (const auto& [name, type] : structs)
      if (!type.base.empty()) write_out(type);
    for (std::size_t at = 1; at + 1 < text_.size(); ++at) convert(at);
    for (const auto& [types, function] : functions_) define(types.first, types.second, function);
    text_.apply();
  }

 private:
  const hlsl::Declaration& declaration(const StructType& type) const {
    return types_.declarations()[type.declaration];
  }

  // The base is a struct that is declared earlier, as the language requires, which rules out cycles.
  const StructType* base_of(const StructType& type) const {
    const StructType* base = types_.find_struct(type.base);
    const bool before = base != nullptr && declaration(*base).last < declaration(type).first;
    return before ? base : nullptr;
  }

  void write_out(const StructType& type) {
    const hlsl::Declaration& own = declaration(type);
    if (base_of(type) == nullptr)
      return text_.error(own.name + 2, "'" + std::string(type.base) + "' is not a struct declared before '" +
                                           text_.name(own.name) + "', which derives from it");
    std::vector<const StructType*> line{&type};  // the derived struct, its base, the base's base
    std::string inherited;
    while (const StructType* base = base_of(*line.back())) {
      if (line.size() > most_bases)
        return text_.error(own.name, "'" + text_.name(own.name) + "' has more than " +
                                         std::to_string(most_bases) + " levels of base structs");
      inherited.insert(0, members(*base, line));
      line.push_back(base);
    }
    text_.erase(own.name + 1, own.open - own.name - 1);
    text_.insert(own.open + 1, inherited);
  }

  // Returns the contents of the braces, without functions that a derived struct redeclares.
  std::string members(const StructType& base, const std::vector<const StructType*>& derived) const {
    const hlsl::Declaration& from = declaration(base);
    std::string copied;
    std::size_t at = from.open + 1;
    for (const hlsl::Declaration& function : base.functions) {
      const bool hidden = std::any_of(derived.begin(), derived.end(), [&](const StructType* derived_type) {
        return has_function(*derived_type, text_.word(function.name));
      });
      if (!hidden) continue;
      copied += text_.spelled(at, function.first - at) + " ";
      at = function.last + 1;
    }
    return copied + text_.spelled(at, from.close - at) + " ";
  }

  bool has_function(const StructType& type, std::string_view name) const {
    return std::any_of(type.functions.begin(), type.functions.end(),
                       [&](const hlsl::Declaration& function) { return text_.word(function.name) == name; });
  }

  bool inherits(std::string_view derived_type, std::string_view base) const {
    for (const StructType* type = types_.find_struct(derived_type); type != nullptr; type = base_of(*type))
      if (type->base == base) return base_of(*type) != nullptr;
    return false;
  }

  // Converts (A)b, A a = b, a = b and f(b), found at the '(', the '=' or the name.
  void convert(std::size_t at) {
    const bool cast =
        text_.is(at, "(") && text_.is(at + 2, ")") && types_.find_struct(text_.word(at + 1)) != nullptr;
    if (cast && !text_.is_identifier(at - 1)) return convert_cast(at);
    if (text_.is(at, "=") && assignment_length(text_, at) == 1)
      return convert_value(assigned(at - 1), at + 1);
    if (text_.is_identifier(at) && text_.is(at + 1, "(") && text_.matching_bracket(at + 1) != npos)
      convert_arguments(at);
  }

  // Returns the left side of a '=', declared there or earlier.
  const ValueType& assigned(std::size_t at) const {
    const std::size_t index = types_.named(at);
    const bool declared_here = index != npos && types_.declared()[index].name == at;
    return declared_here ? types_.declared()[index].type : types_.at(at);
  }

  void convert_cast(std::size_t at) {
    const std::size_t end = postfix_end(text_, at + 3);
    const ValueType& from = types_.at(end - 1);
    if (!text_.is_identifier(at + 3) || types_.begin(end - 1) != at + 3 || from.dimensions > 0) return;
    if (!inherits(from.name, text_.word(at + 1))) return;
    text_.replace(at, 3, function_name(text_.word(at + 1), from.name) + "(");
    text_.insert(end, ")");
  }

  void convert_value(const ValueType& wanted, std::size_t first) {
    if (!text_.is_identifier(first) || types_.find_struct(wanted.name) == nullptr || wanted.dimensions > 0)
      return;
    const std::size_t end = postfix_end(text_, first);
    const ValueType& from = types_.at(end - 1);
    const bool whole = text_.is_any(end, ";", ",", ")");
    if (!whole || types_.begin(end - 1) != first || from.dimensions > 0) return;
    if (!inherits(from.name, wanted.name)) return;
    text_.insert(first, function_name(wanted.name, from.name) + "(");
    text_.insert(end, ")");
  }

  // Converts the arguments of a call; only for functions that are not overloaded.
  void convert_arguments(std::size_t name) {
    const FunctionType* called = nullptr;
    for (const FunctionType& function : types_.functions()) {
      if (text_.identifier_number(function.name) != text_.identifier_number(name)) continue;
      if (function.name == name || (called != nullptr && function.body != npos && called->body != npos))
        return;
      called = &function;
    }
    if (called == nullptr) return;
    std::size_t first = name + 2;
    for (const std::size_t parameter : called->parameters) {
      convert_value(types_.declared()[parameter].type, first);
      while (first < text_.matching_bracket(name + 1) && !text_.is(first, ",")) first = text_.after(first);
      ++first;
    }
  }

  const std::string& function_name(std::string_view to, std::string_view from) {
    std::string& name = functions_[{to, from}];
    if (name.empty()) name = text_.free_name(std::string(to) + "_of_" + std::string(from));
    return name;
  }

  void define(std::string_view to, std::string_view from, const std::string& name) {
    std::string copies;
    for (const StructType* type = types_.find_struct(to); type != nullptr; type = base_of(*type))
      for (const std::size_t member : type->members) {
        const std::string own = text_.name(types_.declared()[member].name);
        copies.append("to.").append(own).append(" = from.").append(own).append("; ");
      }
    const std::string type(to);
    const std::size_t behind =
        std::max(declaration(*types_.find_struct(to)).last, declaration(*types_.find_struct(from)).last);
    text_.insert(behind + 1, type + " " + name + "(" + std::string(from) + " from) { " + type + " to; " +
                                 copies + "return to; } ");
  }

  TokenText& text_;
  const ValueTypes& types_;
  // The functions by target and source type.
  std::map<std::pair<std::string_view, std::string_view>, std::string> functions_;
};

}  // namespace

void write_out_base_members(TokenText& text) {
  BaseMembers(text).run();
}

}  // namespace penumbra::preparation
