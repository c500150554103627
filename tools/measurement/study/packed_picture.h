// A picture held as PNG: a study has thousands of them, and in this form each is a tenth of its size.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "study/picture.h"

namespace penumbra::study {

class PackedPicture {
 public:
  PackedPicture() = default;
  // Packs the picture; one without samples is empty. Throws as encode_png() does.
  PackedPicture(const Picture& picture);  // NOLINT(google-explicit-constructor)
  // Throws InputError for bytes that are no PNG.
  explicit PackedPicture(std::span<const std::byte> png);

  bool empty() const { return png_.empty(); }
  std::span<const std::byte> png() const { return png_; }
  Picture unpacked() const;
  operator Picture() const { return unpacked(); }  // NOLINT(google-explicit-constructor)

  friend bool operator==(const PackedPicture&, const PackedPicture&) = default;

 private:
  std::vector<std::byte> png_;
};

}  // namespace penumbra::study
