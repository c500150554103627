#include "shaders/module_problems.h"

#include "shaders/debug_lines.h"
#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

// Returns the operands of a reading instruction that may be textures and samplers.
spirv::Words handles(spirv::Words instruction) {
  const spv::Op op = spirv::opcode(instruction);
  const bool reads = (op >= spv::OpImageSampleImplicitLod && op <= spv::OpImageQuerySamples) ||
                     (op >= spv::OpImageSparseSampleImplicitLod && op <= spv::OpImageSparseRead);
  if (op == spv::OpSampledImage && instruction.size() > 4) return instruction.subspan(3, 2);
  if (op == spv::OpImageWrite && instruction.size() > 1) return instruction.subspan(1, 1);
  return reads && instruction.size() > 3 ? instruction.subspan(3, 1) : spirv::Words{};
}

class LostSearch final : public ModuleSearch {
 public:
  using ModuleSearch::ModuleSearch;

 private:
  void visit(spirv::Words instruction) override {
    switch (spirv::opcode(instruction)) {
      case spv::OpTypeImage:
      case spv::OpTypeSampledImage:
        if (instruction.size() > 1) kinds_[instruction[1]] = "texture";
        break;
      case spv::OpTypeSampler:
        if (instruction.size() > 1) kinds_[instruction[1]] = "sampler";
        break;
      case spv::OpUndef:
      case spv::OpConstantNull:
        if (of_resource(instruction)) undefined_[instruction[2]] = kinds_[instruction[1]];
        break;
      case spv::OpPhi:
      case spv::OpSelect:
        if (of_resource(instruction))
          report("a " + kinds_[instruction[1]] +
                 " is selected at run time, which HLSL does not allow; read both and select between the "
                 "results");
        break;
      default:
        for (const std::uint32_t id : handles(instruction)) read(id);
    }
  }

  bool of_resource(spirv::Words instruction) const {
    return instruction.size() > 2 && kinds_.count(instruction[1]) != 0;
  }

  void read(std::uint32_t id) {
    const auto found = undefined_.find(id);
    if (found == undefined_.end()) return;
    report("a " + found->second +
           " is read uninitialised; if every path does initialise it, one function reads it both "
           "with a comparison sampler and with another sampler, which glslang miscompiles: use a "
           "separate function for each");
  }

  std::map<std::uint32_t, std::string> kinds_;      // kinds of types
  std::map<std::uint32_t, std::string> undefined_;  // undefined values
};

}  // namespace

std::vector<hlsl::Diagnostic> lost_resources(const SpirvModule& module) {
  return LostSearch(module).run();
}

}  // namespace penumbra::shaders
