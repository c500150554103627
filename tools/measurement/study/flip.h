// FLIP: how much two pictures differ for an eye that flips between them.
//
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild, "FLIP: A Difference Evaluator for
// Alternating Images" (2020), for pictures of low dynamic range: colours as a blurring eye sees them, by the
// distance HyAB, raised where edges or points differ.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace penumbra::study {

// A picture of width x height sRGB-encoded colours in [0, 1], row 0 at the top.
struct FlipPicture {
  int width = 0;
  int height = 0;
  std::span<const glm::vec3> colours;
};

// The pixels per degree of a screen .7 m wide with 3840 pixels, seen from .7 m, as in the paper.
inline constexpr double kFlipPixelsPerDegree = 67.02064327658226;

// What FLIP knows of the reference alone, so that several pictures are compared with it at less cost.
class FlipReference {
 public:
  // Throws std::invalid_argument for a picture with fewer colours than pixels, or without any.
  explicit FlipReference(const FlipPicture& reference, double pixels_per_degree = kFlipPixelsPerDegree);

  // Returns the difference of each pixel, 0 to 1. Throws std::invalid_argument for another size.
  std::vector<float> differences(const FlipPicture& test) const;
  double mean_difference(const FlipPicture& test) const;

  // A picture as the eye sees it: filtered colours in L*a*b*, and the strengths of edges and of points.
  struct Seen {
    std::vector<glm::vec3> lab;
    std::vector<float> edges;
    std::vector<float> points;
  };

 private:
  int width_ = 0;
  int height_ = 0;
  double pixels_per_degree_ = 0.0;
  Seen seen_;
};

}  // namespace penumbra::study
