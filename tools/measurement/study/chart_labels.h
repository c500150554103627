// Places the labels of a scatter chart: near their points, inside the frame, and over nothing else.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace penumbra::study {

struct Box {
  double left = 0.0;
  double top = 0.0;  // y grows downwards, as in SVG
  double right = 0.0;
  double bottom = 0.0;
};

struct LabelRequest {
  double x = 0.0;  // the point, in pixels
  double y = 0.0;
  std::string text;
  bool is_important = false;
};

struct PlacedLabel {
  Box box;  // box of the text
  // The label needs one if it is too far from its point, or too near to another, to be read as its own.
  bool needs_line = false;
};

double overlap_area(const Box& a, const Box& b);

// Returns where the line from a point to its label ends.
std::pair<double, double> line_end(const LabelRequest& request, const Box& label);

// Labels are placed in the order of their requests, each at the nearest of several places on rings around its
// point. No label covers a mark, a step, another label or its line; no line covers a label or a mark, unless
// that is close to its point. Labels without such a place are omitted; where one of them is important, other
// orders are tried.
std::vector<std::optional<PlacedLabel>> place_labels(const std::vector<LabelRequest>& requests,
                                                     const std::vector<Box>& marks,
                                                     const std::vector<Box>& steps, const Box& frame,
                                                     double font_pixels);

}  // namespace penumbra::study
