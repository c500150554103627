#include "lint/arithmetic.h"

#include <set>

#include <glslang/SPIRV/GLSL.std.450.h>

#include <cmath>

#include "lint/value_range.h"

namespace penumbra::lint {

namespace {

bool is_pow(const spirv::Instruction& instruction) {
  return instruction.op == spv::OpExtInst && instruction.operands[1] == GLSLstd450Pow;
}

// An integer exponent is compiled to multiplications, which accept any base.
bool may_be_undefined(ValueRanges& ranges, const spirv::Instruction& pow) {
  const std::optional<double> exponent = ranges.constant(pow.operands[3]);
  if (exponent && *exponent == std::floor(*exponent)) return false;
  return ranges.of(pow.operands[2]).low < 0;
}

bool compares_with_itself(const spirv::Instruction& instruction) {
  switch (instruction.op) {
    case spv::OpFOrdEqual:
    case spv::OpFUnordEqual:
    case spv::OpFOrdNotEqual:
    case spv::OpFUnordNotEqual:
      return instruction.operands[0] == instruction.operands[1];
    default:
      return false;
  }
}

}  // namespace

std::vector<hlsl::Diagnostic> arithmetic_findings(const LintedCode& linted) {
  std::vector<hlsl::Diagnostic> findings;
  std::set<spirv::Id> tested_for_infinity;  // isfinite() tests one value for both
  for (const spirv::Instruction& instruction : linted.code.instructions())
    if (instruction.op == spv::OpIsInf) tested_for_infinity.insert(instruction.operands[0]);
  ValueRanges ranges(linted.code);
  for (const spirv::Instruction& instruction : linted.code.instructions()) {
    if (is_pow(instruction) && may_be_undefined(ranges, instruction)) {
      findings.push_back(finding_at(linted, "negative-pow", instruction.place, {"pow"},
                                    "pow of a base that may be negative gives NaN: bound it with abs, max or "
                                    "saturate"));
    } else if (instruction.op == spv::OpIsNan && tested_for_infinity.contains(instruction.operands[0])) {
      findings.push_back(
          finding_at(linted, "nan-check", instruction.place, {"isfinite", "isnan"},
                     "compilers may remove this test for infinity and NaN under fast math: test the bits, "
                     "(asuint(x) & 0x7F800000) != 0x7F800000 for finite numbers"));
    } else if (instruction.op == spv::OpIsNan || compares_with_itself(instruction)) {
      findings.push_back(finding_at(linted, "nan-check", instruction.place, {"isnan"},
                                    "compilers may remove this test for NaN under fast math: test the bits, "
                                    "(asuint(x) & 0x7FFFFFFF) > 0x7F800000"));
    }
  }
  return findings;
}

}  // namespace penumbra::lint
