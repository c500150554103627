#include "lint/thread_values.h"

#include <algorithm>

namespace penumbra::lint {
namespace {

constexpr int deepest_value = 200;
constexpr std::size_t most_threads = 1'024;  // D3D11_CS_THREAD_GROUP_MAX_THREADS_PER_GROUP

using Operation = std::uint32_t (*)(std::uint32_t, std::uint32_t);

std::int32_t as_signed(std::uint32_t value) {
  return static_cast<std::int32_t>(value);
}

// The second argument of an operation on one value is that value, too.
const std::map<spv::Op, Operation>& operations() {
  using U = std::uint32_t;
  static const std::map<spv::Op, Operation> all{
      {spv::OpCopyObject, [](U a, U) { return a; }},
      {spv::OpBitcast, [](U a, U) { return a; }},
      {spv::OpNot, [](U a, U) { return ~a; }},
      {spv::OpSNegate, [](U a, U) { return 0U - a; }},
      {spv::OpLogicalNot, [](U a, U) { return U{a == 0}; }},
      {spv::OpIAdd, [](U a, U b) { return a + b; }},
      {spv::OpISub, [](U a, U b) { return a - b; }},
      {spv::OpIMul, [](U a, U b) { return a * b; }},
      {spv::OpUDiv, [](U a, U b) { return b == 0 ? 0 : a / b; }},
      {spv::OpUMod, [](U a, U b) { return b == 0 ? 0 : a % b; }},
      {spv::OpShiftLeftLogical, [](U a, U b) { return a << (b & 31); }},
      {spv::OpShiftRightLogical, [](U a, U b) { return a >> (b & 31); }},
      {spv::OpShiftRightArithmetic, [](U a, U b) { return static_cast<U>(as_signed(a) >> (b & 31)); }},
      {spv::OpBitwiseAnd, [](U a, U b) { return a & b; }},
      {spv::OpBitwiseOr, [](U a, U b) { return a | b; }},
      {spv::OpBitwiseXor, [](U a, U b) { return a ^ b; }},
      {spv::OpLogicalAnd, [](U a, U b) { return a & b; }},
      {spv::OpLogicalOr, [](U a, U b) { return a | b; }},
      {spv::OpIEqual, [](U a, U b) { return U{a == b}; }},
      {spv::OpINotEqual, [](U a, U b) { return U{a != b}; }},
      {spv::OpULessThan, [](U a, U b) { return U{a < b}; }},
      {spv::OpULessThanEqual, [](U a, U b) { return U{a <= b}; }},
      {spv::OpUGreaterThan, [](U a, U b) { return U{a > b}; }},
      {spv::OpUGreaterThanEqual, [](U a, U b) { return U{a >= b}; }},
      {spv::OpSLessThan, [](U a, U b) { return U{as_signed(a) < as_signed(b)}; }},
      {spv::OpSLessThanEqual, [](U a, U b) { return U{as_signed(a) <= as_signed(b)}; }},
      {spv::OpSGreaterThan, [](U a, U b) { return U{as_signed(a) > as_signed(b)}; }},
      {spv::OpSGreaterThanEqual, [](U a, U b) { return U{as_signed(a) >= as_signed(b)}; }}};
  return all;
}

}  // namespace

ThreadValues::ThreadValues(const spirv::Code& code) : code_(code) {
  for (const spirv::Instruction& instruction : code.instructions())
    if (instruction.op == spv::OpExecutionMode && instruction.operands[1] == spv::ExecutionModeLocalSize)
      size_.assign(instruction.operands.begin() + 2, instruction.operands.end());
  if (size_.size() != 3) return;
  const std::size_t threads = std::size_t{size_[0]} * size_[1] * size_[2];
  threads_ = threads <= most_threads ? threads : 0;
}

const ThreadValues::OfThreads* ThreadValues::of(spirv::Id value) {
  const std::optional<Components>& known = components(value);
  return known && known->size() == 1 ? &known->front() : nullptr;
}

const std::optional<ThreadValues::Components>& ThreadValues::components(spirv::Id value) {
  const auto [entry, is_new] = known_.try_emplace(value);
  const spirv::Instruction* definition = code_.definition(value);
  if (is_new && definition != nullptr && depth_ < deepest_value) {
    ++depth_;
    std::optional<Components> found = computed(*definition);
    entry->second = std::move(found);
    --depth_;
  }
  return entry->second;
}

ThreadValues::OfThreads ThreadValues::thread_number(std::size_t axis) const {
  OfThreads numbers(threads_);
  for (std::uint32_t i = 0; i < threads_; ++i)
    numbers[i] = axis == 0 ? i % size_[0] : axis == 1 ? i / size_[0] % size_[1] : i / size_[0] / size_[1];
  return numbers;
}

std::optional<ThreadValues::Components> ThreadValues::loaded(const spirv::Instruction& load) {
  const spirv::Instruction* pointer = code_.definition(load.operands[0]);
  std::optional<std::int64_t> axis;
  if (pointer != nullptr && pointer->op == spv::OpAccessChain && pointer->operands.size() == 2) {
    axis = code_.integer(pointer->operands[1]);
    if (!axis) return std::nullopt;
    pointer = code_.definition(pointer->operands[0]);
  }
  if (pointer == nullptr || pointer->op != spv::OpVariable) return std::nullopt;
  Components all;
  switch (code_.decoration(pointer->result, spv::DecorationBuiltIn).value_or(spv::BuiltInMax)) {
    case spv::BuiltInLocalInvocationIndex:
      all.emplace_back(threads_);
      for (std::uint32_t i = 0; i < threads_; ++i) all[0][i] = i;
      return all;
    case spv::BuiltInLocalInvocationId:
    case spv::BuiltInGlobalInvocationId:
      for (std::size_t i = 0; i < 3; ++i) all.push_back(thread_number(i));
      break;
    case spv::BuiltInWorkgroupId:
      all.assign(3, OfThreads(threads_));
      break;
    default:
      return std::nullopt;
  }
  if (axis) all = {all[static_cast<std::size_t>(std::clamp<std::int64_t>(*axis, 0, 2))]};
  return all;
}

std::optional<ThreadValues::Components> ThreadValues::computed(const spirv::Instruction& instruction) {
  const auto& operands = instruction.operands;
  if (instruction.op == spv::OpLoad) return loaded(instruction);
  if (instruction.op == spv::OpConstant) return Components{OfThreads(threads_, operands[0])};
  if (instruction.op == spv::OpConstantTrue || instruction.op == spv::OpConstantFalse)
    return Components{OfThreads(threads_, instruction.op == spv::OpConstantTrue ? 1 : 0)};
  if (instruction.op == spv::OpPhi) return std::nullopt;
  std::vector<const Components*> given;
  for (const spirv::Id id : code_.ids(instruction)) {
    const std::optional<Components>& of = components(id);
    if (!of) return std::nullopt;
    given.push_back(&*of);
  }
  if (given.empty()) return std::nullopt;
  Components all;
  if (instruction.op == spv::OpCompositeConstruct || instruction.op == spv::OpConstantComposite) {
    for (const Components* part : given) all.insert(all.end(), part->begin(), part->end());
    return all;
  }
  if (instruction.op == spv::OpCompositeExtract || instruction.op == spv::OpVectorShuffle) {
    Components from = *given[0];
    const std::size_t sources = instruction.op == spv::OpVectorShuffle ? 2 : 1;
    if (sources == 2) from.insert(from.end(), given.back()->begin(), given.back()->end());
    for (const std::uint32_t place : operands.subspan(sources)) {
      if (place >= from.size()) return std::nullopt;
      all.push_back(from[place]);
    }
    return all;
  }
  const std::size_t size = given[0]->size();
  const bool same_size =
      std::all_of(given.begin(), given.end(), [&](const Components* of) { return of->size() == size; });
  const auto operation = operations().find(instruction.op);
  const bool selects = instruction.op == spv::OpSelect;
  if (!same_size || (!selects && operation == operations().end())) return std::nullopt;
  for (std::size_t part = 0; part < size; ++part) {
    all.emplace_back(threads_);
    for (std::size_t i = 0; i < threads_; ++i) {
      const std::uint32_t first = (*given[0])[part][i];
      all.back()[i] = selects ? (*given[first != 0 ? 1 : 2])[part][i]
                              : operation->second(first, (*given.back())[part][i]);
    }
  }
  return all;
}

}  // namespace penumbra::lint
