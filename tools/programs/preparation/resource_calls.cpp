#include <unordered_set>

#include "hlsl/name_set.h"
#include "preparation/dx9_functions.h"
#include "preparation/postfix_expression.h"
#include "preparation/resource_types.h"
#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

bool is_byte_address_buffer(std::string_view type) {
  return type == "ByteAddressBuffer" || type == "RWByteAddressBuffer" ||
         type == "RasterizerOrderedByteAddressBuffer";
}

bool takes_numbers(std::string_view intrinsic) {
  static constexpr hlsl::NameSet names(
      "abs", "acos", "all", "any", "asfloat", "asin", "asint", "asuint", "atan", "atan2", "ceil", "clamp",
      "clip", "cos", "cosh", "countbits", "cross", "ddx", "ddy", "degrees", "determinant", "distance", "dot",
      "exp", "exp2", "f16tof32", "f32tof16", "faceforward", "firstbithigh", "firstbitlow", "floor", "fma",
      "fmod", "frac", "fwidth", "isinf", "isnan", "ldexp", "length", "lerp", "lit", "log", "log10", "log2",
      "mad", "max", "min", "mul", "normalize", "pow", "radians", "rcp", "reflect", "refract", "reversebits",
      "round", "rsqrt", "saturate", "sign", "sin", "sinh", "smoothstep", "sqrt", "step", "tan", "tanh",
      "transpose", "trunc");
  return names.contains(intrinsic);
}

class ResourceCalls {
 public:
  explicit ResourceCalls(TokenText& text) : text_(text), types_(text.types()) {
    for (const FunctionType& function : types_.functions()) own_functions_.insert(text_.word(function.name));
  }

  void run() {
    for (std::size_t at = 1; at + 1 < text_.size(); ++at) {
      if (!text_.is_identifier(at)) continue;
      if (text_.is(at + 1, "[")) check_element(at);
      if (text_.is(at - 1, ".")) {
        check_method(at);
      } else if (text_.is(at + 1, "(")) {
        check_function(at);
      }
    }
  }

 private:
  void refuse(std::size_t at, std::string message) { text_.error(at, std::move(message)); }

  // Returns the tokens as people write them: the preprocessor puts blanks around a '.'.
  std::string spelled(std::size_t first, std::size_t count) const {
    std::string text = text_.spelled(first, count);
    std::erase(text, ' ');
    return text;
  }

  // glslang makes a constant of max(texture, number) and the like.
  void check_numbers(std::size_t name) {
    if (text_.matching_bracket(name + 1) == npos) return;
    for (const ListElement& argument : list_elements(text_, name + 1)) {
      const std::size_t last = argument.end - 1;
      const std::string_view type = types_.at(last).name;
      if (types_.begin(last) != argument.first || types_.at(last).dimensions > 0 || !is_resource(type))
        continue;
      refuse(argument.first, "'" + spelled(argument.first, argument.end - argument.first) + "' is a " +
                                 std::string(type) + ", and " + text_.name(name) + "() takes numbers" +
                                 (is_texture(type) ? ": read it with Sample or Load" : ""));
    }
  }

  void check_function(std::size_t name) {
    if (own_functions_.contains(text_.word(name))) return;
    if (takes_numbers(text_.word(name))) return check_numbers(name);
    const std::optional<Dx9Function> function = dx9_function(text_.word(name));
    if (!function) return;
    std::size_t last = name + 2;
    while (last + 1 < text_.size() && !text_.is_any(last + 1, ",", ")")) {
      ++last;
      if (text_.matching_bracket(last) != npos && text_.matching_bracket(last) > last)
        last = text_.matching_bracket(last);
    }
    if (last >= text_.size() || types_.begin(last) != name + 2 || !is_texture(types_.at(last).name)) return;
    const std::string texture = spelled(name + 2, last - name - 1);
    refuse(name, "'" + text_.name(name) + "' takes a sampler" + std::string(function->dimension) + ", and '" +
                     texture + "' is a " + std::string(types_.at(last).name) + ": write " + texture +
                     ".Sample() with a SamplerState");
  }

  // Elements of buffers that are appended to or consumed have no numbers.
  void check_element(std::size_t name) {
    const std::size_t declared = types_.named(name);
    if (declared == npos || types_.declared()[declared].name == name) return;
    const ValueType& type = types_.at(name);
    if (type.dimensions > 0 || (!type.is("AppendStructuredBuffer") && !type.is("ConsumeStructuredBuffer")))
      return;
    refuse(name, "'" + text_.name(name) + "' is " +
                     (type.is("AppendStructuredBuffer") ? "an AppendStructuredBuffer, which has Append()"
                                                        : "a ConsumeStructuredBuffer, which has Consume()") +
                     " and no []: for elements by number declare a StructuredBuffer or RWStructuredBuffer");
  }

  // Returns an empty type if the method exists, or is not one of those that move the buffer's end.
  static std::string_view type_with(std::string_view method, std::string_view type) {
    if (!is_buffer(type)) return {};
    const std::string_view wanted = method == "Append"    ? "AppendStructuredBuffer"
                                    : method == "Consume" ? "ConsumeStructuredBuffer"
                                                          : std::string_view();
    return type == wanted ? std::string_view() : wanted;
  }

  void check_method(std::size_t name) {
    if (name < 2) return;  // nothing stands before the '.'
    const std::size_t first = types_.begin(name - 2);
    if (first == npos) return;
    const std::string_view type = types_.at(name - 2).name;
    const std::string method = "'" + text_.name(name) + "'";
    if (const std::string_view other = type_with(text_.word(name), type); !other.empty())
      refuse(name, std::string(type) + " has no method " + method + ": it belongs to " + std::string(other));
    if (is_sampler(type) && text_.is(name + 1, "(")) {
      const std::string_view dimension = dx9_dimension(type);
      refuse(name, "a " + std::string(type) + " has no method " + method + ": " +
                       (dimension.empty() ? "call it on the texture"
                                          : "sample it with tex" + std::string(dimension) + "()"));
    } else if (is_byte_address_buffer(type) && text_.is(name + 1, "<")) {
      refuse(name, method + " takes no type in '<>' here: read or write uints, and convert them with " +
                       "asfloat(), asint() or asuint()");
    } else if (is_texture(type) && text_.is(name, "sample") && text_.is(name + 1, "[")) {
      const std::string texture = spelled(first, name - 1 - first);
      refuse(name, "'.sample[][]' is not supported: write " + texture + ".Load(texel, sample)");
    } else if (is_texture(type) && text_.is(name, "Store") && text_.is(name + 1, "(")) {
      const std::string texture = spelled(first, name - 1 - first);
      refuse(name, "a " + std::string(type) + " has no method 'Store': write " + texture + "[texel] = value");
    }
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::unordered_set<std::string_view> own_functions_;
};

}  // namespace

void check_resource_calls(TokenText& text) {
  ResourceCalls(text).run();
}

}  // namespace penumbra::preparation
