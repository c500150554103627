#include "preparation/cbuffer_offsets.h"

#include <optional>
#include <string>
#include <vector>

#include "hlsl/declarations.h"
#include "preparation/cbuffer_extents.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

class CbufferOffsets {
 public:
  explicit CbufferOffsets(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    for (const hlsl::Declaration& declaration : types_.declarations())
      if (declaration.kind == hlsl::Declaration::Kind::buffer) place_members(declaration);
    text_.apply();
  }

 private:
  void place_members(const hlsl::Declaration& buffer) {
    for (std::size_t at = buffer.open; at < buffer.close; ++at)
      if (text_.is(at, ":") || text_.is(at, "=")) return;
    Packing packing;
    std::vector<std::pair<std::size_t, std::size_t>> places;  // token and word of each packoffset to insert
    for (const DeclaredValue& value : types_.declared()) {
      if (value.name == npos || value.name < buffer.open || value.name > buffer.close) continue;
      if (value.place != DeclaredValue::Place::global || value.is_static) return;
      CbufferExtents extents(text_);
      const std::optional<Extent> extent = extents.of(value);
      for (const std::size_t member : extents.in_tails()) refuse(member);
      if (!extent) return;
      places.emplace_back(value.end, packing.place(*extent));
    }
    if (!packing.in_tail()) return;
    for (const auto& [before, word] : places)
      text_.insert(
          before, ": packoffset(c" + std::to_string(word / kRegister) + "." + "xyzw"[word % kRegister] + ")");
  }

  void refuse(std::size_t member) {
    const std::size_t name = types_.declared()[member].name;
    text_.note(name, hlsl::Severity::error,
               "not supported here: '" + std::string(text_[name].spelling) +
                   "' shares the last register of the member before it, in a struct of a cbuffer; " +
                   "put a float4 or a larger member after that one");
  }

  TokenText& text_;
  const ValueTypes& types_;
};

}  // namespace

void place_cbuffer_members(TokenText& text) {
  CbufferOffsets(text).run();
}

}  // namespace penumbra::preparation
