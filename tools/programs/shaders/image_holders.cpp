#include "shaders/image_holders.h"

#include <algorithm>

#include "hlsl/name_set.h"

namespace penumbra::shaders {

using spirv::Id;

ImageHolders::ImageHolders(const spirv::Code& code) : code_(code) {
  for (const spirv::Instruction& one : code.instructions()) {
    const bool keeps = hlsl::is_one_of(one.op, {spv::OpVariable, spv::OpFunctionParameter, spv::OpFunction});
    if (keeps && has_image(one.type)) all_.push_back(one.result);
  }
  std::sort(all_.begin(), all_.end());
}

bool ImageHolders::has_image(Id type) const {
  const spirv::Instruction* definition = code_.definition(type);
  if (definition == nullptr) return false;
  switch (definition->op) {
    case spv::OpTypeImage:
    case spv::OpTypeSampledImage:
      return true;
    case spv::OpTypePointer:
      return has_image(code_.pointee(type));
    case spv::OpTypeArray:
      return has_image(definition->operands[0]);
    case spv::OpTypeStruct:
      return std::any_of(definition->operands.begin(), definition->operands.end(),
                         [this](Id member) { return has_image(member); });
    default:
      return false;
  }
}

Id ImageHolders::of(Id value) const {
  if (std::binary_search(all_.begin(), all_.end(), value)) return value;
  const spirv::Instruction* made = code_.definition(value);
  if (made == nullptr || !has_image(made->type)) return 0;
  switch (made->op) {
    case spv::OpLoad:
    case spv::OpAccessChain:
    case spv::OpInBoundsAccessChain:
    case spv::OpCopyObject:
    case spv::OpCompositeExtract:
    case spv::OpSampledImage:
    case spv::OpImage:
    case spv::OpFunctionCall:  // the function is its holder
      return of(made->operands[0]);
    case spv::OpCompositeConstruct:
      for (const Id part : made->operands)
        if (const Id holder = of(part); holder != 0) return holder;
      return 0;
    default:
      return 0;
  }
}

}  // namespace penumbra::shaders
