// Labelled scatter charts with a Pareto front as SVG: panels one above the other.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace penumbra::study {

struct ChartPoint {
  std::string label;
  double x = 0.0;
  double y = 0.0;
  std::string note{};  // a page's text about it in addition to the label: figures with units, and what they
                       // are means of
  std::string name{};  // identifies it on a page, in every chart and elsewhere
};

struct ChartPanel {
  std::string title;
  std::vector<ChartPoint> points;
  std::vector<std::size_t>
      front;  // indices of points, by rising x: drawn filled and joined by steps; may be empty
};

// The x axis is logarithmic, and the y axis starts at 0.
struct Chart {
  std::string name;  // of its file, without the ending
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<ChartPanel> panels;
};

// Returns a file. It is dark on its own light background, which is legible on light and dark pages. Points
// without a place on the axes are omitted. Labels cover nothing: those of the front come first, then as many
// others as find room; each point names itself when the pointer is over it. Throws std::invalid_argument when
// no panel has a point to draw.
std::string render_svg(const Chart& chart);

// Returns each panel as an SVG element for a page, narrow enough for a telephone, all with the same axes. The
// page sets the panels' titles and colours its classes: chart.css. Points are links to #figures, with their
// texts in data-technique, data-label and data-note. Throws as render_svg() does.
std::vector<std::string> render_panels(const Chart& chart);

// Places the labels of a scatter chart: near their points, inside the frame, and over nothing else.
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
