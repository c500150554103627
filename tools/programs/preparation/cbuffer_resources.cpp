#include "preparation/cbuffer_resources.h"

#include <algorithm>

#include "preparation/resource_types.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

class Hoist {
 public:
  explicit Hoist(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    for (const hlsl::Declaration& declaration : types_.declarations())
      if (declaration.kind == hlsl::Declaration::Kind::buffer) hoist(declaration);
    text_.apply();
  }

 private:
  void hoist(const hlsl::Declaration& buffer) {
    std::size_t members = 0;
    std::size_t moved = 0;
    for (; next_ < types_.declared().size(); ++next_) {
      const DeclaredValue& value = types_.declared()[next_];
      if (value.name != npos && value.name > buffer.close) break;
      if (value.name == npos || value.name < buffer.open || value.first == npos) continue;
      ++members;
      moved += move(value, buffer) ? 1 : 0;
    }
    if (members > 0 && moved == members) text_.erase(buffer.first, buffer.open - buffer.first + 1);
    if (members > 0 && moved == members) text_.erase(buffer.close, buffer.last - buffer.close + 1);
  }

  // The whole statement moves, whatever it declares.
  bool move(const DeclaredValue& value, const hlsl::Declaration& buffer) {
    if (!is_resource(value.type.name) && !value.is_static) return false;
    std::size_t end = value.last;
    while (end < buffer.close && !text_.is(end, ";")) ++end;
    if (!text_.is(end, ";")) return false;
    text_.insert_from(value.first, buffer.first, text_.spelled(value.first, end - value.first + 1));
    text_.erase(value.first, end - value.first + 1);
    return true;
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::size_t next_ = 0;  // index of the declared values: earlier ones stand before the buffer
};

}  // namespace

void hoist_cbuffer_resources(TokenText& text) {
  const auto& tokens = text.tokens();
  const bool any = std::any_of(tokens.begin(), tokens.end(), [](const hlsl::Token& token) {
    return token.spelling == "cbuffer" || token.spelling == "tbuffer";
  });
  if (any) Hoist(text).run();
}

}  // namespace penumbra::preparation
