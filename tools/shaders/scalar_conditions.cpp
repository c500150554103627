#include "shaders/scalar_conditions.h"

#include <unordered_set>

#include "shaders/spirv_words.h"

namespace penumbra::shaders {

namespace {

constexpr std::uint32_t opcode_mask = 0xFFFFU;

// Every instruction by its place; ends where a length is none, which is left to the validator.
template <typename Visit>
void each_instruction(const SpirvModule& module, Visit visit) {
  for (std::size_t at = header_words; at < module.size();) {
    const std::size_t length = module[at] >> 16U;
    if (length == 0 || at + length > module.size()) return;
    visit(at, module[at] & opcode_mask, length);
    at += length;
  }
}

}  // namespace

void copy_scalar_conditions(SpirvModule& module) {
  std::unordered_set<std::uint32_t> bool_types;
  std::unordered_set<std::uint32_t> bools;  // results of a type of bool: words 1 and 2 of what has both
  each_instruction(module, [&](std::size_t at, std::uint32_t opcode, std::size_t length) {
    if (opcode == spv::OpTypeBool && length == 2) bool_types.insert(module[at + 1]);
    if (length < 3 || bool_types.count(module[at + 1]) == 0) return;
    const bool condition = (opcode == spv::OpAny || opcode == spv::OpAll) && length == 4;
    if (condition && bools.count(module[at + 3]) != 0)
      module[at] = (module[at] & ~opcode_mask) | spv::OpCopyObject;
    bools.insert(module[at + 2]);
  });
}

}  // namespace penumbra::shaders
