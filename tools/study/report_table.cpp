#include "study/report_table.h"

#include <fmt/format.h>

#include <functional>

#include "study/html_text.h"

namespace penumbra::study {
namespace {

// One column of figures: how its cell is read from a record and shown.
struct Column {
  std::string title;
  std::function<std::optional<double>(const Record&)> value;
  const char* format;  // of fmt, for the scaled value
  double scale = 1.0;
};

using Figure = std::optional<double> Metrics::*;

Column metric(const char* title, Figure figure, const char* format, double scale = 1.0) {
  return {title, [figure](const Record& record) { return record.metrics.*figure; }, format, scale};
}

Column share(const char* title, std::optional<ErrorShare> ErrorSplit::*part, double ErrorShare::*figure,
             const char* format) {
  return {title,
          [part, figure](const Record& record) -> std::optional<double> {
            const std::optional<ErrorShare>& found = record.metrics.split.*part;
            return found ? std::optional((*found).*figure) : std::nullopt;
          },
          format};
}

std::vector<Column> columns(const Results& results) {
  const std::string kind(time_kind(results));
  return {
      {"Light °", [](const Record& record) { return std::optional(record.light_degrees); }, "{}"},
      metric("RMSE penumbra", &Metrics::rmse_penumbra, "{:.4f}"),
      metric("RMSE all", &Metrics::rmse_all, "{:.4f}"),
      metric("Bias", &Metrics::bias, "{:+.4f}"),
      metric("Variance", &Metrics::variance, "{:.5f}"),
      metric("p99", &Metrics::p99, "{:.3f}"),
      metric("Max", &Metrics::max_error, "{:.3f}"),
      metric("Leak %", &Metrics::leak_rate, "{:.2f}", 100.0),
      metric("False shadow %", &Metrics::false_shadow_rate, "{:.2f}", 100.0),
      metric("Fetches", &Metrics::fetches_mean, "{:.1f}"),
      metric("Fetches p95", &Metrics::fetches_p95, "{:.0f}"),
      metric("Fetches penumbra", &Metrics::fetches_penumbra_mean, "{:.1f}"),
      {"Preparation",
       [](const Record& record) { return std::optional(record.metrics.preprocess_fetches_per_pixel); },
       "{:.1f}"},
      {"Mask saves %",
       [](const Record& record) {
         return record.metrics.mask ? std::optional(record.metrics.mask->pixels_saved) : std::nullopt;
       },
       "{:.1f}", 100.0},
      {"Mask misses %",
       [](const Record& record) {
         return record.metrics.mask ? record.metrics.mask->penumbra_pixels_missed : std::nullopt;
       },
       "{:.2f}", 100.0},
      {"Shimmer, static noise",
       [](const Record& record) { return record.shimmer ? record.shimmer->static_noise : std::nullopt; },
       "{:.4f}"},
      {"Shimmer, noise per frame",
       [](const Record& record) { return record.shimmer ? record.shimmer->per_frame_noise : std::nullopt; },
       "{:.4f}"},
      share("Map mean", &ErrorSplit::map, &ErrorShare::mean, "{:+.4f}"),
      share("Map RMSE", &ErrorSplit::map, &ErrorShare::rmse, "{:.4f}"),
      share("Algorithm mean", &ErrorSplit::algorithm, &ErrorShare::mean, "{:+.4f}"),
      share("Algorithm RMSE", &ErrorSplit::algorithm, &ErrorShare::rmse, "{:.4f}"),
      share("Sampling mean", &ErrorSplit::sampling, &ErrorShare::mean, "{:+.4f}"),
      share("Sampling RMSE", &ErrorSplit::sampling, &ErrorShare::rmse, "{:.4f}"),
      {kind + " ms",
       [](const Record& record) {
         return record.time ? std::optional(record.time->median_ms) : std::nullopt;
       },
       "{:.2f}"},
      {kind + " spread ms",
       [](const Record& record) {
         return record.time ? std::optional(record.time->spread_ms) : std::nullopt;
       },
       "{:.2f}"},
      {"Invalid",
       [](const Record& record) { return std::optional(static_cast<double>(record.metrics.invalid)); }, "{}"},
  };
}

std::string head(const std::string& title, bool name) {
  return fmt::format("<th scope=\"col\"{}><button type=\"button\">{}</button></th>",
                     name ? " class=\"name\"" : "", title);
}

std::string name_cell(const std::string& text, const std::string& hint = {}) {
  const std::string safe = escape_html(text);
  const std::string title = hint.empty() ? "" : " title=\"" + escape_html(hint) + "\"";
  return fmt::format("<td class=\"name\" data-value=\"{}\"{}>{}</td>", safe, title, safe);
}

std::string figure_cell(const Column& column, const Record& record) {
  const std::optional<double> value = column.value(record);
  if (!value) return "<td data-value=\"\">–</td>";
  return fmt::format("<td data-value=\"{:.9g}\">{}</td>", *value,
                     fmt::format(fmt::runtime(column.format), *value * column.scale));
}

std::string row(const Record& record, const std::vector<Column>& figures) {
  std::string parameters;
  for (const auto& [name, values] : record.parameters) {
    parameters += fmt::format("{}{} = {}", parameters.empty() ? "" : ", ", name, fmt::join(values, " "));
  }
  std::string html =
      "<tr>" + name_cell(record.scene) + name_cell(record.technique, record.title) + name_cell(parameters) +
      name_cell(fmt::format("{} {} / {}", record.map_size, record.map_format, record.cascades));
  for (const Column& column : figures) html += figure_cell(column, record);
  return html + "</tr>\n";
}

}  // namespace

std::string record_table(const Results& results) {
  if (results.records.empty()) return {};
  const std::vector<Column> figures = columns(results);
  std::string html = "<div class=\"scroll\"><table class=\"sortable\">\n<thead><tr>" + head("Scene", true) +
                     head("Technique", true) + head("Parameters", true) + head("Map / cascades", true);
  for (const Column& column : figures) html += head(column.title, false);
  html += "</tr></thead>\n<tbody>\n";
  for (const Record& record : results.records) html += row(record, figures);
  return html + "</tbody></table></div>\n";
}

}  // namespace penumbra::study
