#include "study/report_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "study/html_text.h"
#include "study/summary.h"

namespace penumbra::study {
namespace {

enum class Cost { fetches, time };

std::optional<double> price_of(const SummaryLine& line, Cost cost) {
  if (cost == Cost::time) return line.time_ms;
  return line.fetches ? std::optional(line.fetches->value) : std::nullopt;
}

// The page's text about a point.
std::string note(const Results& results, const SummaryLine& line, Cost cost) {
  const std::string price = cost == Cost::time
                                ? fmt::format("{:.3g} ms, {}", line.time_ms.value_or(0.0), time_kind(results))
                                : fetches_text(line.fetches) + " fetches per pixel";
  return fmt::format("{} penumbra RMSE\n{}\nmean of {} scene{}", figure_text(line.rmse_penumbra), price,
                     line.scenes, line.scenes == 1 ? "" : "s");
}

ChartPanel panel_of(const Results& results, double light_degrees, Cost cost) {
  ChartPanel panel;
  panel.title = fmt::format("{}° light", light_degrees);
  std::vector<CostAndError> points;
  for (const SummaryLine& line : summarise(results)) {
    const std::optional<double> price = price_of(line, cost);
    if (line.light_degrees != light_degrees || !line.complete || !price || !line.rmse_penumbra) continue;
    if (!(*price > 0.0)) continue;  // 0 has no position on a logarithmic axis
    panel.points.push_back(
        {line.choice.shown, *price, line.rmse_penumbra->value, note(results, line, cost), line.choice.label});
    points.push_back({*price, line.rmse_penumbra->value});
  }
  if (cost == Cost::fetches || !results.is_software) panel.front = pareto_front(points);
  return panel;
}

void add_panels(Chart& chart, const Results& results, Cost cost) {
  for (const double light : light_sizes(results)) {
    ChartPanel panel = panel_of(results, light, cost);
    if (!panel.points.empty()) chart.panels.push_back(std::move(panel));
  }
}

std::string chart_html(const ReportChart& chart) {
  std::string panels;
  const std::vector<std::string> drawn = render_panels(chart.chart);
  for (std::size_t i = 0; i < drawn.size(); ++i)
    panels += "<div class=\"panel\">\n<h4>" + escape_html(chart.chart.panels[i].title) + "</h4>\n" +
              drawn[i] + "</div>\n";
  return "<figure class=\"chart\">\n<h3>" + escape_html(chart.chart.title) +
         "</h3>\n<div class=\"panels\">\n" + panels + "</div>\n<figcaption>" + escape_html(chart.caption) +
         "</figcaption>\n</figure>\n";
}

}  // namespace

std::vector<ReportChart> report_charts(const Results& results) {
  std::vector<ReportChart> charts{
      {fetches_chart(results),
       "Blue: the Pareto front. No other technique measured here is both cheaper and closer to ray tracing. "
       "Means over all scenes."},
      {time_chart(results),
       results.is_software ? "CPU time of a software device. Do not rank techniques by it: on a GPU, fetches "
                             "and arithmetic have other relative costs."
                           : "Blue: the Pareto front. No other technique measured here is both faster and "
                             "closer to ray tracing."}};
  std::erase_if(charts, [](const ReportChart& chart) { return chart.chart.panels.empty(); });
  return charts;
}

std::string charts_html(const std::vector<ReportChart>& charts) {
  std::string html;
  for (const ReportChart& chart : charts) html += chart_html(chart);
  return html;
}

Chart fetches_chart(const Results& results) {
  Chart chart;
  chart.name = "pareto-fetches";
  chart.title = "Penumbra error against fetches per pixel";
  chart.x_label = "texture fetches per pixel, mean of the frame";
  chart.y_label = "penumbra RMSE";
  add_panels(chart, results, Cost::fetches);
  return chart;
}

Chart time_chart(const Results& results) {
  Chart chart;
  chart.name = "pareto-time";
  chart.title = "Penumbra error against time per frame";
  chart.x_label = results.is_software ? "CPU time of a frame, ms (not a ranking)" : "GPU time of a frame, ms";
  chart.y_label = "penumbra RMSE";
  add_panels(chart, results, Cost::time);
  return chart;
}

std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isfinite(points[i].cost) && std::isfinite(points[i].error)) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(points[a].cost, points[a].error, a) < std::tuple(points[b].cost, points[b].error, b);
  });

  // In the order of cost, a point is in the front if its error is below the smallest so far, or if it equals
  // the point with the smallest.
  std::vector<std::size_t> front;
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    const bool twin =
        !front.empty() && points[i].cost == points[front.back()].cost && points[i].error == best;
    if (points[i].error < best || twin) {
      front.push_back(i);
      best = points[i].error;
    }
  }
  return front;
}

}  // namespace penumbra::study
