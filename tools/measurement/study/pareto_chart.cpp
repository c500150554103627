#include "study/pareto_chart.h"

#include <fmt/format.h>

#include "study/pareto.h"
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

}  // namespace

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

}  // namespace penumbra::study
