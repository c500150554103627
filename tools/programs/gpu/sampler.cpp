#include "gpu/resource_state.h"

namespace penumbra::gpu {
namespace {

vk::SamplerCreateInfo describe(SamplerKind kind) {
  using Kind = SamplerKind;
  const bool repeat =
      kind == Kind::point_repeat || kind == Kind::linear_repeat || kind == Kind::trilinear_repeat;
  const bool point = kind == Kind::point_clamp || kind == Kind::point_repeat;
  const bool trilinear = kind == Kind::trilinear_clamp || kind == Kind::trilinear_repeat;
  vk::SamplerCreateInfo info;
  info.addressModeU = info.addressModeV = info.addressModeW =
      repeat ? vk::SamplerAddressMode::eRepeat : vk::SamplerAddressMode::eClampToEdge;
  info.mipmapMode = trilinear ? vk::SamplerMipmapMode::eLinear : vk::SamplerMipmapMode::eNearest;
  info.magFilter = info.minFilter = point ? vk::Filter::eNearest : vk::Filter::eLinear;
  info.maxLod = VK_LOD_CLAMP_NONE;
  info.compareEnable = kind == Kind::compare_less_equal || kind == Kind::compare_greater_equal;
  info.compareOp =
      kind == Kind::compare_greater_equal ? vk::CompareOp::eGreaterOrEqual : vk::CompareOp::eLessOrEqual;
  return info;
}

}  // namespace

Sampler::Sampler(const Device& device, SamplerKind kind) : state_(std::make_shared<SamplerState>()) {
  state_->device = device.state();
  guarded(*state_->device, "make a sampler",
          [this, kind] { state_->sampler = vk::raii::Sampler(state_->device->device, describe(kind)); });
}

}  // namespace penumbra::gpu
