#include "shaders/sampler_uses.h"

#include <map>
#include <spirv-tools/libspirv.hpp>

#include "shaders/debug_lines.h"
#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {
namespace {

bool samples(spv::Op op) {
  return (op >= spv::OpImageSampleImplicitLod && op <= spv::OpImageSampleProjDrefExplicitLod) ||
         op == spv::OpImageGather || op == spv::OpImageDrefGather ||
         (op >= spv::OpImageSparseSampleImplicitLod && op <= spv::OpImageSparseSampleProjDrefExplicitLod) ||
         op == spv::OpImageSparseGather || op == spv::OpImageSparseDrefGather;
}

bool compares(spv::Op op) {
  switch (op) {
    case spv::OpImageSampleDrefImplicitLod:
    case spv::OpImageSampleDrefExplicitLod:
    case spv::OpImageSampleProjDrefImplicitLod:
    case spv::OpImageSampleProjDrefExplicitLod:
    case spv::OpImageDrefGather:
    case spv::OpImageSparseSampleDrefImplicitLod:
    case spv::OpImageSparseSampleDrefExplicitLod:
    case spv::OpImageSparseSampleProjDrefImplicitLod:
    case spv::OpImageSparseSampleProjDrefExplicitLod:
    case spv::OpImageSparseDrefGather:
      return true;
    default:
      return false;
  }
}

class Search {
 public:
  std::vector<SamplerUse> run(const SpirvModule& module) {
    spirv::for_each_instruction(module, [this](spirv::Words instruction) { visit(instruction); });
    return std::move(uses_);
  }

 private:
  void visit(spirv::Words instruction) {
    const spv::Op op = spirv::opcode(instruction);
    const SourcePlace& place = lines_.visit(instruction);
    if (op == spv::OpName && instruction.size() > 2) {
      names_[instruction[1]] = spirv::literal_text(instruction.subspan(2));
    } else if (op == spv::OpSampledImage && instruction.size() > 4) {
      made_from_[instruction[2]] = instruction[4];  // the sampler of the pair
    } else if ((op == spv::OpLoad || op == spv::OpAccessChain) && instruction.size() > 3) {
      made_from_[instruction[2]] = instruction[3];
    } else if (samples(op) && instruction.size() > 3) {
      uses_.push_back(
          {name_of(instruction[3]), compares(op), "Op" + std::string(spvOpcodeString(op)), place});
    }
  }

  std::string name_of(std::uint32_t value) const {
    auto found = made_from_.find(value);
    for (; found != made_from_.end(); found = made_from_.find(value)) value = found->second;
    const auto name = names_.find(value);
    return name == names_.end() ? "" : name->second;
  }

  DebugLines lines_;
  std::map<std::uint32_t, std::string> names_;
  std::map<std::uint32_t, std::uint32_t> made_from_;
  std::vector<SamplerUse> uses_;
};

}  // namespace

std::vector<SamplerUse> sampler_uses(const SpirvModule& module) {
  return Search().run(module);
}

}  // namespace penumbra::shaders
