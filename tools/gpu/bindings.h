// What a pass's shaders read and write, by descriptor set and binding.
//
// A pass keeps what is bound to it alive. A slot's kind is fixed by its first use; the resource in it can be
// replaced between runs without rebuilding anything.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>

#include "gpu/resources.h"

namespace penumbra::gpu {

// A place in a shader's interface. shaders::compile numbers what a shader uses; shaders::reflect tells by
// name.
struct Slot {
  std::uint32_t set = 0;
  std::uint32_t binding = 0;
};

struct BindingsState;

class Bindings {
 public:
  explicit Bindings(const Device& device);

  void storage_buffer(Slot slot, const Buffer& buffer);             // StructuredBuffer, RWStructuredBuffer
  void sampled_image(Slot slot, const Image& image);                // Texture2D
  void storage_image(Slot slot, const Image& image);                // RWTexture2D; not for depth formats
  void sampler(Slot slot, const Sampler& sampler);                  // SamplerState, SamplerComparisonState
  void uniform_bytes(Slot slot, std::span<const std::byte> bytes);  // cbuffer; the bytes are copied
  template <typename T>
  void uniform(Slot slot, const T& block) {
    static_assert(std::is_trivially_copyable_v<T>);
    uniform_bytes(slot, std::as_bytes(std::span<const T>(&block, 1)));
  }

  const std::shared_ptr<BindingsState>& state() const { return state_; }

 private:
  std::shared_ptr<BindingsState> state_;
};

}  // namespace penumbra::gpu
