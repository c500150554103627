// Values of numeric types and what HLSL's operators, conversions and intrinsic functions make of them.
//
// Written from Microsoft's reference (learn.microsoft.com/windows/win32/direct3dhlsl, "Operators", "Intrinsic
// functions") and from what its compilers do where that is silent: integers wrap around, an integer division
// and % truncate, conversions to integers truncate, a comparison gives bools, the smaller of two vectors or
// matrices decides.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "programs/program.h"

namespace penumbra::programs {

struct Value {
  Type type;
  std::vector<std::uint32_t> words;
};

// Throws a program away: the language leaves its meaning open, or floats cannot hold its results exactly.
class Unfit : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

Value convert(const Value& value, const Type& to);  // converts numbers, by a cast or without

// The type that both operands are brought to: it has the higher base and the smaller shape, where a scalar
// counts as any.
Type common_type(const Type& a, const Type& b);

Value unary(const std::string& op, const Value& value);
Value binary(const std::string& op, const Value& a, const Value& b);
Value choose(const Value& condition, const Value& yes, const Value& no);
Value intrinsic(const std::string& name, const Type& type, const std::vector<Value>& arguments);

}  // namespace penumbra::programs
