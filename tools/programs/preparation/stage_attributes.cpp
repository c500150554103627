#include <algorithm>
#include <charconv>

#include "preparation/entry_functions.h"
#include "preparation/number_shape.h"
#include "preparation/postfix_expression.h"
#include "preparation/source_checks.h"

namespace penumbra::preparation {

namespace {

constexpr unsigned most_scalars = 1024;  // limit for one invocation of a geometry program: FXC X4550, X4552

class StageAttributes {
 public:
  StageAttributes(TokenText& text, const hlsl::Declaration& function, const EntryPoint& entry)
      : text_(text), types_(text.types()), function_(function), entry_(entry) {}

  void run() {
    switch (entry_.stage) {
      case hlsl::Stage::geometry:
        require("maxvertexcount", "[maxvertexcount(n)]");
        check_streams();
        break;
      case hlsl::Stage::hull:
        require("domain", "[domain(\"tri\")]");
        require("partitioning", "[partitioning(\"integer\")]");
        require("outputtopology", "[outputtopology(\"triangle_cw\")]");
        require("outputcontrolpoints", "[outputcontrolpoints(n)]");
        require("patchconstantfunc", "[patchconstantfunc(\"Name\")]");
        check_patch_function();
        break;
      case hlsl::Stage::domain:
        require("domain", "[domain(\"tri\")]");
        break;
      default:
        break;
    }
  }

 private:
  // Returns the name of the attribute before the function; npos if it is not there.
  std::size_t attribute(std::string_view name) const {
    for (std::size_t at = function_.name; at > 0 && !text_.is_any(at, ";", "}"); --at)
      if (text_.is(at, name) && text_.is(at - 1, "[")) return at;
    return npos;
  }

  void require(std::string_view name, const std::string& example) {
    if (attribute(name) != npos) return;
    text_.error(function_.name, "'" + entry_.name + "' has no " + example + ", which a " +
                                    hlsl::stage_name(entry_.stage) + " program needs");
  }

  void check_patch_function() {
    const std::size_t at = attribute("patchconstantfunc");
    if (at == npos || !text_.is(at + 1, "(") || at + 2 >= text_.size()) return;
    std::string_view name = text_.word(at + 2);
    if (name.size() < 3 || name.front() != '"' || name.back() != '"') return;
    name = name.substr(1, name.size() - 2);
    const bool known = std::any_of(
        types_.functions().begin(), types_.functions().end(),
        [&](const FunctionType& function) { return function.name != npos && text_.is(function.name, name); });
    if (!known)
      text_.error(at, "[patchconstantfunc] names '" + std::string(name) + "', and there is no such function");
  }

  std::optional<unsigned> vertex_count() const {
    const std::size_t at = attribute("maxvertexcount");
    if (at == npos || !text_.is(at + 1, "(") || !text_.is(at + 3, ")")) return std::nullopt;
    const std::string_view number = text_.word(at + 2);
    unsigned count = 0;
    const auto read = std::from_chars(number.data(), number.data() + number.size(), count);
    return read.ec == std::errc() && read.ptr == number.data() + number.size() ? std::optional(count)
                                                                               : std::nullopt;
  }

  static bool is_stream(std::string_view type) {
    return type == "TriangleStream" || type == "LineStream" || type == "PointStream";
  }

  void check_streams() {
    for (const FunctionType& function : types_.functions()) {
      if (function.name != function_.name) continue;
      for (const std::size_t parameter : function.parameters)
        if (is_stream(types_.declared()[parameter].type.name)) check_stream(types_.declared()[parameter]);
    }
  }

  void check_stream(const DeclaredValue& stream) {
    const std::string type(stream.type.name);
    if (!has_modifier(text_, stream, "inout"))
      text_.error(stream.type_at, "a " + type + " is changed by what is appended to it: write inout " + type);
    const std::optional<unsigned> count = vertex_count();
    const std::size_t scalars = scalars_of(stream.type.element);
    if (!count || scalars == 0 || *count * scalars <= most_scalars) return;
    text_.error(attribute("maxvertexcount"),
                std::to_string(*count) + " vertices of " + std::to_string(scalars) + " numbers are " +
                    std::to_string(*count * scalars) + ", and a geometry program emits at most " +
                    std::to_string(most_scalars) + " (X4552): at most " +
                    std::to_string(most_scalars / scalars) + " vertices");
  }

  // Returns the scalars of a struct's members; 0 where one is not known.
  std::size_t scalars_of(std::string_view type) const {
    const auto found = types_.structs().find(type);
    if (found == types_.structs().end() || !found->second.base.empty()) return 0;
    std::size_t sum = 0;
    for (const std::size_t member : found->second.members) {
      const std::optional<ValueShape> shape = shape_of(text_, types_.declared()[member]);
      if (!shape) return 0;
      sum += shape->numbers;
    }
    return sum;
  }

  TokenText& text_;
  const ValueTypes& types_;
  const hlsl::Declaration& function_;
  const EntryPoint& entry_;
};

void check_sizes(TokenText& text, std::size_t attribute) {
  if (!text.is(attribute + 1, "(") || text.matching_bracket(attribute + 1) == npos) return;
  const std::size_t count = list_elements(text, attribute + 1).size();
  if (count != 3)
    text.error(attribute, "[numthreads(x, y, z)] has three sizes, and " + std::to_string(count) +
                              (count == 1 ? " is" : " are") + " given: write 1 for those that are not used");
}

}  // namespace

void check_stage_attributes(TokenText& text, const EntryPoint& entry) {
  const std::vector<const hlsl::Declaration*> functions = entry_functions(text, entry);
  if (functions.size() == 1) StageAttributes(text, *functions.front(), entry).run();
}

void check_thread_group(TokenText& text, const EntryPoint& entry) {
  if (entry.stage != hlsl::Stage::compute) return;
  const std::vector<const hlsl::Declaration*> kernels = entry_functions(text, entry);
  if (kernels.empty()) return;
  const std::size_t name = kernels.back()->name;
  for (std::size_t at = name; at > 0 && !text.is_any(at, ";", "}"); --at)
    if (text.is(at, "numthreads")) return check_sizes(text, at);
  text.error(name, "'" + entry.name + "' has no [numthreads(x, y, z)], which a compute program needs");
}

}  // namespace penumbra::preparation
