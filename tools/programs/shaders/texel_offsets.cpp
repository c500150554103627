#include "shaders/texel_offsets.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>

#include "shaders/module_search.h"

namespace penumbra::shaders {

namespace {

constexpr std::int32_t lowest_offset = -8;
constexpr std::int32_t highest_offset = 7;

// Returns the index of the image operands of an instruction with an offset in texels; 0 for none.
std::size_t image_operands(spv::Op op) {
  switch (op) {
    case spv::OpImageSampleImplicitLod:
    case spv::OpImageSampleExplicitLod:
    case spv::OpImageSampleProjImplicitLod:
    case spv::OpImageSampleProjExplicitLod:
    case spv::OpImageFetch:
      return 5;
    case spv::OpImageSampleDrefImplicitLod:
    case spv::OpImageSampleDrefExplicitLod:
    case spv::OpImageSampleProjDrefImplicitLod:
    case spv::OpImageSampleProjDrefExplicitLod:
      return 6;
    default:
      return 0;
  }
}

class OffsetSearch final : public ModuleSearch {
 public:
  using ModuleSearch::ModuleSearch;

 private:
  void visit(spirv::Words instruction) override {
    const spv::Op op = spirv::opcode(instruction);
    if (op == spv::OpConstant && instruction.size() == 4) {
      constants_[instruction[2]] = {instruction[3]};
    } else if (op == spv::OpConstantNull && instruction.size() == 3) {
      constants_[instruction[2]] = {0};
    } else if (op == spv::OpConstantComposite && instruction.size() > 3) {
      std::vector<std::uint32_t>& parts = constants_[instruction[2]];
      for (const std::uint32_t id : instruction.subspan(3))
        if (const auto part = constants_.find(id); part != constants_.end())
          parts.insert(parts.end(), part->second.begin(), part->second.end());
    } else if (const std::size_t operands = image_operands(op);
               operands != 0 && instruction.size() > operands) {
      offset(instruction.subspan(operands));
    }
  }

  // `operands` are the mask, then the operands of its bits from the lowest up; a gradient has two.
  void offset(spirv::Words operands) {
    const std::uint32_t mask = operands[0];
    const std::uint32_t wanted = spv::ImageOperandsConstOffsetMask | spv::ImageOperandsOffsetMask;
    if ((mask & wanted) == 0) return;
    const bool constant = (mask & spv::ImageOperandsConstOffsetMask) != 0;
    const std::uint32_t before =
        mask & (spv::ImageOperandsBiasMask | spv::ImageOperandsLodMask | spv::ImageOperandsGradMask);
    std::size_t at = 1U + static_cast<std::size_t>(std::popcount(before));
    if ((mask & spv::ImageOperandsGradMask) != 0) ++at;
    if (at >= operands.size()) return;
    const auto known = constants_.find(operands[at]);
    if (!constant && known == constants_.end())
      return report(
          "the offset of a texture read must be a constant from -8 to 7; if it depends on a loop counter, "
          "write [unroll] before the loop");
    if (known == constants_.end()) return;
    for (const std::uint32_t word : known->second) {
      const auto texels = std::bit_cast<std::int32_t>(word);
      if (texels < lowest_offset || texels > highest_offset)
        return report("the offset of a texture read is " + std::to_string(texels) +
                      " texels, and must be from -8 to 7");
    }
  }

  std::map<std::uint32_t, std::vector<std::uint32_t>> constants_;  // the words of all their components
};

}  // namespace

std::vector<hlsl::Diagnostic> refused_offsets(const SpirvModule& module) {
  return OffsetSearch(module).run();
}

}  // namespace penumbra::shaders
