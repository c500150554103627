// Places the labels of a scatter chart: near their points, without overlaps and inside the frame.
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
  Box box;  // box of the text
  // The label needs one if it is too far from its point, or too near to another, to be read as its own.
  bool needs_line = false;

  bool operator==(const PlacedLabel&) const = default;
};

double overlap_area(const Box& a, const Box& b);

// Each label takes one of several candidate positions on rings around its point. Its cost counts overlaps
// with other labels, obstacles (points, lines) and the outside of the frame; a place nearer to another
// label's point than to its own; and a leader line that crosses another label, point or line. Several orders
// of placement are tried, each with a few iterations of refinement; the one with the lowest cost is taken.
// Near positions win ties. Beyond the first `always` labels, those without room are omitted. The result is
// deterministic.
std::vector<std::optional<PlacedLabel>> place_labels(
    const std::vector<LabelRequest>& requests, const std::vector<Box>& obstacles, const Box& frame,
    double font_pixels, std::size_t always = std::numeric_limits<std::size_t>::max());

}  // namespace penumbra::study
