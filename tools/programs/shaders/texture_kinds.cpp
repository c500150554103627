#include "shaders/texture_kinds.h"

#include <map>
#include <set>

#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {
namespace {

// The words are OpTypeImage result type dimension depth arrayed multisampled sampled...
bool is_other_than_2d(spirv::Words image) {
  constexpr std::uint32_t sampled = 1;  // a sampled image, not a storage image
  return image.size() > 7 && image[7] == sampled &&
         (static_cast<spv::Dim>(image[3]) != spv::Dim2D || image[5] != 0 || image[6] != 0);
}

}  // namespace

std::vector<std::string> textures_that_are_not_2d(const SpirvModule& module) {
  std::map<std::uint32_t, std::string> names;
  std::set<std::uint32_t> types;  // types of such images, and of pointers to them
  std::vector<std::string> textures;
  spirv::for_each_instruction(module, [&](spirv::Words instruction) {
    const spv::Op op = spirv::opcode(instruction);
    if (op == spv::OpName && instruction.size() > 2) {
      names[instruction[1]] = spirv::literal_text(instruction.subspan(2));
    } else if (op == spv::OpTypeImage && is_other_than_2d(instruction)) {
      types.insert(instruction[1]);
    } else if (op == spv::OpTypePointer && instruction.size() > 3 && types.count(instruction[3]) != 0) {
      types.insert(instruction[1]);
    } else if (op == spv::OpVariable && instruction.size() > 2 && types.count(instruction[1]) != 0) {
      textures.push_back(names[instruction[2]]);
    }
  });
  return textures;
}

}  // namespace penumbra::shaders
