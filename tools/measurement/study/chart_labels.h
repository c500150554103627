// Where the labels of a scatter chart go: near their points, off each other and inside the frame.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace penumbra::study {

struct Box {
  double left = 0.0;
  double top = 0.0;  // y grows downwards, as in SVG
  double right = 0.0;
  double bottom = 0.0;

  bool operator==(const Box&) const = default;
};

struct LabelRequest {
  double x = 0.0;  // the point, in pixels
  double y = 0.0;
  std::string text;
};

struct PlacedLabel {
  Box box;                  // of the text
  bool needs_line = false;  // too far from its point, or too near to another one, to be read as its own

  bool operator==(const PlacedLabel&) const = default;
};

double overlap_area(const Box& a, const Box& b);

// Each label takes, of places on rings around its point, the one that covers least of other labels, of the
// obstacles (points, lines) and of what lies outside the frame, that stands nearest to its own point rather
// than to another label's, and whose line crosses no other label, point or line; in several orders, a few
// times each now that the others stand. The order that costs least is taken. Near places win ties. Beyond the
// first `always` labels, those that find no room are left out. The same input gives the same places.
std::vector<std::optional<PlacedLabel>> place_labels(
    const std::vector<LabelRequest>& requests, const std::vector<Box>& obstacles, const Box& frame,
    double font_pixels, std::size_t always = std::numeric_limits<std::size_t>::max());

}  // namespace penumbra::study
