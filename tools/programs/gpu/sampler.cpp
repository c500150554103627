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

vk::SamplerAddressMode address_mode(SamplerWrap wrap) {
  if (wrap == SamplerWrap::repeat) return vk::SamplerAddressMode::eRepeat;
  return wrap == SamplerWrap::mirror ? vk::SamplerAddressMode::eMirroredRepeat
                                     : vk::SamplerAddressMode::eClampToEdge;
}

std::shared_ptr<SamplerState> make_sampler(const Device& device, const vk::SamplerCreateInfo& info) {
  auto state = std::make_shared<SamplerState>();
  state->device = device.state();
  guarded(*state->device, "make a sampler",
          [&] { state->sampler = vk::raii::Sampler(state->device->device, info); });
  return state;
}

}  // namespace

Sampler::Sampler(const Device& device, SamplerKind kind) : state_(make_sampler(device, describe(kind))) {}

Sampler::Sampler(const Device& device, SamplerWrap u, SamplerWrap v) {
  vk::SamplerCreateInfo info = describe(SamplerKind::linear_repeat);
  info.addressModeU = address_mode(u);
  info.addressModeV = address_mode(v);
  state_ = make_sampler(device, info);
}

}  // namespace penumbra::gpu
