#include "study/report_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "study/figure_text.h"
#include "study/html_text.h"
#include "study/report_detail.h"
#include "study/summary.h"

namespace penumbra::study {
namespace {

using Json = nlohmann::ordered_json;

// A record, or the mean of a technique over all scenes.
struct Row {
  Choice choice;
  std::string scene;               // empty for the mean
  const Record* record = nullptr;  // for a mean, the first of its records: they share parameters and settings
  double light_degrees = 0.0;
  std::optional<Estimate> rmse_penumbra;
  std::optional<Estimate> rmse_all;
  std::optional<Estimate> leak_rate;
  std::optional<Estimate> false_shadow_rate;
  std::optional<Estimate> fetches;     // sum of all passes
  std::optional<Estimate> operations;  // sum of all passes
  std::size_t penumbra_pixels = 0;

  bool is_mean() const { return scene.empty(); }
};

std::optional<Estimate> estimate(const std::optional<double>& value, std::optional<Interval> interval,
                                 double more = 0.0) {
  if (!value) return std::nullopt;
  if (interval) {
    interval->low += more;
    interval->high += more;
  }
  return Estimate{*value + more, interval};
}

Row row_of(const Results& results, const Record& record) {
  const Metrics& metrics = record.metrics;
  const MetricIntervals& intervals = metrics.intervals;
  return {choice_of(results, record),
          record.scene,
          &record,
          record.light_degrees,
          estimate(metrics.rmse_penumbra, intervals.rmse_penumbra),
          estimate(metrics.rmse_all, intervals.rmse_all),
          estimate(metrics.leak_rate, intervals.leak_rate),
          estimate(metrics.false_shadow_rate, intervals.false_shadow_rate),
          estimate(metrics.fetches_mean, intervals.fetches_mean, metrics.preprocess_fetches_per_pixel),
          results.front_end ? estimate(record.operations_per_pixel, std::nullopt) : std::nullopt,
          metrics.penumbra_pixels};
}

Row row_of(const Results& results, const SummaryLine& line) {
  const auto first = std::find_if(results.records.begin(), results.records.end(), [&](const Record& record) {
    return record.light_degrees == line.light_degrees && record.technique == line.choice.technique &&
           choice_of(results, record) == line.choice;
  });
  return {line.choice,
          "",
          &*first,
          line.light_degrees,
          line.rmse_penumbra,
          line.rmse_all,
          line.leak_rate,
          line.false_shadow_rate,
          line.fetches,
          results.front_end ? line.operations : std::nullopt,
          sample_of(results, line.light_degrees).penumbra_pixels};
}

// Returns means first, where there is more than one scene; then the records in their order.
std::vector<Row> rows_of(const Results& results) {
  std::vector<Row> rows;
  if (scene_names(results).size() > 1) {
    for (const SummaryLine& line : summarise(results)) {
      if (line.complete) rows.push_back(row_of(results, line));
    }
  }
  for (const Record& record : results.records) rows.push_back(row_of(results, record));
  return rows;
}

// One column of figures: how a row's cell is read and shown.
struct Column {
  std::string title;
  std::string unit;
  std::function<std::optional<Estimate>(const Row&)> value;
  std::function<std::string(const Estimate&)> text;
  bool has_bar = false;  // a line under the figure, as long as its share of the column's largest
};

Column figure(const char* title, const char* unit, std::optional<Estimate> Row::*figure, double scale = 1.0) {
  return {title, unit, [figure](const Row& row) { return row.*figure; },
          [scale](const Estimate& value) { return figure_text(value, scale); }};
}

std::string with_thousands(const Estimate& count) {
  std::string text = fmt::format("{:.0f}", count.value);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, "\u202F");
  return text;
}

std::vector<Column> columns(const std::vector<Row>& rows) {
  std::vector<Column> all = {
      {"Light", "degrees",
       [](const Row& row) {
         return Estimate{row.light_degrees, std::nullopt};
       },
       [](const Estimate& value) { return fmt::format("{}", value.value); }},
      figure("RMSE in penumbra", "of visibility", &Row::rmse_penumbra),
      figure("RMSE of all pixels", "of visibility", &Row::rmse_all),
      figure("Leaks", "% of umbra", &Row::leak_rate, 100.0),
      figure("False shadow", "% of lit", &Row::false_shadow_rate, 100.0),
      {"Fetches", "per pixel", [](const Row& row) { return row.fetches; },
       [](const Estimate& value) { return fetches_text(value); }},
      {"Operations", "per pixel", [](const Row& row) { return row.operations; },
       [](const Estimate& value) { return operations_text(value); }},
      {"Penumbra", "pixels",
       [](const Row& row) {
         return Estimate{static_cast<double>(row.penumbra_pixels), std::nullopt};
       },
       with_thousands},
  };
  all[1].has_bar = true;
  std::erase_if(all, [&rows](const Column& column) {
    return std::none_of(rows.begin(), rows.end(),
                        [&column](const Row& row) { return column.value(row).has_value(); });
  });
  return all;
}

// Returns the index of a record's pictures in their list.
std::optional<std::size_t> pictures_of(const Record& record, const std::vector<PictureRow>& pictures) {
  const auto found = std::find_if(pictures.begin(), pictures.end(), [&record](const PictureRow& row) {
    return row.scene == record.scene && row.technique == record.technique &&
           row.light_degrees == record.light_degrees;
  });
  if (found == pictures.end()) return std::nullopt;
  return static_cast<std::size_t>(found - pictures.begin());
}

Json cells(const std::vector<Column>& columns, const Row& row) {
  Json all = Json::array();
  for (const Column& column : columns) {
    const std::optional<Estimate> value = column.value(row);
    all.push_back(value ? Json{value->value, column.text(*value)} : Json{nullptr, "–"});
  }
  return all;
}

// Returns what report/table.js draws.
Json figures(const Results& results, const std::vector<PictureRow>& pictures) {
  const std::vector<Row> rows = rows_of(results);
  const std::vector<Column> shown = columns(rows);
  Json data{{"scenes", scene_names(results)}, {"lights", light_sizes(results)}};
  for (const Column& column : shown)
    data["columns"].push_back({{"title", column.title}, {"unit", column.unit}, {"bar", column.has_bar}});
  for (const Row& row : rows) {
    Json entry{{"technique", row.choice.label},
               {"shown", row.choice.shown},
               {"scene", row.is_mean() ? Json() : Json(row.scene)},
               {"light", row.light_degrees},
               {"cells", cells(shown, row)}};
    if (const auto place = row.is_mean() ? std::nullopt : pictures_of(*row.record, pictures))
      entry["pictures"] = *place;
    entry["groups"] = row.is_mean() ? mean_detail(results, *row.record) : record_detail(results, *row.record);
    data["rows"].push_back(std::move(entry));
  }
  return data;
}

constexpr std::string_view kTable =
    R"html(<p class="no-script">The table needs JavaScript. The same figures are in results.tsv next to this file.</p>
<form class="filters needs-script" id="filters">
<label>Technique <select name="technique"></select></label>
<label>Find <input type="search" name="find" placeholder="title or name" autocomplete="off"></label>
<label>Scene <select name="scene"></select></label>
<label>Light <select name="light"></select></label>
<button type="reset">Reset</button>
<output class="quiet" aria-live="polite"></output>
</form>
<div class="scroll" role="region" aria-label="All figures" tabindex="0"><table class="figures"></table></div>
<p class="quiet">± is half the width of the 95 % confidence interval, over the pixels of a scene and, for means, also
over the scenes. Where the interval is cut off at 0 or 100 %, [a, b] gives its ends. RMSE in penumbra is over the
penumbra pixels only.</p>
)html";

}  // namespace

std::string record_table(const Results& results, const std::vector<PictureRow>& pictures) {
  if (results.records.empty()) return {};
  return std::string(kTable) + json_script("figures-data", figures(results, pictures));
}

}  // namespace penumbra::study
