#include "study/report_charts.h"

#include <fmt/format.h>

#include "study/html_text.h"
#include "study/pareto_chart.h"

namespace penumbra::study {
namespace {

// The reach is larger than the drawn point, for touch input.
constexpr double kReach = 11.0;

std::string point_html(const DrawnPoint& drawn, const ChartPoint& point) {
  const std::string label = escape_html(point.label);
  const std::string note = escape_html(point.note);
  return fmt::format(
      "<a class=\"point{}\" href=\"#figures\" data-technique=\"{}\" data-label=\"{}\" data-note=\"{}\" "
      "aria-label=\"{}: {}\">"
      "<circle class=\"reach\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>"
      "<circle class=\"ring\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\"/></a>\n",
      drawn.on_front ? " front" : "", escape_html(point.name), label, note, label, note, drawn.x, drawn.y,
      kReach, drawn.x, drawn.y);
}

std::string panel_html(const DrawnPanel& drawn, const ChartPanel& panel) {
  std::string points;
  for (const DrawnPoint& point : drawn.points) points += point_html(point, panel.points.at(point.index));
  std::string svg = drawn.svg;
  const std::string drawing = fmt::format("<svg role=\"group\" aria-label=\"{}\"", escape_html(drawn.title));
  svg.replace(0, 4, drawing);
  svg.insert(svg.rfind("</svg>"), "<g class=\"points\">\n" + points + "</g>\n");
  return "<div class=\"panel\">\n<h4>" + escape_html(drawn.title) + "</h4>\n" + svg + "</div>\n";
}

std::string chart_html(const ReportChart& chart) {
  std::string panels;
  for (std::size_t i = 0; i < chart.panels.size(); ++i) {
    panels += panel_html(chart.panels[i], chart.chart.panels.at(i));
  }
  return "<figure class=\"chart\">\n<h3>" + escape_html(chart.chart.title) +
         "</h3>\n<div class=\"panels\">\n" + panels + "</div>\n<figcaption>" + escape_html(chart.caption) +
         "</figcaption>\n</figure>\n";
}

void add(std::vector<ReportChart>& charts, Chart chart, const std::string& caption) {
  if (chart.panels.empty()) return;
  ReportChart& added = charts.emplace_back();
  added.svg = render_svg(chart);
  added.panels = render_panels(chart);
  added.caption = caption;
  added.chart = std::move(chart);
}

}  // namespace

std::vector<ReportChart> report_charts(const Results& results) {
  std::vector<ReportChart> charts;
  add(charts, fetches_chart(results),
      "Blue: the Pareto front. No other technique measured here is both cheaper and closer to ray tracing. "
      "Means over all scenes.");
  add(charts, time_chart(results),
      results.is_software ? "CPU time of a software device. Do not rank techniques by it: on a GPU, fetches "
                            "and arithmetic have other relative costs."
                          : "Blue: the Pareto front. No other technique measured here is both faster and "
                            "closer to ray tracing.");
  return charts;
}

std::string charts_html(const std::vector<ReportChart>& charts) {
  std::string html;
  for (const ReportChart& chart : charts) html += chart_html(chart);
  return html;
}

}  // namespace penumbra::study
