// The size of a value in a constant buffer, by HLSL's packing rules
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-packing-rules). Internal to this folder.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "preparation/value_types.h"

namespace penumbra::preparation {

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

}  // namespace penumbra::preparation
