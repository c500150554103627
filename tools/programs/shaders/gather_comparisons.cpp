#include "shaders/gather_comparisons.h"

#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

// No gather of HLSL has a bias that could need it.
bool asks_for_gather_bias(spirv::Words one) {
  if (spirv::opcode(one) == spv::OpCapability)
    return one.size() > 1 && one[1] == spv::CapabilityImageGatherBiasLodAMD;
  return spirv::opcode(one) == spv::OpExtension &&
         spirv::literal_text(one.subspan(1)) == "SPV_AMD_texture_gather_bias_lod";
}

}  // namespace

void drop_gather_bias(SpirvModule& module) {
  constexpr std::size_t mask = 6;  // its place: after result type, result, image, coordinate and reference
  SpirvModule kept(module.begin(), module.begin() + spirv::header_words);
  kept.reserve(module.size());
  spirv::for_each_instruction(module, [&](spirv::Words one) {
    if (asks_for_gather_bias(one)) return;
    const std::size_t begin = kept.size();
    kept.insert(kept.end(), one.begin(), one.end());
    const bool biased = spirv::opcode(one) == spv::OpImageDrefGather && one.size() > mask + 1 &&
                        (one[mask] & spv::ImageOperandsBiasMask) != 0;
    if (!biased) return;
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(begin + mask + 1));  // the bias comes first
    kept[begin + mask] &= ~static_cast<std::uint32_t>(spv::ImageOperandsBiasMask);
    if (kept[begin + mask] == 0) kept.pop_back();
    kept[begin] = static_cast<std::uint32_t>((kept.size() - begin) << 16U) | spv::OpImageDrefGather;
  });
  module = std::move(kept);
}

}  // namespace penumbra::shaders
