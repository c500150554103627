// Labelled scatter charts with a Pareto front, drawn by gnuplot as SVG: panels one above the other.
#pragma once

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

struct Chart {
  std::string name;  // prefix of the SVG's ids, so that several fit one page: letters, digits, '-'
  std::string title;
  std::string x_label;
  std::string y_label;
  bool x_logarithmic = true;  // points with x <= 0 are then left out
  std::vector<ChartPanel> panels;
};

// Throws EnvironmentError where gnuplot is not installed.
void require_gnuplot();

// The same chart gives the same bytes (with one gnuplot). It is dark on its own light background, which is
// legible on light and dark pages. Points that are not finite are omitted. Throws EnvironmentError when
// gnuplot is missing, fails or takes over 20 s, and std::invalid_argument when no panel has a point to draw.
std::string render_svg(const Chart& chart);

// The position of a point in its panel's drawing, in pixels from the upper left corner.
struct DrawnPoint {
  std::size_t index = 0;  // index in ChartPanel::points
  double x = 0.0;
  double y = 0.0;
  bool on_front = false;
};

// One panel for a page. The page sets the title itself, and the colours are the page's CSS variables
// --chart-ground, --chart-ink, --chart-tick, --chart-axis, --chart-grid, --chart-point, --chart-front and
// --chart-step.
struct DrawnPanel {
  std::string title;
  std::string svg;  // the element alone, without XML prolog and without <title>
  int width = 0;
  int height = 0;
  std::vector<DrawnPoint> points;
};

// Returns each panel as a drawing narrow enough for a telephone, all with the same axes. Only the points of
// the front have labels (all of them if there is no front): a page names the others when the pointer is over
// them. The same chart gives the same bytes; throws as render_svg() does.
std::vector<DrawnPanel> render_panels(const Chart& chart);

}  // namespace penumbra::study
