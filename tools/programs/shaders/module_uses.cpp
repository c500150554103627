#include "shaders/module_uses.h"

#include <set>

#include <spirv-tools/libspirv.hpp>

#include "hlsl/name_set.h"
#include "shaders/debug_lines.h"
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

bool samples(spv::Op op) {
  return (op >= spv::OpImageSampleImplicitLod && op <= spv::OpImageSampleProjDrefExplicitLod) ||
         op == spv::OpImageGather || op == spv::OpImageDrefGather ||
         (op >= spv::OpImageSparseSampleImplicitLod && op <= spv::OpImageSparseSampleProjDrefExplicitLod) ||
         op == spv::OpImageSparseGather || op == spv::OpImageSparseDrefGather;
}

bool compares(spv::Op op) {
  return hlsl::is_one_of(
      op, {spv::OpImageSampleDrefImplicitLod, spv::OpImageSampleDrefExplicitLod,
           spv::OpImageSampleProjDrefImplicitLod, spv::OpImageSampleProjDrefExplicitLod,
           spv::OpImageDrefGather, spv::OpImageSparseSampleDrefImplicitLod,
           spv::OpImageSparseSampleDrefExplicitLod, spv::OpImageSparseSampleProjDrefImplicitLod,
           spv::OpImageSparseSampleProjDrefExplicitLod, spv::OpImageSparseDrefGather});
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

std::optional<SourcePlace> first_discard(const SpirvModule& module) {
  DebugLines lines;
  std::optional<SourcePlace> found;
  spirv::for_each_instruction(module, [&](spirv::Words instruction) {
    const SourcePlace& place = lines.visit(instruction);
    const spv::Op op = spirv::opcode(instruction);
    const bool discards =
        hlsl::is_one_of(op, {spv::OpKill, spv::OpTerminateInvocation, spv::OpDemoteToHelperInvocationEXT});
    if (discards && !found) found = place;
  });
  return found;
}

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
    } else if (hlsl::is_one_of(op,
                               {spv::OpTypeVector, spv::OpTypeMatrix, spv::OpTypeArray, spv::OpTypeStruct})) {
      of_several.insert(instruction[1]);
    } else if (op == spv::OpFunction && instruction.size() > 2) {
      found = found || (named.count(instruction[2]) != 0 && of_several.count(instruction[1]) != 0);
    }
  });
  return found;
}

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

std::vector<SamplerUse> sampler_uses(const SpirvModule& module) {
  return Search().run(module);
}

}  // namespace penumbra::shaders
