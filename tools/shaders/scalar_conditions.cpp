#include "shaders/scalar_conditions.h"

#include <unordered_set>

namespace penumbra::shaders {

namespace {

// SPIR-V specification 1.3, section 3.32.
constexpr std::size_t header_words = 5;
constexpr std::uint32_t op_type_bool = 20;
constexpr std::uint32_t op_copy_object = 83;
constexpr std::uint32_t op_any = 154;
constexpr std::uint32_t op_all = 155;
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
    if (opcode == op_type_bool && length == 2) bool_types.insert(module[at + 1]);
    if (length < 3 || bool_types.count(module[at + 1]) == 0) return;
    const bool condition = (opcode == op_any || opcode == op_all) && length == 4;
    if (condition && bools.count(module[at + 3]) != 0)
      module[at] = (module[at] & ~opcode_mask) | op_copy_object;
    bools.insert(module[at + 2]);
  });
}

}  // namespace penumbra::shaders
