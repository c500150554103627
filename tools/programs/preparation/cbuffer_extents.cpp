#include "preparation/cbuffer_extents.h"

#include <charconv>
#include <string_view>

#include "preparation/number_shape.h"

namespace penumbra::preparation {

namespace {

std::size_t rounded_up(std::size_t words) {
  return (words + kRegister - 1) / kRegister * kRegister;
}

}  // namespace

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
    const std::string_view number = at + 2 < value.end ? text_[at + 1].spelling : std::string_view();
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
  const auto known = types_.structs().find(name);
  if (known == types_.structs().end() || !known->second.base.empty() || depth > deepest) return std::nullopt;
  return of_struct(known->second, depth);
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

}  // namespace penumbra::preparation
