#include "lint/first_iteration.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>

namespace penumbra::lint {

namespace {

constexpr int deepest_expression = 16;
constexpr int most_blocks_back = 8;

double as_unsigned(double value) {
  return value < 0 ? value + 4294967296.0 : value;
}

// The values of a loop's condition before its first iteration, as far as they are constant.
class FirstRound {
 public:
  FirstRound(const spirv::Code& code, const spirv::Function& function, const ControlFlow& flow,
             std::size_t before)
      : code_(code), function_(function), flow_(flow), before_(before) {}

  std::optional<double> value(spirv::Id id, int depth = 0) const {
    const spirv::Instruction* of = code_.definition(id);
    if (of == nullptr || depth > deepest_expression) return std::nullopt;
    switch (of->op) {
      case spv::OpConstantTrue:
        return 1.0;
      case spv::OpConstantFalse:
        return 0.0;
      case spv::OpConstant:
        return constant(*of);
      case spv::OpLoad:
        return stored(of->operands[0], depth + 1);
      case spv::OpConvertSToF:
      case spv::OpConvertUToF:
      case spv::OpBitcast:
        return value(of->operands[0], depth + 1);
      default:
        return of->operands.size() == 2 ? binary(*of, depth + 1) : std::nullopt;
    }
  }

 private:
  std::optional<double> constant(const spirv::Instruction& of) const {
    if (const std::optional<std::int64_t> integer = code_.integer(of.result))
      return static_cast<double>(*integer);
    const spirv::Instruction* type = code_.definition(of.type);
    if (type == nullptr || type->op != spv::OpTypeFloat || type->operands[0] != 32) return std::nullopt;
    float number = 0;
    std::memcpy(&number, &of.operands[0], sizeof number);
    return std::isfinite(number) ? std::optional<double>(number) : std::nullopt;
  }

  std::optional<double> binary(const spirv::Instruction& of, int depth) const {
    const std::optional<double> a = value(of.operands[0], depth);
    const std::optional<double> b = value(of.operands[1], depth);
    if (!a || !b) return std::nullopt;
    switch (of.op) {
      case spv::OpSLessThan:
      case spv::OpFOrdLessThan:
        return *a < *b;
      case spv::OpSLessThanEqual:
      case spv::OpFOrdLessThanEqual:
        return *a <= *b;
      case spv::OpSGreaterThan:
      case spv::OpFOrdGreaterThan:
        return *a > *b;
      case spv::OpSGreaterThanEqual:
      case spv::OpFOrdGreaterThanEqual:
        return *a >= *b;
      case spv::OpULessThan:
        return as_unsigned(*a) < as_unsigned(*b);
      case spv::OpULessThanEqual:
        return as_unsigned(*a) <= as_unsigned(*b);
      case spv::OpUGreaterThan:
        return as_unsigned(*a) > as_unsigned(*b);
      case spv::OpUGreaterThanEqual:
        return as_unsigned(*a) >= as_unsigned(*b);
      case spv::OpINotEqual:
        return *a != *b;
      case spv::OpIEqual:
        return *a == *b;
      case spv::OpLogicalAnd:
        return *a != 0 && *b != 0;
      case spv::OpLogicalOr:
        return *a != 0 || *b != 0;
      default:
        return std::nullopt;
    }
  }

  // A variable, or one component of one that is a vector.
  struct Target {
    spirv::Id variable = 0;
    std::optional<std::int64_t> component;
  };
  std::optional<Target> target(spirv::Id pointer) const {
    if (code_.op(pointer) == spv::OpVariable) return Target{pointer, std::nullopt};
    const spirv::Instruction* chain = code_.definition(pointer);
    if (chain == nullptr || chain->op != spv::OpAccessChain || chain->operands.size() != 2)
      return std::nullopt;
    const spirv::Instruction* variable = code_.definition(chain->operands[0]);
    const bool vector = variable != nullptr && variable->op == spv::OpVariable &&
                        code_.op(code_.pointee(variable->type)) == spv::OpTypeVector;
    const std::optional<std::int64_t> component = code_.integer(chain->operands[1]);
    if (!vector || !component) return std::nullopt;
    return Target{chain->operands[0], component};
  }

  // The answer to whether an instruction writes to the given part; `unknown` if it writes to an unknown part
  // of the variable.
  enum class Writes { no, yes, unknown };
  Writes writes(const spirv::Instruction& instruction, const Target& asked) const {
    const auto names = [&](spirv::Id id) {
      const spirv::Instruction* of = code_.definition(id);
      return id == asked.variable ||
             (of != nullptr && of->op == spv::OpAccessChain && of->operands[0] == asked.variable);
    };
    if (instruction.op == spv::OpFunctionCall)
      return std::any_of(instruction.operands.begin(), instruction.operands.end(), names) ? Writes::unknown
                                                                                          : Writes::no;
    if (instruction.op != spv::OpStore || !names(instruction.operands[0])) return Writes::no;
    const std::optional<Target> written = target(instruction.operands[0]);
    if (!written || (written->component && !asked.component)) return Writes::unknown;
    return !written->component || written->component == asked.component ? Writes::yes : Writes::no;
  }

