#include "shaders/uncalled_functions.h"

#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

using Ids = std::unordered_set<std::uint32_t>;

// Returns an empty list for malformed words.
std::vector<spirv::Words> instructions(const SpirvModule& module) {
  std::vector<spirv::Words> found;
  const bool whole = spirv::for_each_instruction(module, [&](spirv::Words words) { found.push_back(words); });
  return whole ? found : std::vector<spirv::Words>();
}

Ids called_functions(const std::vector<spirv::Words>& all) {
  std::vector<std::uint32_t> to_visit;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> calls;
  std::uint32_t function = 0;
  for (const spirv::Words instruction : all) {
    const spv::Op op = spirv::opcode(instruction);
    if (op == spv::OpEntryPoint) to_visit.push_back(spirv::operand(instruction, 2));
    if (op == spv::OpFunction) function = spirv::operand(instruction, 2);
    if (op == spv::OpFunctionCall) calls[function].push_back(spirv::operand(instruction, 3));
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

// Returns the id that the instruction defines, or 0.
std::uint32_t result(spirv::Words instruction) {
  bool has_result = false;
  bool has_type = false;
  spv::HasResultAndType(spirv::opcode(instruction), &has_result, &has_type);
  return has_result ? spirv::operand(instruction, has_type ? 2 : 1) : 0;
}

bool describes(spirv::Words instruction) {
  const spv::Op op = spirv::opcode(instruction);
  return op == spv::OpName || op == spv::OpDecorate || op == spv::OpDecorateId || op == spv::OpDecorateString;
}

}  // namespace

void drop_uncalled_functions(SpirvModule& module) {
  const std::vector<spirv::Words> all = instructions(module);
  const Ids called = called_functions(all);
  Ids gone;
  bool inside = false;
  std::vector<bool> goes;
  for (const spirv::Words instruction : all) {
    const spv::Op op = spirv::opcode(instruction);
    if (op == spv::OpFunction) inside = called.count(spirv::operand(instruction, 2)) == 0;
    goes.push_back(inside);
    if (inside) gone.insert(result(instruction));
    if (op == spv::OpFunctionEnd) inside = false;
  }
  if (gone.empty()) return;
  std::size_t number = 0;
  module = spirv::with_instructions(module, [&](spirv::Words instruction) {
    return !goes[number++] && !(describes(instruction) && gone.count(spirv::operand(instruction, 1)) != 0);
  });
}

}  // namespace penumbra::shaders
