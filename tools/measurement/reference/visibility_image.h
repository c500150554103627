// The answer of a reference: the share of the light's disc that each receiver sees, and the error of that
// share.
//
// visibility is in [0, 1]; 1 means that the whole disc is seen. Where valid is 0 there is no receiver
// (nothing was seen, the normal is unusable, or part of the disc lies below the surface's own horizon);
// visibility is 1 there and no metric should count it. Rows are those of scene::Receivers: row 0 is at the
// top of the picture.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace penumbra::reference {

struct VisibilityImage {
  int width = 0;
  int height = 0;
  std::vector<float> visibility;
  std::vector<std::uint8_t> valid;
  double noise_floor = 0.0;  // RMSE of the visibility, estimated over penumbra pixels; see from_half_counts
  int samples = 0;           // points of the disc tested per pixel

  bool operator==(const VisibilityImage&) const = default;
};

// The number of points of the light's disc that a pixel sees, in two halves that were drawn independently.
struct HalfCounts {
  std::uint16_t first = 0;
  std::uint16_t second = 0;

  bool operator==(const HalfCounts&) const = default;
};

// Returns the image of both halves together. With A and B the visibility by either half, (A + B) / 2 has a
// quarter of the variance of A - B, so the noise floor is the RMS of (A - B) / 2 over the penumbra pixels
// (0.02 < visibility < 0.98). It is 0 where there are none.
struct ImageSize {
  int width = 0;
  int height = 0;
};
VisibilityImage from_half_counts(ImageSize size, std::span<const HalfCounts> counts,
                                 std::vector<std::uint8_t> valid, int samples);

}  // namespace penumbra::reference
