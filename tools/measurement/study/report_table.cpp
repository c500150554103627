#include "study/report_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "study/figure_text.h"
#include "study/html_text.h"
#include "study/report_detail.h"
#include "study/summary.h"

namespace penumbra::study {
namespace {

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

// Returns the filter's value of a scene; no scene has that name.
std::string scene_value(const std::string& scene) {
  return scene.empty() ? "mean" : "scene " + scene;
}

std::string head(const std::string& title, const std::string& unit, const char* kind) {
  const std::string second = unit.empty() ? "" : "<span class=\"unit\">" + unit + "</span>";
  return fmt::format("<th scope=\"col\" class=\"{}\"><button type=\"button\">{}{}</button></th>\n", kind,
                     title, second);
}

double largest(const std::vector<Row>& rows, const Column& column) {
  double most = 0.0;
  for (const Row& row : rows) {
    if (const std::optional<Estimate> value = column.value(row)) most = std::max(most, value->value);
  }
  return most;
}

// Formats "0.147 ± 0.031" or "0.07 [0, 0.17]": the interval stands in a box of its own, so that figures end
// at one edge.
std::string figure_words(const std::string& text) {
  const std::size_t space = text.find(' ');
  const std::string interval = space == std::string::npos ? "" : text.substr(space + 1);
  return text.substr(0, space) + " <span class=\"plus\">" + interval + "</span>";
}

std::string figure_cell(const Column& column, const Row& row, bool has_intervals, double most) {
  const std::optional<Estimate> value = column.value(row);
  const std::string words = value ? column.text(*value) : "–";
  const std::string shown = has_intervals ? figure_words(words) : words;
  if (!value) return "<td class=\"figure\" data-value=\"\">" + shown + "</td>\n";
  const std::string bar =
      column.has_bar && most > 0.0
          ? fmt::format("<span class=\"bar\" style=\"--share:{:.4f}\"></span>", value->value / most)
          : "";
  return fmt::format("<td class=\"figure\" data-value=\"{:.9g}\">{}{}</td>\n", value->value, shown, bar);
}

std::string technique_cell(const Choice& choice, const std::string& about_id) {
  const std::string safe = escape_html(choice.shown);
  return fmt::format(
      "<th scope=\"row\" class=\"name technique\" data-value=\"{}\"><span class=\"label\" "
      "title=\"{}\">{}</span>"
      "<button type=\"button\" class=\"about\" data-tip=\"{}\" aria-label=\"Parameters of "
      "{}\">i</button></th>\n",
      safe, escape_html(choice.label), safe, about_id, safe);
}

std::string scene_cell(const Row& row, std::size_t scenes) {
  if (row.is_mean()) {
    return fmt::format("<td class=\"name scene\" data-value=\"\">mean of {}</td>\n", scenes);
  }
  const std::string safe = escape_html(row.scene);
  return fmt::format("<td class=\"name scene\" data-value=\"{}\">{}</td>\n", safe, safe);
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

std::string links_cell(const std::optional<std::size_t>& pictures, std::size_t row) {
  const std::string link =
      pictures ? fmt::format("<a class=\"to-pictures\" href=\"#picture-{}\">Pictures</a>\n", *pictures) : "";
  return fmt::format(
      "<td class=\"links\">{}<button type=\"button\" class=\"unfold\" aria-expanded=\"true\" "
      "aria-controls=\"detail-{}\">More</button></td>\n",
      link, row);
}

class HtmlTable {
 public:
  HtmlTable(const Results& results, const std::vector<PictureRow>& pictures)
      : results_(results), pictures_(pictures), rows_(rows_of(results)), columns_(columns(rows_)) {
    for (const Column& column : columns_) {
      largest_.push_back(largest(rows_, column));
      has_intervals_.push_back(std::any_of(rows_.begin(), rows_.end(), [&column](const Row& row) {
        const std::optional<Estimate> value = column.value(row);
        return value && value->interval;
      }));
    }
  }

  std::string html() const {
    std::string text = "<table class=\"figures\">\n<thead>\n<tr>" + head("Technique", "", "name technique") +
                       head("Scene", "", "name scene");
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      text += head(columns_[i].title, columns_[i].unit, has_intervals_[i] ? "figure wide" : "figure");
    }
    text +=
        "<th scope=\"col\" class=\"links\"><span class=\"hidden\">Pictures and "
        "details</span></th></tr>\n</thead>\n";
    for (std::size_t i = 0; i < rows_.size(); ++i) text += body(i);
    return text + "</table>\n";
  }

 private:
  std::string body(std::size_t index) const {
    const Row& row = rows_[index];
    const std::string about_id = fmt::format("about-{}", index);
    std::string html = fmt::format(
        "<tbody data-technique=\"{}\" data-shown=\"{}\" data-scene=\"{}\" data-light=\"{}\">\n<tr "
        "class=\"{}\">",
        escape_html(row.choice.label), escape_html(row.choice.shown), escape_html(scene_value(row.scene)),
        row.light_degrees, row.is_mean() ? "record mean" : "record");
    html += technique_cell(row.choice, about_id) + scene_cell(row, scene_names(results_).size());
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      html += figure_cell(columns_[i], row, has_intervals_[i], largest_[i]);
    }
    html += links_cell(row.is_mean() ? std::nullopt : pictures_of(*row.record, pictures_), index) + "</tr>\n";
    return html +
           fmt::format("<tr class=\"detail\" id=\"detail-{}\"><td colspan=\"{}\">\n", index,
                       columns_.size() + 3) +
           (row.is_mean() ? mean_detail(results_, *row.record, about_id)
                          : record_detail(results_, *row.record, about_id)) +
           "</td></tr>\n</tbody>\n";
  }

