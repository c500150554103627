#include "shaders/function_results.h"

#include <map>
#include <set>

#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

bool returns_several_numbers(const SpirvModule& module, const std::string& function) {
  std::set<std::uint32_t> named;
  std::set<std::uint32_t> of_several;  // types
  bool found = false;
  spirv::for_each_instruction(module, [&](spirv::Words instruction) {
    const spv::Op op = spirv::opcode(instruction);
    if (op == spv::OpName && instruction.size() > 2) {
      const std::string name =
          spirv::literal_text(instruction.subspan(2));  // "ShadowVisibility(vf3;vf3;vf2;"
      if (name.substr(0, name.find('(')) == function) named.insert(instruction[1]);
    } else if (op == spv::OpTypeVector || op == spv::OpTypeMatrix || op == spv::OpTypeArray ||
               op == spv::OpTypeStruct) {
      of_several.insert(instruction[1]);
    } else if (op == spv::OpFunction && instruction.size() > 2) {
      found = found || (named.count(instruction[2]) != 0 && of_several.count(instruction[1]) != 0);
    }
  });
  return found;
}

}  // namespace penumbra::shaders
