// Labelled scatter charts with a front, drawn by gnuplot as SVG: panels one above the other.
#pragma once

#include <string>
#include <vector>

namespace penumbra::study {

struct ChartPoint {
  std::string label;
  double x = 0.0;
  double y = 0.0;
};

struct ChartPanel {
  std::string title;
  std::vector<ChartPoint> points;
  std::vector<std::size_t>
      front;  // indices of points, by rising x: drawn filled and joined by steps; may be empty
};

struct Chart {
  std::string name;  // prefix of the SVG's ids, so that several fit one page: letters, digits, '-'
  std::string title;
  std::string x_label;
  std::string y_label;
  bool x_logarithmic = true;  // points with x <= 0 are then left out
  std::vector<ChartPanel> panels;
};

// Same chart, same bytes (with one gnuplot). Dark ink on its own light ground: reads on light and dark pages.
// Points that are not finite are left out. Throws EnvironmentError when gnuplot is missing, fails or takes
// over 20 s, and std::invalid_argument when no panel has a point to draw.
std::string render_svg(const Chart& chart);

// The SVG element alone, without the XML prolog a file needs and a page must not have.
std::string inline_svg(const std::string& svg);

}  // namespace penumbra::study
