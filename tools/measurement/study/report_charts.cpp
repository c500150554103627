#include "study/report_charts.h"

#include "study/html_text.h"
#include "study/pareto_chart.h"

namespace penumbra::study {
namespace {

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

}  // namespace penumbra::study
