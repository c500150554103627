// The resources that a pass's shaders read and write, by the names that the shaders give them.
//
// A pass has one set of bindings, and makes more for uses that stand side by side in one Sequence. Bound
// resources are kept alive, and can be replaced between runs without rebuilding anything.
#pragma once

#include <string>

#include "gpu/resources.h"

namespace penumbra::gpu {

// The mip levels and layers that a shader sees; for a storage image only the first level. A count of 0 means
// all from the first on.
struct ImageRange {
  int first_mip = 0;
  int mips = 0;
  int first_layer = 0;
  int layers = 0;
};

struct BindingsState;
struct PassInterface;

class Bindings {
 public:
  bool has(const std::string& name) const;

  // Each throws std::logic_error when the pass has no resource of that name and kind, or the device is
  // another one. If several stages have the name, each gets the resource.
  void buffer(const std::string& name, const Buffer& buffer);  // StructuredBuffer, RWStructuredBuffer
  void image(const std::string& name, const Image& image,
             ImageRange range = {});  // Texture2D, RWTexture2D, ...
  void sampler(const std::string& name, const Sampler& sampler);
  void uniform_bytes(const std::string& name, std::span<const std::byte> bytes);  // cbuffer; copied
  template <typename T>
  void uniform(const std::string& name, const T& block) {
    static_assert(std::is_trivially_copyable_v<T>);
    uniform_bytes(name, std::as_bytes(std::span<const T>(&block, 1)));
  }

  explicit Bindings(std::shared_ptr<PassInterface> interface);  // for this folder: passes make them
  const std::shared_ptr<BindingsState>& state() const { return state_; }

 private:
  std::shared_ptr<BindingsState> state_;
};

}  // namespace penumbra::gpu
