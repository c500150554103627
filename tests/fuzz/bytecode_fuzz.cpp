// Counts and reflects Direct3D bytecode, which FXC gives.
#include <stdexcept>
#include <string>

#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "fxc/bytecode.h"
#include "shaders/bytecode_reflection.h"

namespace penumbra::fuzz {

void targets::bytecode(std::string_view bytes) {
  fxc::bytecode_cost(bytes);
  for (const auto reads : {+[](std::string_view container) { shaders::bytecode_resources(container); },
                           +[](std::string_view container) { shaders::bytecode_signature(container); }}) {
    try {
      reads(bytes);
    } catch (const std::invalid_argument&) {  // the declared answer to damaged bytes
    }
  }
}

}  // namespace penumbra::fuzz
