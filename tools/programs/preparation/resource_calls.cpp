#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>

#include "preparation/dx9_functions.h"
#include "preparation/resource_types.h"
#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

bool is_byte_address_buffer(std::string_view type) {
  return type == "ByteAddressBuffer" || type == "RWByteAddressBuffer" ||
         type == "RasterizerOrderedByteAddressBuffer";
}

class ResourceCalls {
 public:
  explicit ResourceCalls(TokenText& text) : text_(text), types_(text.types()) {
    for (const FunctionType& function : types_.functions()) own_functions_.insert(word(function.name));
  }

  void run() {
    for (std::size_t at = 1; at + 1 < text_.size(); ++at) {
      if (!text_.is_identifier(at)) continue;
      if (text_.is(at - 1, ".")) {
        check_method(at);
      } else if (text_.is(at + 1, "(")) {
        check_function(at);
      }
    }
  }

 private:
  std::string_view word(std::size_t at) const { return text_[at].spelling; }

  void refuse(std::size_t at, std::string message) {
    text_.note(at, hlsl::Severity::error, std::move(message));
  }

  void check_function(std::size_t name) {
    const std::optional<Dx9Function> function = dx9_function(word(name));
    if (!function || own_functions_.contains(word(name))) return;
    std::size_t last = name + 2;
    while (last + 1 < text_.size() && !text_.is(last + 1, ",") && !text_.is(last + 1, ")")) {
      ++last;
      if (text_.matching_bracket(last) != npos && text_.matching_bracket(last) > last)
        last = text_.matching_bracket(last);
    }
    if (last >= text_.size() || types_.begin(last) != name + 2 || !is_texture(types_.at(last).name)) return;
    const std::string texture = text_.spelled(name + 2, last - name - 1);
    refuse(name, "'" + std::string(word(name)) + "' takes a sampler" + std::string(function->dimension) +
                     ", and '" + texture + "' is a " + std::string(types_.at(last).name) + ": write " +
                     texture + ".Sample() with a SamplerState");
  }

  void check_method(std::size_t name) {
    const std::size_t first = types_.begin(name - 2);
    if (first == npos) return;
    const std::string_view type = types_.at(name - 2).name;
    const std::string method = "'" + std::string(word(name)) + "'";
    if (is_sampler(type) && text_.is(name + 1, "(")) {
      const std::string_view dimension = dx9_dimension(type);
      refuse(name, "a " + std::string(type) + " has no method " + method + ": " +
                       (dimension.empty() ? "call it on the texture"
                                          : "sample it with tex" + std::string(dimension) + "()"));
    } else if (is_byte_address_buffer(type) && text_.is(name + 1, "<")) {
      refuse(name, method + " takes no type in '<>' here: read or write uints, and convert them with " +
                       "asfloat(), asint() or asuint()");
    } else if (is_texture(type) && text_.is(name, "sample") && text_.is(name + 1, "[")) {
      const std::string texture = text_.spelled(first, name - 1 - first);
      refuse(name, "'.sample[][]' is not supported: write " + texture + ".Load(texel, sample)");
    } else if (is_texture(type) && text_.is(name, "Store") && text_.is(name + 1, "(")) {
      const std::string texture = text_.spelled(first, name - 1 - first);
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