  const Results& results_;
  const std::vector<PictureRow>& pictures_;
  std::vector<Row> rows_;
  std::vector<Column> columns_;
  std::vector<double> largest_;      // one for each column
  std::vector<bool> has_intervals_;  // one for each column
};

std::string option(const std::string& value, const std::string& text) {
  return "<option value=\"" + escape_html(value) + "\">" + escape_html(text) + "</option>\n";
}

std::string choice(const char* name, const char* label, const std::string& options) {
  return fmt::format("<label>{} <select name=\"{}\">\n{}</select></label>\n", label, name, options);
}

std::string filters(const Results& results) {
  std::string techniques = option("", "all");
  for (const Choice& entry : choices(results)) techniques += option(entry.label, entry.shown);
  const std::vector<std::string> names = scene_names(results);
  std::string scenes;
  if (names.size() > 1) scenes = option(scene_value(""), fmt::format("mean of {}", names.size()));
  scenes += option("", "every scene");
  for (const std::string& scene : names) scenes += option(scene_value(scene), scene);
  std::string lights = option("", "all");
  for (const double light : light_sizes(results)) {
    lights += option(fmt::format("{}", light), fmt::format("{}°", light));
  }
  return "<form class=\"filters needs-script\" id=\"filters\">\n" +
         choice("technique", "Technique", techniques) +
         "<label>Find <input type=\"search\" name=\"find\" placeholder=\"title or name\" "
         "autocomplete=\"off\"></label>\n" +
         choice("scene", "Scene", scenes) + choice("light", "Light", lights) +
         "<button type=\"reset\">Reset</button>\n<output class=\"quiet\" "
         "aria-live=\"polite\"></output>\n</form>\n";
}

}  // namespace

std::string record_table(const Results& results, const std::vector<PictureRow>& pictures) {
  if (results.records.empty()) return {};
  return filters(results) +
         "<div class=\"scroll\" role=\"region\" aria-label=\"All figures\" tabindex=\"0\">\n" +
         HtmlTable(results, pictures).html() +
         "</div>\n<p class=\"quiet\">± is half the width of the 95 % confidence interval, over the pixels of "
         "a scene and, for means, also over the scenes. Where the interval is cut off at 0 or 100 %, "
         "[a, b] gives its ends. RMSE in penumbra is over the penumbra pixels only.</p>\n";
}

}  // namespace penumbra::study
