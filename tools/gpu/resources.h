// Buffers, images and samplers on a device. Copies to and from the host block until they are done.
//
// Images hold one mip level and one layer, rows tightly packed, row 0 first. Uploading moves bits, not
// numbers: NaN, infinities and depths outside [0, 1] arrive as they are in depth32 and the float formats.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "gpu/device.h"
#include "gpu/format.h"

namespace penumbra::gpu {

struct BufferState;
struct ImageState;
struct SamplerState;

class Buffer {
 public:
  Buffer(const Device& device, std::size_t bytes);  // contents undefined; throws std::invalid_argument for 0
  template <typename T>
  Buffer(const Device& device, std::span<const T> content) : Buffer(device, content.size_bytes()) {
    upload(content);
  }

  std::size_t size_bytes() const;

  // From byte 0; throws std::invalid_argument when it does not fit.
  template <typename T>
  void upload(std::span<const T> content) {
    static_assert(std::is_trivially_copyable_v<T>);
    upload_bytes(std::as_bytes(content));
  }
  template <typename T>
  void upload(const std::vector<T>& content) {
    upload(std::span<const T>(content));
  }
  // The whole buffer, which must be a whole number of T.
  template <typename T>
  std::vector<T> download() const {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> content(size_bytes() / sizeof(T));
    download_bytes(std::as_writable_bytes(std::span<T>(content)));
    return content;
  }

  void upload_bytes(std::span<const std::byte> bytes);
  void download_bytes(std::span<std::byte> bytes) const;

  const std::shared_ptr<BufferState>& state() const { return state_; }

 private:
  std::shared_ptr<BufferState> state_;
};

class Image {
 public:
  // Throws EnvironmentError when the device lacks the format or the size. Contents undefined.
  Image(const Device& device, Format format, int width, int height);

  Format format() const;
  int width() const;
  int height() const;
  std::size_t size_bytes() const {
    return texel_bytes(format()) * std::size_t(width()) * std::size_t(height());
  }

  // Exactly size_bytes(); throws std::invalid_argument otherwise.
  template <typename T>
  void upload(std::span<const T> texels) {
    static_assert(std::is_trivially_copyable_v<T>);
    upload_bytes(std::as_bytes(texels));
  }
  template <typename T>
  void upload(const std::vector<T>& texels) {
    upload(std::span<const T>(texels));
  }
  template <typename T>
  std::vector<T> download() const {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> texels(size_bytes() / sizeof(T));
    download_bytes(std::as_writable_bytes(std::span<T>(texels)));
    return texels;
  }

  void upload_bytes(std::span<const std::byte> bytes);
  void download_bytes(std::span<std::byte> bytes) const;

  const std::shared_ptr<ImageState>& state() const { return state_; }

 private:
  std::shared_ptr<ImageState> state_;
};

// All read mip level 0; those that do not repeat clamp to the edge. The compare kinds filter 2x2 comparison
// results, as Unity's sampler_LinearClampCompare does: reference <= texel, or reference >= texel with
// reversed Z.
enum class SamplerKind {
  point_clamp,
  linear_clamp,
  point_repeat,
  linear_repeat,
  compare_less_equal,
  compare_greater_equal
};

class Sampler {
 public:
  Sampler(const Device& device, SamplerKind kind);
  const std::shared_ptr<SamplerState>& state() const { return state_; }

 private:
  std::shared_ptr<SamplerState> state_;
};

}  // namespace penumbra::gpu
