#include "shaders/uncalled_functions.h"

#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "shaders/spirv_words.h"

namespace penumbra::shaders {

namespace {

using Ids = std::unordered_set<std::uint32_t>;

struct Instruction {
  spv::Op op = spv::OpNop;
  std::size_t at = 0;
  std::size_t length = 0;
};

// Empty for what is no module.
std::vector<Instruction> instructions(const SpirvModule& module) {
  std::vector<Instruction> found;
  for (std::size_t at = header_words; at < module.size();) {
    const std::size_t length = module[at] >> 16U;
    if (length == 0 || at + length > module.size()) return {};
    found.push_back({static_cast<spv::Op>(module[at] & 0xFFFFU), at, length});
    at += length;
  }
  return found;
}

std::uint32_t operand(const SpirvModule& module, const Instruction& instruction, std::size_t number) {
  return number < instruction.length ? module[instruction.at + number] : 0;
}

Ids called_functions(const SpirvModule& module, const std::vector<Instruction>& all) {
  std::vector<std::uint32_t> to_visit;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> calls;
  std::uint32_t function = 0;
  for (const Instruction& instruction : all) {
    if (instruction.op == spv::OpEntryPoint) to_visit.push_back(operand(module, instruction, 2));
    if (instruction.op == spv::OpFunction) function = operand(module, instruction, 2);
    if (instruction.op == spv::OpFunctionCall) calls[function].push_back(operand(module, instruction, 3));
  }
  Ids called;
  while (!to_visit.empty()) {
    const std::uint32_t next = to_visit.back();
    to_visit.pop_back();
    if (!called.insert(next).second) continue;
    to_visit.insert(to_visit.end(), calls[next].begin(), calls[next].end());
  }
  return called;
}

// The id that it defines; 0 when it defines none.
std::uint32_t result(const SpirvModule& module, const Instruction& instruction) {
  bool has_result = false;
  bool has_type = false;
  spv::HasResultAndType(instruction.op, &has_result, &has_type);
  return has_result ? operand(module, instruction, has_type ? 2 : 1) : 0;
}

bool describes(const Instruction& instruction) {
  return instruction.op == spv::OpName || instruction.op == spv::OpDecorate ||
         instruction.op == spv::OpDecorateId || instruction.op == spv::OpDecorateString;
}

}  // namespace

void drop_uncalled_functions(SpirvModule& module) {
  const std::vector<Instruction> all = instructions(module);
  const Ids called = called_functions(module, all);
  std::vector<bool> goes(all.size(), false);
  Ids gone;
  bool inside = false;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].op == spv::OpFunction) inside = called.count(operand(module, all[i], 2)) == 0;
    goes[i] = inside;
    if (inside) gone.insert(result(module, all[i]));
    if (all[i].op == spv::OpFunctionEnd) inside = false;
  }
  if (gone.empty()) return;
  SpirvModule kept(module.begin(), module.begin() + header_words);
  kept.reserve(module.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (goes[i] || (describes(all[i]) && gone.count(operand(module, all[i], 1)) != 0)) continue;
    const auto begin = module.begin() + static_cast<std::ptrdiff_t>(all[i].at);
    kept.insert(kept.end(), begin, begin + static_cast<std::ptrdiff_t>(all[i].length));
  }
  module = std::move(kept);
}

}  // namespace penumbra::shaders
