#include "shaders/image_instructions.h"

#include <glslang/SPIRV/spirv.hpp>
#include <map>
#include <spirv-tools/libspirv.hpp>
#include <stdexcept>

namespace penumbra::shaders {
namespace {

struct Walk {
  std::map<std::uint32_t, std::string> names;
  std::map<std::uint32_t, std::string> strings;
  std::string function;
  std::string file;
  int line = 0;
  std::string prefix;
  std::vector<ImageInstruction> found;
};

bool reads_an_image(std::uint16_t opcode) {
  const auto op = static_cast<spv::Op>(opcode);
  const bool samples = op >= spv::OpImageSampleImplicitLod && op <= spv::OpImageRead;
  const bool sparse = op >= spv::OpImageSparseSampleImplicitLod && op <= spv::OpImageSparseDrefGather;
  return samples || sparse || op == spv::OpImageSparseRead;
}

// "PenumbraCountedLoad(t21;vi2;" -> "PenumbraCountedLoad"
std::string without_parameters(const std::string& name) {
  return name.substr(0, name.find('('));
}

spv_result_t visit(void* user_data, const spv_parsed_instruction_t* instruction) {
  Walk& walk = *static_cast<Walk*>(user_data);
  switch (static_cast<spv::Op>(instruction->opcode)) {
    case spv::OpName:
      walk.names[instruction->words[1]] = reinterpret_cast<const char*>(instruction->words + 2);
      break;
    case spv::OpString:
      walk.strings[instruction->result_id] = reinterpret_cast<const char*>(instruction->words + 2);
      break;
    case spv::OpLine:
      walk.file = walk.strings[instruction->words[1]];
      walk.line = static_cast<int>(instruction->words[2]);
      break;
    case spv::OpFunction:
      walk.function = without_parameters(walk.names[instruction->result_id]);
      break;
    default:
      if (reads_an_image(instruction->opcode) && walk.function.rfind(walk.prefix, 0) != 0) {
        walk.found.push_back(
            {walk.function, "Op" + std::string(spvOpcodeString(instruction->opcode)), walk.file, walk.line});
      }
  }
  return SPV_SUCCESS;
}

}  // namespace

std::vector<ImageInstruction> image_instructions_outside(const std::vector<std::uint32_t>& spirv,
                                                         const std::string& prefix) {
  Walk walk;
  walk.prefix = prefix;
  const spvtools::Context context(SPV_ENV_VULKAN_1_1);
  spv_diagnostic diagnostic = nullptr;
  const spv_result_t result =
      spvBinaryParse(context.CContext(), &walk, spirv.data(), spirv.size(), nullptr, visit, &diagnostic);
  const std::string reason = diagnostic == nullptr ? "no SPIR-V" : diagnostic->error;
  spvDiagnosticDestroy(diagnostic);
  if (result != SPV_SUCCESS) throw std::invalid_argument(reason);
  return walk.found;
}

}  // namespace penumbra::shaders
