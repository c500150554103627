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

// What the language leaves open, or what floats cannot hold exactly: the program is thrown away.
class Unfit : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

Value convert(const Value& value, const Type& to);  // of numbers, by a cast or without

// The type that both operands are brought to: the higher base, the smaller shape, a scalar counting as any.
Type common_type(const Type& a, const Type& b);

Value unary(const std::string& op, const Value& value);
Value binary(const std::string& op, const Value& a, const Value& b);
Value choose(const Value& condition, const Value& yes, const Value& no);
Value intrinsic(const std::string& name, const Type& type, const std::vector<Value>& arguments);

}  // namespace penumbra::programs
