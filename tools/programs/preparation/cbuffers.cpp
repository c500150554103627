#include <algorithm>
#include <charconv>

#include "hlsl/declarations.h"
#include "preparation/number_shape.h"
#include "preparation/passes.h"
#include "preparation/resource_types.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

// The size of a value in a constant buffer, by HLSL's packing rules
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-packing-rules).

inline constexpr std::size_t kRegister = 4;  // words

// The sizes are in words.
struct Extent {
  std::size_t size = 0;
  bool of_registers = false;  // begins at a register, as a matrix, an array or a struct does
};

// Places members one after the other.
class Packing {
 public:
  std::size_t place(const Extent& extent);  // returns the word at which it begins
  std::size_t size() const { return next_; }
  // Returns whether a member shares the last register of a matrix, array or struct.
  bool in_tail() const { return in_tail_; }

 private:
  std::size_t next_ = 0;
  bool before_of_registers_ = false;
  bool in_tail_ = false;
};

class CbufferExtents {
 public:
  explicit CbufferExtents(const TokenText& text) : text_(text), types_(text.types()) {}

  // Returns nothing for doubles, resources and array sizes that are not literals.
  std::optional<Extent> of(const DeclaredValue& value) { return of(value, 0); }

  // Returns the members of the structs so far that share the last register of the member before them, as
  // indices into ValueTypes::declared().
  const std::vector<std::size_t>& in_tails() const { return in_tails_; }

 private:
  std::optional<Extent> of(const DeclaredValue& value, int depth);
  std::optional<Extent> of_type(const DeclaredValue& value, int depth);
  std::optional<Extent> of_struct(const StructType& type, int depth);
  bool is_by_rows(const DeclaredValue& value) const;

  const TokenText& text_;
  const ValueTypes& types_;
  std::vector<std::size_t> in_tails_;
};

std::size_t rounded_up(std::size_t words) {
  return (words + kRegister - 1) / kRegister * kRegister;
}

std::size_t Packing::place(const Extent& extent) {
  const bool straddles = next_ % kRegister + extent.size > kRegister;
  const std::size_t at = extent.of_registers || straddles ? rounded_up(next_) : next_;
  in_tail_ = in_tail_ || (before_of_registers_ && at < rounded_up(next_));
  before_of_registers_ =
      extent.of_registers || (before_of_registers_ && at / kRegister == (next_ - 1) / kRegister);
  next_ = at + extent.size;
  return at;
}

std::optional<Extent> CbufferExtents::of(const DeclaredValue& value, int depth) {
  std::optional<Extent> one = of_type(value, depth);
  std::size_t count = 1;
  for (std::size_t at = value.name + 1; one && at < value.end; at += 3) {
    std::size_t size = 0;
    const std::string_view number = at + 2 < value.end ? text_.word(at + 1) : std::string_view();
    const auto read = std::from_chars(number.data(), number.data() + number.size(), size);
    const bool plain = text_.is(at, "[") && text_.is(at + 2, "]") && read.ec == std::errc() && size > 0;
    if (!plain || read.ptr != number.data() + number.size()) return std::nullopt;
    count *= size;
  }
  if (!one || value.type.dimensions == 0) return one;
  return Extent{rounded_up(one->size) * (count - 1) + one->size, true};
}

std::optional<Extent> CbufferExtents::of_type(const DeclaredValue& value, int depth) {
  constexpr int deepest = 16;
  const std::string_view name = value.type.name;
  const NumberShape shape = shape_of_type(name);
  if (name.substr(0, 6) == "double") return std::nullopt;
  if (shape.is_matrix()) {
    const bool by_rows = is_by_rows(value);
    const auto vectors = static_cast<std::size_t>(by_rows ? shape.rows : shape.columns);
    const auto words = static_cast<std::size_t>(by_rows ? shape.columns : shape.rows);
    return Extent{kRegister * (vectors - 1) + words, true};
  }
  if (shape.known()) return Extent{static_cast<std::size_t>(shape.columns > 0 ? shape.columns : 1), false};
  const StructType* known = types_.find_struct(name);
  if (known == nullptr || !known->base.empty() || depth > deepest) return std::nullopt;
  return of_struct(*known, depth);
}

std::optional<Extent> CbufferExtents::of_struct(const StructType& type, int depth) {
  Packing packing;
  for (const std::size_t member : type.members) {
    const std::optional<Extent> extent = of(types_.declared()[member], depth + 1);
    if (!extent) return std::nullopt;
    const bool before = packing.in_tail();
    packing.place(*extent);
    if (packing.in_tail() && !before) in_tails_.push_back(member);
  }
  return Extent{packing.size(), true};
}

bool CbufferExtents::is_by_rows(const DeclaredValue& value) const {
  for (std::size_t at = value.type_at; at-- > 0 && text_.is_identifier(at);)
    if (text_.is(at, "row_major")) return true;
  return false;
}

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
      if (text_.is_any(at, ":", "=")) return;
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
    text_.error(name, "not supported here: '" + text_.name(name) +
                          "' shares the last register of the member before it, in a struct of a cbuffer; " +
                          "put a float4 or a larger member after that one");
  }

  TokenText& text_;
  const ValueTypes& types_;
};

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

// Members of a cbuffer that share the last register of the member before them
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-packing-rules): matrices, arrays and
// structs begin at a register of four words and end with their last component, so g of `float3x3 m; float g;`
// is at word 11. glslang places g after whole registers. In such a cbuffer every member gets a packoffset.
//
// A cbuffer with a packoffset or a type of unknown size is not changed; a member of a struct in it that would
// have to move is an error.
void place_cbuffer_members(TokenText& text) {
  CbufferOffsets(text).run();
}

// Textures, samplers, buffers and static variables that are declared in a cbuffer or tbuffer. In HLSL they
// are not part of its layout, but equivalent to declarations at file scope; glslang makes them members of the
// block: no Vulkan driver accepts the resources, and a static constant silently loses its value. They are
// moved before the cbuffer, with their register() and their line; a cbuffer without other members is removed.
void hoist_cbuffer_resources(TokenText& text) {
  if (text.holds({"cbuffer", "tbuffer"})) Hoist(text).run();
}

}  // namespace penumbra::preparation
