// Where the labels of a scatter chart go: near their points, off each other and inside the frame.
#pragma once

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
};

struct PlacedLabel {
  Box box;                  // of the text
  bool needs_line = false;  // too far from its point to be read as its own
};

double overlap_area(const Box& a, const Box& b);

// Greedy, in the order given: each label takes, of places on rings around its point, the one that covers
// least of labels placed before it, of the obstacles (points, lines), and of what lies outside the frame;
// near places win ties. The same input gives the same places.
std::vector<PlacedLabel> place_labels(const std::vector<LabelRequest>& requests,
                                      const std::vector<Box>& obstacles, const Box& frame,
                                      double font_pixels);

}  // namespace penumbra::study
