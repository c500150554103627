#include "shaders/scalar_conditions.h"

#include <unordered_set>

#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

void copy_scalar_conditions(SpirvModule& module) {
  std::unordered_set<std::uint32_t> bool_types;
  std::unordered_set<std::uint32_t> bools;  // results of a type of bool: words 1 and 2 of what has both
  spirv::for_each_instruction(module, [&](spirv::WrittenWords words) {
    const spv::Op op = spirv::opcode(words);
    if (op == spv::OpTypeBool && words.size() == 2) bool_types.insert(words[1]);
    if (words.size() < 3 || bool_types.count(words[1]) == 0) return;
    const bool condition = (op == spv::OpAny || op == spv::OpAll) && words.size() == 4;
    if (condition && bools.count(words[3]) != 0) words[0] = (words[0] & ~0xFFFFU) | spv::OpCopyObject;
    bools.insert(words[2]);
  });
}

}  // namespace penumbra::shaders
