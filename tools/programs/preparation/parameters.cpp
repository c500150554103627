#include <unordered_map>

#include "hlsl/name_set.h"
#include "preparation/declarators.h"
#include "preparation/number_shape.h"
#include "preparation/passes.h"
#include "preparation/postfix_expression.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

class NarrowArguments {
 public:
  explicit NarrowArguments(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    for (const FunctionType& function : types_.functions())
      functions_[text_.identifier_number(function.name)].push_back(&function);
    for (std::size_t at = 1; at + 1 < text_.size(); ++at) {
      if (!text_.is_identifier(at) || !text_.is(at + 1, "(") || text_.is(at - 1, ".")) continue;
      const auto named = functions_.find(text_.identifier_number(at));
      if (named != functions_.end() && text_.matching_bracket(at + 1) != npos) call(at, named->second);
    }
    text_.apply();
  }

 private:
  void call(std::size_t name, const std::vector<const FunctionType*>& named) {
    const std::vector<ListElement> given = list_elements(text_, name + 1);
    const FunctionType* called = nullptr;
    for (const FunctionType* function : named) {
      if (function->name == name) return;  // its own declaration
      if (function->parameters.size() != given.size()) continue;
      if (called != nullptr && function->body != npos && called->body != npos) return;
      called = function;
    }
    for (std::size_t i = 0; called != nullptr && i < given.size(); ++i)
      narrow(types_.declared()[called->parameters[i]], given[i]);
  }

  void narrow(const DeclaredValue& parameter, const ListElement& argument) {
    if (!is_number_type(parameter.type.name) || parameter.type.dimensions > 0 ||
        is_written_parameter(text_, parameter))
      return;
    if (shape_of_type(parameter.type.name).is_matrix() ||
        !is_wider(argument, components(parameter.type.name)))
      return;
    text_.insert(argument.first, "(" + std::string(parameter.type.name) + ")(");
    text_.insert(argument.end, ")");
  }

  bool is_wider(const ListElement& argument, std::size_t wanted) const {
    if (!text_.is_identifier(argument.first) || postfix_end(text_, argument.first) != argument.end)
      return false;
    const std::size_t last = argument.end - 1;
    const ValueType& type = types_.at(last);
    if (types_.begin(last) == argument.first && is_number_type(type.name))
      return type.dimensions == 0 && !shape_of_type(type.name).is_matrix() && components(type.name) > wanted;
    if (const std::optional<ListElement> inner = of_each_component(argument)) return is_wider(*inner, wanted);
    return wanted < 4 && gives_a_vector(argument);
  }

  // Returns the whole argument of ddx(...) and similar functions: the result has as many components.
  std::optional<ListElement> of_each_component(const ListElement& argument) const {
    static constexpr hlsl::NameSet functions(
        "abs", "acos", "asin", "atan", "ceil", "cos", "ddx", "ddx_coarse", "ddx_fine", "ddy", "ddy_coarse",
        "ddy_fine", "degrees", "exp", "exp2", "floor", "frac", "fwidth", "log", "log10", "log2", "normalize",
        "radians", "rcp", "round", "rsqrt", "saturate", "sign", "sin", "sqrt", "tan", "trunc");
    const std::size_t open = argument.first + 1;
    if (!functions.contains(text_.word(argument.first)) || !text_.is(open, "(")) return std::nullopt;
    const std::vector<ListElement> inner = list_elements(text_, open);
    if (text_.matching_bracket(open) != argument.end - 1 || inner.size() != 1) return std::nullopt;
    return inner.front();
  }

  // Returns whether it is a whole map.Sample(...) or mul(...).
  bool gives_a_vector(const ListElement& argument) const {
    static constexpr hlsl::NameSet reads("Sample", "SampleLevel", "SampleBias", "SampleGrad", "Load",
                                         "Gather", "GatherRed", "GatherGreen", "GatherBlue", "GatherAlpha");
    const std::size_t last = argument.end - 1;
    const std::size_t open = text_.is(last, ")") ? text_.matching_bracket(last) : npos;
    if (open == npos || open <= argument.first || !text_.is_identifier(open - 1)) return false;
    const bool product = open == argument.first + 1 && text_.is(argument.first, "mul");
    return product || (text_.is(open - 2, ".") && reads.contains(text_.word(open - 1)));
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::unordered_map<std::uint32_t, std::vector<const FunctionType*>> functions_;  // by identifier number
};

}  // namespace

// Arguments with more components than the parameter: HLSL truncates them, with a warning (X3206); glslang
// reports "no matching overloaded function". Such an argument is cast to the parameter's type, which keeps
// the same components.
//
// Only for functions without an overload of as many parameters, and for arguments whose type is known
// (value_types.h), texture reads, and mul().
void narrow_arguments(TokenText& text) {
  NarrowArguments(text).run();
}

}  // namespace penumbra::preparation
