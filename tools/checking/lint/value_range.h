// Interval analysis: the range of a floating-point value, from the instructions that compute it. Internal to
// this folder.
//
// The interval arithmetic is without NaN, as compilers with fast math assume, which Direct3D's and Unity's
// are. A vector has one range for all its components. Loop-carried values are unknown.
#pragma once

#include <limits>
#include <map>
#include <optional>

#include "spirv/code.h"

namespace penumbra::lint {

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

class ValueRanges {
 public:
  explicit ValueRanges(const spirv::Code& code) : code_(code) {}

  Range of(spirv::Id value);

  // Returns the value of a constant whose components are all equal.
  std::optional<double> constant(spirv::Id value) const;

 private:
  Range compute(const spirv::Instruction& instruction);
  Range of_extended(const spirv::Instruction& instruction);
  Range of_constant(const spirv::Instruction& instruction);
  Range of_product(spirv::Id a, spirv::Id b);
  Range of_component(spirv::Id vector, std::uint32_t component);
  Range of_shuffle(const spirv::Instruction& instruction);
  std::uint32_t components(spirv::Id value) const;
  bool counts_up(spirv::Id integer) const;
  Range of_operands(const spirv::Instruction& instruction, std::size_t first, std::size_t step);

  const spirv::Code& code_;
  std::map<spirv::Id, Range> known_;
  int depth_ = 0;
};

}  // namespace penumbra::lint
