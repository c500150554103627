#include "preparation/cbuffer_offsets.h"

#include <charconv>
#include <optional>
#include <string>
#include <vector>

#include "hlsl/outline.h"
#include "preparation/number_shape.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

constexpr std::size_t kRegister = 4;  // words

std::size_t rounded_up(std::size_t words) {
  return (words + kRegister - 1) / kRegister * kRegister;
}

// In words.
struct Extent {
  std::size_t size = 0;
  bool of_registers = false;  // begins at one: a matrix, an array or a struct
};

// Puts one member behind the other.
class Packing {
 public:
  // The word it begins at.
  std::size_t place(const Extent& extent) {
    const bool straddles = next_ % kRegister + extent.size > kRegister;
    const std::size_t at = extent.of_registers || straddles ? rounded_up(next_) : next_;
    in_tail_ = in_tail_ || (before_of_registers_ && at < rounded_up(next_));
    before_of_registers_ =
        extent.of_registers || (before_of_registers_ && at / kRegister == (next_ - 1) / kRegister);
    next_ = at + extent.size;
    return at;
  }

  std::size_t size() const { return next_; }
  bool in_tail() const { return in_tail_; }  // whether a member lies in what one of registers leaves free

 private:
  std::size_t next_ = 0;
  bool before_of_registers_ = false;
  bool in_tail_ = false;
};

class CbufferOffsets {
 public:
  explicit CbufferOffsets(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    for (const hlsl::Declaration& declaration : types_.outline())
      if (declaration.kind == hlsl::Declaration::Kind::buffer) place_members(declaration);
    text_.apply();
  }

 private:
  void place_members(const hlsl::Declaration& buffer) {
    for (std::size_t at = buffer.open; at < buffer.close; ++at)
      if (text_.is(at, ":") || text_.is(at, "=")) return;
    Packing packing;
    std::vector<std::pair<std::size_t, std::size_t>> places;  // where to write which word
    for (const DeclaredValue& value : types_.declared()) {
      if (value.name == npos || value.name < buffer.open || value.name > buffer.close) continue;
      if (value.place != DeclaredValue::Place::global || value.is_static) return;
      const std::optional<Extent> extent = extent_of(value, 0);
      if (!extent) return;
      places.emplace_back(value.end, packing.place(*extent));
    }
    if (!packing.in_tail()) return;
    for (const auto& [before, word] : places)
      text_.insert(
          before, ": packoffset(c" + std::to_string(word / kRegister) + "." + "xyzw"[word % kRegister] + ")");
  }

  std::optional<Extent> extent_of(const DeclaredValue& value, int depth) {
    std::optional<Extent> one = extent_of_type(value, depth);
    std::size_t count = 1;
    for (std::size_t at = value.name + 1; one && at < value.end; at += 3) {
      std::size_t size = 0;
      const std::string_view number = at + 2 < value.end ? text_[at + 1].spelling : std::string_view();
      const auto read = std::from_chars(number.data(), number.data() + number.size(), size);
      const bool plain = text_.is(at, "[") && text_.is(at + 2, "]") && read.ec == std::errc() && size > 0;
      if (!plain || read.ptr != number.data() + number.size()) return std::nullopt;
      count *= size;
    }
    if (!one || value.type.dimensions == 0) return one;
    return Extent{rounded_up(one->size) * (count - 1) + one->size, true};
  }

  std::optional<Extent> extent_of_type(const DeclaredValue& value, int depth) {
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
    const auto known = types_.structs().find(name);
    if (known == types_.structs().end() || !known->second.base.empty() || depth > deepest)
      return std::nullopt;
    return extent_of_struct(known->second, depth);
  }

  std::optional<Extent> extent_of_struct(const StructType& type, int depth) {
    Packing packing;
    for (const std::size_t member : type.members) {
      const std::optional<Extent> extent = extent_of(types_.declared()[member], depth + 1);
      if (!extent) return std::nullopt;
      const bool before = packing.in_tail();
      packing.place(*extent);
      if (packing.in_tail() && !before) refuse(member);
    }
    return Extent{packing.size(), true};
  }

  void refuse(std::size_t member) {
    const std::size_t name = types_.declared()[member].name;
    text_.note(name, hlsl::Severity::error,
               "not supported here: '" + std::string(text_[name].spelling) +
                   "' begins in what the member before it leaves free of its last register, in a struct of a "
                   "cbuffer; " +
                   "put a float4 or a larger member behind that one");
  }

  bool is_by_rows(const DeclaredValue& value) const {
    for (std::size_t at = value.type_at; at-- > 0 && text_.is_word(at);)
      if (text_.is(at, "row_major")) return true;
    return false;
  }

  TokenText& text_;
  const ValueTypes& types_;
};

}  // namespace

void place_cbuffer_members(TokenText& text) {
  CbufferOffsets(text).run();
}

}  // namespace penumbra::preparation
