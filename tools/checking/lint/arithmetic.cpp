#include <glslang/SPIRV/GLSL.std.450.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "lint/stage_rules.h"
#include "spirv/code.h"

namespace penumbra::lint {
namespace {

// Interval analysis: the range of a floating-point value, from the instructions that compute it.
//
// The interval arithmetic is without NaN, as compilers with fast math assume, which Direct3D's and Unity's
// are. A vector has one range for all its components. Loop-carried values are unknown.
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

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int deepest = 256;

Range hull(const Range& a, const Range& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

// The product of 0 and infinity is 0, because infinite bounds are not attained.
double times(double a, double b) {
  return a == 0 || b == 0 ? 0 : a * b;
}

Range product(const Range& a, const Range& b) {
  const double corners[] = {times(a.low, b.low), times(a.low, b.high), times(a.high, b.low),
                            times(a.high, b.high)};
  return {*std::min_element(std::begin(corners), std::end(corners)),
          *std::max_element(std::begin(corners), std::end(corners))};
}

Range quotient(const Range& a, const Range& b) {
  if (b.low < 0 && b.high > 0) return {};
  const Range inverse = b.low >= 0
                            ? Range{b.high == 0 ? infinity : 1 / b.high, b.low == 0 ? infinity : 1 / b.low}
                            : Range{b.high == 0 ? -infinity : 1 / b.high, 1 / b.low};
  return product(a, inverse);
}

Range absolute(const Range& a) {
  const double far = std::max(std::abs(a.low), std::abs(a.high));
  return {a.low <= 0 && a.high >= 0 ? 0 : std::min(std::abs(a.low), std::abs(a.high)), far};
}

Range ValueRanges::of(spirv::Id value) {
  const auto known = known_.find(value);
  if (known != known_.end()) return known->second;
  const spirv::Instruction* instruction = code_.definition(value);
  if (instruction == nullptr || depth_ > deepest) return {};
  known_[value] = {};  // a loop-carried value
  ++depth_;
  const Range range = compute(*instruction);
  --depth_;
  known_[value] = range;
  return range;
}

std::optional<double> ValueRanges::constant(spirv::Id value) const {
  const spirv::Instruction* of = code_.definition(value);
  if (of == nullptr) return std::nullopt;
  if (of->op == spv::OpConstant) {
    const spirv::Instruction* type = code_.definition(of->type);
    if (type == nullptr || type->op != spv::OpTypeFloat || type->operands[0] != 32) return std::nullopt;
    float number = 0;
    std::memcpy(&number, &of->operands[0], sizeof number);
    return number;
  }
  if (of->op != spv::OpConstantComposite && of->op != spv::OpCompositeConstruct) return std::nullopt;
  std::optional<double> first;
  for (const spirv::Id part : of->operands) {
    const std::optional<double> number = code_.op(part) == spv::OpConstant ? constant(part) : std::nullopt;
    if (!number || (first && *first != *number)) return std::nullopt;
    first = number;
  }
  return first;
}

Range ValueRanges::of_operands(const spirv::Instruction& instruction, std::size_t first, std::size_t step) {
  std::optional<Range> range;
  for (std::size_t i = first; i < instruction.operands.size(); i += step) {
    const Range part = of(instruction.operands[i]);
    range = range ? hull(*range, part) : part;
  }
  return range.value_or(Range{});
}

Range ValueRanges::of_constant(const spirv::Instruction& instruction) {
  if (instruction.op == spv::OpConstantNull) return {0, 0};
  if (instruction.op == spv::OpConstantComposite) return of_operands(instruction, 0, 1);
  const std::optional<double> number = constant(instruction.result);
  return number && !std::isnan(*number) ? Range{*number, *number} : Range{};
}

Range ValueRanges::of_product(spirv::Id a, spirv::Id b) {
  const Range range = product(of(a), of(b));
  return a == b ? Range{std::max(0.0, absolute(of(a)).low * absolute(of(a)).low), range.high} : range;
}

// Traces a component to the part of the vector from which it comes.
Range ValueRanges::of_component(spirv::Id vector, std::uint32_t component) {
  for (int steps = 0; steps < deepest; ++steps) {
    const spirv::Instruction* whole = code_.definition(vector);
    if (whole == nullptr || code_.op(whole->type) != spv::OpTypeVector) return {};
    const auto& operands = whole->operands;
    if (whole->op == spv::OpCompositeInsert && operands.size() == 3) {
      if (operands[2] == component) return of(operands[0]);
      vector = operands[1];
    } else if (whole->op == spv::OpVectorShuffle) {
      const std::uint32_t chosen = operands[2 + component];
      const std::uint32_t first = components(operands[0]);
      vector = chosen < first ? operands[0] : operands[1];
      component = chosen < first ? chosen : chosen - first;
    } else if (whole->op == spv::OpCompositeConstruct) {
      std::size_t part = 0;
      for (; part + 1 < operands.size() && component >= components(operands[part]); ++part)
        component -= components(operands[part]);
      if (components(operands[part]) == 1) return of(operands[part]);
      vector = operands[part];
    } else {
      return of(vector);
    }
  }
  return {};
}

Range ValueRanges::of_shuffle(const spirv::Instruction& instruction) {
  std::optional<Range> range;
  for (std::uint32_t i = 0; i + 2 < instruction.operands.size(); ++i) {
    const Range part = of_component(instruction.result, i);
    range = range ? hull(*range, part) : part;
  }
  return range.value_or(Range{});
}

std::uint32_t ValueRanges::components(spirv::Id value) const {
  const spirv::Instruction* of = code_.definition(value);
  const spirv::Instruction* type = of == nullptr ? nullptr : code_.definition(of->type);
  return type != nullptr && type->op == spv::OpTypeVector ? type->operands[1] : 1;
}

// Returns whether an integer cannot be negative: a constant, or a loop counter that starts at such a constant
// and increases.
bool ValueRanges::counts_up(spirv::Id integer) const {
  const std::optional<std::int64_t> number = code_.integer(integer);
  if (number) return *number >= 0;
  const spirv::Instruction* phi = code_.definition(integer);
  if (phi == nullptr || phi->op != spv::OpPhi) return false;
  for (std::size_t i = 0; i + 1 < phi->operands.size(); i += 2) {
    const spirv::Instruction* next = code_.definition(phi->operands[i]);
    const bool starts = code_.integer(phi->operands[i]).value_or(-1) >= 0;
    const bool grows = next != nullptr && next->op == spv::OpIAdd && next->operands[0] == integer &&
                       code_.integer(next->operands[1]).value_or(-1) >= 0;
    if (!starts && !grows) return false;
  }
  return true;
}

Range ValueRanges::compute(const spirv::Instruction& instruction) {
  const auto& operands = instruction.operands;
  switch (instruction.op) {
    case spv::OpConstant:
    case spv::OpConstantNull:
    case spv::OpConstantComposite:
      return of_constant(instruction);
    case spv::OpCompositeConstruct:
      return of_operands(instruction, 0, 1);
    case spv::OpCompositeExtract:
      return operands.size() == 2 ? of_component(operands[0], operands[1]) : Range{};
    case spv::OpVectorShuffle:
      return of_shuffle(instruction);
    case spv::OpCompositeInsert:
      return hull(of(operands[0]), of(operands[1]));
    case spv::OpCopyObject:
    case spv::OpFConvert:
    case spv::OpQuantizeToF16:
      return of(operands[0]);
    case spv::OpSelect:
      return hull(of(operands[1]), of(operands[2]));
    case spv::OpPhi:
      return of_operands(instruction, 0, 2);
    case spv::OpFNegate: {
      const Range a = of(operands[0]);
      return {-a.high, -a.low};
    }
    case spv::OpFAdd: {
      const Range a = of(operands[0]);
      const Range b = of(operands[1]);
      return {a.low + b.low, a.high + b.high};
    }
    case spv::OpFSub: {
      const Range a = of(operands[0]);
      const Range b = of(operands[1]);
      return {a.low - b.high, a.high - b.low};
    }
    case spv::OpFMul:
    case spv::OpVectorTimesScalar:
      return of_product(operands[0], operands[1]);
    case spv::OpFDiv:
      return quotient(of(operands[0]), of(operands[1]));
    case spv::OpDot:
      return operands[0] == operands[1] || product(of(operands[0]), of(operands[1])).low >= 0
                 ? Range{0, infinity}
                 : Range{};
    case spv::OpConvertUToF:
      return {0, infinity};
    case spv::OpConvertSToF:
      return counts_up(operands[0]) ? Range{0, infinity} : Range{};
    case spv::OpExtInst:
      return of_extended(instruction);
    default:
      return {};
  }
}

Range ValueRanges::of_extended(const spirv::Instruction& instruction) {
  const auto argument = [&](std::size_t i) { return of(instruction.operands[2 + i]); };
  switch (instruction.operands[1]) {
    case GLSLstd450FAbs:
      return absolute(argument(0));
    case GLSLstd450FClamp:
    case GLSLstd450NClamp: {
      const Range value = argument(0);
      const Range low = argument(1);
      const Range high = argument(2);
      return {std::min(std::max(value.low, low.low), high.high),
              std::max(std::min(value.high, high.high), low.low)};
    }
    case GLSLstd450FMax:
    case GLSLstd450NMax:
      return {std::max(argument(0).low, argument(1).low), std::max(argument(0).high, argument(1).high)};
    case GLSLstd450FMin:
    case GLSLstd450NMin:
      return {std::min(argument(0).low, argument(1).low), std::min(argument(0).high, argument(1).high)};
    case GLSLstd450Sqrt:
    case GLSLstd450InverseSqrt:
    case GLSLstd450Exp:
    case GLSLstd450Exp2:
    case GLSLstd450Pow:
    case GLSLstd450Length:
    case GLSLstd450Distance:
      return {0, infinity};
    case GLSLstd450Fract:
    case GLSLstd450SmoothStep:
    case GLSLstd450Step:
      return {0, 1};
    case GLSLstd450Sin:
    case GLSLstd450Cos:
    case GLSLstd450Normalize:
    case GLSLstd450FSign:
      return {-1, 1};
    case GLSLstd450Floor:
      return {std::floor(argument(0).low), std::floor(argument(0).high)};
    case GLSLstd450Ceil:
      return {std::ceil(argument(0).low), std::ceil(argument(0).high)};
    case GLSLstd450FMix: {
      const Range weight = argument(2);
      return weight.low >= 0 && weight.high <= 1 ? hull(argument(0), argument(1)) : Range{};
    }
    case GLSLstd450Fma: {
      const Range scaled = product(argument(0), argument(1));
      return {scaled.low + argument(2).low, scaled.high + argument(2).high};
    }
    default:
      return {};
  }
}

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
