#include <stdexcept>

#include "shaders/bytecode_module.h"
#include "shaders/bytecode_reflection.h"

namespace penumbra::shaders {

bool translates_bytecode() {
  return false;
}

SpirvModule translated_bytecode(const std::string&, const std::vector<BytecodeResource>&) {
  throw std::invalid_argument("this program was built without vkd3d-shader, which translates bytecode");
}

}  // namespace penumbra::shaders
