// Buffers, images and samplers on a device. Copies to and from the host block until they are done.
//
// Uploading moves bits, not numbers: NaN, infinities and depths outside [0, 1] arrive as they are in depth32
// and the float formats.
#pragma once

#include <type_traits>

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

  // The content is copied from byte 0 on; throws std::invalid_argument when it does not fit.
  template <typename T>
  void upload(std::span<const T> content) {
    static_assert(std::is_trivially_copyable_v<T>);
    upload_bytes(std::as_bytes(content));
  }
  template <typename T>
  void upload(const std::vector<T>& content) {
    upload(std::span<const T>(content));
  }
  // Returns the whole buffer, which must be a whole number of T.
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

struct ImageShape {
  Format format = Format::r32f;
  int width = 1;
  int height = 1;
  int depth = 1;   // above 1, a 3D image, which has one layer
  int layers = 1;  // above 1, an array of 2D images
  int mips = 1;
  int samples = 1;  // above 1, a 2D image with one mip level, which passes draw into

  bool operator==(const ImageShape&) const = default;
};

// Returns the number of levels down to one texel.
int mip_count(int width, int height, int depth = 1);
int mip_size(int size, int mip);

struct ImagePart {
  int mip = 0;
  int layer = 0;
};

class Image {
 public:
  // Contents are undefined. Throws EnvironmentError when the device lacks the format, the size or the
  // samples, and std::invalid_argument for a shape that no image has.
  Image(const Device& device, const ImageShape& shape);
  Image(const Device& device, Format format, int width, int height)
      : Image(device, ImageShape{.format = format, .width = width, .height = height}) {}

  const ImageShape& shape() const;
  Format format() const { return shape().format; }
  int width() const { return shape().width; }
  int height() const { return shape().height; }
  // Returns the bytes of one mip level of one layer, and of all of a 3D image's slices in it: rows are
  // tightly packed, row 0 first.
  std::size_t size_bytes(int mip = 0) const;

  // The texels must be exactly size_bytes() of the mip level; throws std::invalid_argument otherwise. Throws
  // std::logic_error for an image with several samples: resolve it first.
  template <typename T>
  void upload(std::span<const T> texels, ImagePart part = {}) {
    static_assert(std::is_trivially_copyable_v<T>);
    upload_bytes(std::as_bytes(texels), part);
  }
  template <typename T>
  void upload(const std::vector<T>& texels, ImagePart part = {}) {
    upload(std::span<const T>(texels), part);
  }
  template <typename T>
  std::vector<T> download(ImagePart part = {}) const {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> texels(size_bytes(part.mip) / sizeof(T));
    download_bytes(std::as_writable_bytes(std::span<T>(texels)), part);
    return texels;
  }

  void upload_bytes(std::span<const std::byte> bytes, ImagePart part = {});
  void download_bytes(std::span<std::byte> bytes, ImagePart part = {}) const;

  const std::shared_ptr<ImageState>& state() const { return state_; }

 private:
  std::shared_ptr<ImageState> state_;
};

// Kinds that do not repeat clamp to the edge. Point and linear kinds take the nearest mip level, trilinear
// ones blend two. The compare kinds filter 2x2 comparison results, as Unity's sampler_LinearClampCompare
// does: reference <= texel, or reference >= texel with reversed Z.
enum class SamplerKind {
  point_clamp,
  linear_clamp,
  trilinear_clamp,
  point_repeat,
  linear_repeat,
  trilinear_repeat,
  compare_less_equal,
  compare_greater_equal
};

enum class SamplerWrap { repeat, mirror, clamp };  // the rule for coordinates outside 0..1

class Sampler {
 public:
  Sampler(const Device& device, SamplerKind kind);
  Sampler(const Device& device, SamplerWrap u, SamplerWrap v);  // a linear filter
  const std::shared_ptr<SamplerState>& state() const { return state_; }

 private:
  std::shared_ptr<SamplerState> state_;
};

}  // namespace penumbra::gpu
