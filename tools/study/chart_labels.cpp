#include "study/chart_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace penumbra::study {
namespace {

double area(const Box& box) {
  return std::max(box.right - box.left, 0.0) * std::max(box.bottom - box.top, 0.0);
}

// The text's box when its nearest edge or corner is `distance` away from the point, in direction `angle`.
Box box_at(const LabelRequest& request, double angle, double distance, double font_pixels) {
  constexpr double kMeanLetterWidth = 0.58;  // of a sans-serif letter, in font sizes, on the wide side
  const double width = kMeanLetterWidth * font_pixels * static_cast<double>(request.text.size());
  const double height = 1.15 * font_pixels;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double x = request.x + c * distance + c * width / 2.0;
  const double y = request.y + s * distance + s * height / 2.0;
  return {x - width / 2.0, y - height / 2.0, x + width / 2.0, y + height / 2.0};
}

double cost(const Box& box, const std::vector<PlacedLabel>& placed, const std::vector<Box>& obstacles,
            const Box& frame) {
  double covered = 4.0 * (area(box) - overlap_area(box, frame));
  for (const PlacedLabel& other : placed) covered += overlap_area(box, other.box);
  for (const Box& obstacle : obstacles) covered += 2.0 * overlap_area(box, obstacle);
  return covered;
}

}  // namespace

double overlap_area(const Box& a, const Box& b) {
  return area({std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
               std::min(a.bottom, b.bottom)});
}

std::vector<PlacedLabel> place_labels(const std::vector<LabelRequest>& requests,
                                      const std::vector<Box>& obstacles, const Box& frame,
                                      double font_pixels) {
  constexpr std::array kDistances = {9.0, 16.0, 28.0, 44.0, 64.0, 90.0};
  constexpr int kDirections = 16;
  std::vector<PlacedLabel> placed;
  for (const LabelRequest& request : requests) {
    PlacedLabel best;
    double least = std::numeric_limits<double>::infinity();
    for (const double distance : kDistances) {
      for (int i = 0; i < kDirections; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kDirections;
        const Box box = box_at(request, angle, distance, font_pixels);
        const double here = cost(box, placed, obstacles, frame);
        if (here < least - 1e-9) {
          least = here;
          best = {box, distance > 20.0};
        }
      }
    }
    placed.push_back(best);
  }
  return placed;
}

}  // namespace penumbra::study