  // Returns the value that the last store before the loop wrote to a variable.
  std::optional<double> stored(spirv::Id pointer, int depth) const {
    const std::optional<Target> asked = target(pointer);
    if (!asked) return std::nullopt;
    std::size_t node = before_;
    for (int back = 0; back < most_blocks_back; ++back) {
      const spirv::Block& block = function_.blocks[node];
      for (std::size_t i = block.end; i-- > block.begin;) {
        const spirv::Instruction& instruction = code_.instructions()[i];
        const Writes write = writes(instruction, *asked);
        if (write == Writes::unknown) return std::nullopt;
        if (write == Writes::no) continue;
        const bool whole = target(instruction.operands[0])->component == std::nullopt;
        return whole && asked->component ? component(instruction.operands[1], *asked->component, depth)
                                         : value(instruction.operands[1], depth);
      }
      if (flow_.predecessors[node].size() != 1) return std::nullopt;
      node = flow_.predecessors[node].front();
    }
    return std::nullopt;
  }

  // Returns one component of a vector that is composed of parts.
  std::optional<double> component(spirv::Id vector, std::int64_t index, int depth) const {
    const spirv::Instruction* of = code_.definition(vector);
    const bool composite =
        of != nullptr && (of->op == spv::OpCompositeConstruct || of->op == spv::OpConstantComposite);
    if (!composite) return std::nullopt;
    for (const spirv::Id part : of->operands) {
      const spirv::Instruction* definition = code_.definition(part);
      const spirv::Instruction* type = definition == nullptr ? nullptr : code_.definition(definition->type);
      if (type == nullptr) return std::nullopt;
      const std::int64_t number = type->op == spv::OpTypeVector ? type->operands[1] : 1;
      if (index < number) return number == 1 ? value(part, depth) : component(part, index, depth + 1);
      index -= number;
    }
    return std::nullopt;
  }

  const spirv::Code& code_;
  const spirv::Function& function_;
  const ControlFlow& flow_;
  std::size_t before_;
};

// Returns the block of a loop with the loop condition: the header, or its successor.
std::size_t test_of(const ControlFlow& flow, std::size_t header) {
  if (flow.successors[header].size() != 1) return header;
  const std::size_t next = flow.successors[header].front();
  return flow.predecessors[next].size() == 1 ? next : header;
}

std::optional<std::size_t> only_way_in(const ControlFlow& flow, std::size_t header) {
  std::optional<std::size_t> before;
  for (const std::size_t from : flow.predecessors[header]) {
    if (flow.dominates(header, from)) continue;
    if (before) return std::nullopt;
    before = from;
  }
  return before;
}

void peel(const spirv::Code& code, const spirv::Function& function, const ControlFlow& flow,
          std::size_t header, Paths& paths) {
  const std::size_t test = test_of(flow, header);
  const std::optional<std::size_t> before = only_way_in(flow, header);
  const spirv::Instruction& branch = terminator(code, function.blocks[test]);
  if (!before || branch.op != spv::OpBranchConditional || flow.successors[test].size() != 2) return;
  const FirstRound first(code, function, flow, *before);
  const std::optional<double> condition = first.value(branch.operands[0]);
  if (!condition) return;
  const std::size_t inside = flow.successors[test][*condition != 0 ? 0 : 1];
  const std::size_t copy = paths.block.size();
  paths.block.push_back(header);
  paths.successors.emplace_back();
  if (test != header) {
    paths.successors[copy] = {copy + 1};
    paths.block.push_back(test);
    paths.successors.emplace_back();
  }
  paths.successors.back() = {inside};
  for (std::size_t& to : paths.successors[*before])
    if (to == header) to = copy;
}

}  // namespace

Paths paths_of(const spirv::Code& code, const spirv::Function& function) {
  const ControlFlow flow = control_flow(code, function);
  Paths paths;
  paths.successors = flow.successors;
  for (std::size_t i = 0; i < function.blocks.size(); ++i) paths.block.push_back(i);
  for (const std::size_t node : flow.order) {
    const spirv::Block& block = function.blocks[node];
    const bool loop = flow.merge[node] != no_node && block.end - block.begin > 1 &&
                      code.instructions()[block.end - 2].op == spv::OpLoopMerge;
    if (loop) peel(code, function, flow, node, paths);
  }
  paths.predecessors = reversed(paths.successors);
  paths.order = reverse_postorder(paths.successors, 0);
  return paths;
}

}  // namespace penumbra::lint
