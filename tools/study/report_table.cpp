#include "study/report_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "study/html_text.h"
#include "study/report_detail.h"
#include "study/summary.h"

namespace penumbra::study {
namespace {

// One column of figures: how its cell is read from a record and shown.
struct Column {
  std::string title;
  std::string unit;
  std::function<std::optional<double>(const Record&)> value;
  std::function<std::string(double)> text;
  bool has_bar = false;  // a line under the figure, as long as its share of the column's largest
};

using Figure = std::optional<double> Metrics::*;

Column metric(const char* title, const char* unit, Figure figure, const char* format, double scale = 1.0) {
  return {title, unit, [figure](const Record& record) { return record.metrics.*figure; },
          [format, scale](double value) { return fmt::format(fmt::runtime(format), value * scale); }};
}

std::string with_thousands(double count) {
  std::string text = fmt::format("{:.0f}", count);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, "\u202F");
  return text;
}

std::optional<double> all_fetches(const Record& record) {
  const std::optional<double>& at_full_size = record.metrics.fetches_mean;
  return at_full_size ? std::optional(*at_full_size + record.metrics.preprocess_fetches_per_pixel)
                      : std::nullopt;
}

std::vector<Column> columns(const Results& results) {
  std::vector<Column> all = {
      {"Light", "degrees", [](const Record& record) { return std::optional(record.light_degrees); },
       [](double value) { return fmt::format("{}", value); }},
      metric("RMSE in penumbra", "of visibility", &Metrics::rmse_penumbra, "{:.4f}"),
      metric("RMSE all pixels", "of visibility", &Metrics::rmse_all, "{:.4f}"),
      metric("Leaks", "% of umbra", &Metrics::leak_rate, "{:.2f}", 100.0),
      metric("False shadow", "% of lit", &Metrics::false_shadow_rate, "{:.2f}", 100.0),
      {"Fetches", "per pixel", all_fetches, [](double value) { return fmt::format("{:.1f}", value); }},
      {"Penumbra", "pixels",
       [](const Record& record) {
         return std::optional(static_cast<double>(record.metrics.penumbra_pixels));
       },
       with_thousands},
  };
  all[1].has_bar = true;
  std::erase_if(all, [&results](const Column& column) {
    return std::none_of(results.records.begin(), results.records.end(),
                        [&column](const Record& record) { return column.value(record).has_value(); });
  });
  return all;
}

std::string head(const std::string& title, const std::string& unit, const char* kind) {
  const std::string second = unit.empty() ? "" : "<span class=\"unit\">" + unit + "</span>";
  return fmt::format("<th scope=\"col\" class=\"{}\"><button type=\"button\">{}{}</button></th>\n", kind,
                     title, second);
}

double largest(const Results& results, const Column& column) {
  double most = 0.0;
  for (const Record& record : results.records) most = std::max(most, column.value(record).value_or(0.0));
  return most;
}

std::string figure_cell(const Column& column, const Record& record, double most) {
  const std::optional<double> value = column.value(record);
  if (!value) return "<td class=\"figure\" data-value=\"\">–</td>\n";
  const std::string bar =
      column.has_bar && most > 0.0
          ? fmt::format("<span class=\"bar\" style=\"--share:{:.4f}\"></span>", *value / most)
          : "";
  return fmt::format("<td class=\"figure\" data-value=\"{:.9g}\">{}{}</td>\n", *value, column.text(*value),
                     bar);
}

std::string technique_cell(const std::string& label, const std::string& about_id) {
  const std::string safe = escape_html(label);
  return fmt::format(
      "<th scope=\"row\" class=\"name technique\" data-value=\"{}\"><span class=\"label\">{}</span>"
      "<button type=\"button\" class=\"about\" data-tip=\"{}\" aria-label=\"Parameters of "
      "{}\">i</button></th>\n",
      safe, safe, about_id, safe);
}

std::string scene_cell(const std::string& scene) {
  const std::string safe = escape_html(scene);
  return fmt::format("<td class=\"name scene\" data-value=\"{}\">{}</td>\n", safe, safe);
}

// The place of a record's pictures in their list.
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

class Table {
 public:
  Table(const Results& results, const std::vector<PictureRow>& pictures)
      : results_(results), pictures_(pictures), columns_(columns(results)) {
    for (const Column& column : columns_) largest_.push_back(largest(results, column));
  }

  std::string html() const {
    std::string text = "<table class=\"figures\">\n<thead>\n<tr>" + head("Technique", "", "name technique") +
                       head("Scene", "", "name scene");
    for (const Column& column : columns_) text += head(column.title, column.unit, "figure");
    text +=
        "<th scope=\"col\" class=\"links\"><span class=\"hidden\">Pictures and "
        "details</span></th></tr>\n</thead>\n";
    for (std::size_t i = 0; i < results_.records.size(); ++i) text += record_rows(i);
    return text + "</table>\n";
  }

 private:
  std::string record_rows(std::size_t index) const {
    const Record& record = results_.records[index];
    const std::string label = choice_of(results_, record).label;
    const std::string about_id = fmt::format("about-{}", index);
    std::string html = fmt::format(
        "<tbody data-technique=\"{}\" data-scene=\"{}\" data-light=\"{}\">\n<tr class=\"record\">",
        escape_html(label), escape_html(record.scene), record.light_degrees);
    html += technique_cell(label, about_id) + scene_cell(record.scene);
    for (std::size_t i = 0; i < columns_.size(); ++i) html += figure_cell(columns_[i], record, largest_[i]);
    html += links_cell(pictures_of(record, pictures_), index) + "</tr>\n";
    return html +
           fmt::format("<tr class=\"detail\" id=\"detail-{}\"><td colspan=\"{}\">\n", index,
                       columns_.size() + 3) +
           record_detail(results_, record, about_id) + "</td></tr>\n</tbody>\n";
  }

  const Results& results_;
  const std::vector<PictureRow>& pictures_;
  std::vector<Column> columns_;
  std::vector<double> largest_;
};

std::string option(const std::string& value, const std::string& text) {
  return "<option value=\"" + escape_html(value) + "\">" + escape_html(text) + "</option>\n";
}

std::string choice(const char* name, const char* label, const std::string& options) {
  return fmt::format("<label>{} <select name=\"{}\">\n<option value=\"\">all</option>\n{}</select></label>\n",
                     label, name, options);
}

std::string filters(const Results& results) {
  std::string techniques;
  for (const Choice& entry : choices(results)) techniques += option(entry.label, entry.label);
  std::string scenes;
  for (const std::string& scene : scene_names(results)) scenes += option(scene, scene);
  std::string lights;
  for (const double light : light_sizes(results)) {
    lights += option(fmt::format("{}", light), fmt::format("{}°", light));
  }
  return "<form class=\"filters needs-script\" id=\"filters\">\n" +
         choice("technique", "Technique", techniques) + choice("scene", "Scene", scenes) +
         choice("light", "Light", lights) +
         "<button type=\"reset\">Show all</button>\n<output class=\"quiet\" "
         "aria-live=\"polite\"></output>\n</form>\n";
}

}  // namespace

std::string record_table(const Results& results, const std::vector<PictureRow>& pictures) {
  if (results.records.empty()) return {};
  return filters(results) +
         "<div class=\"scroll\" role=\"region\" aria-label=\"All figures\" tabindex=\"0\">\n" +
         Table(results, pictures).html() + "</div>\n";
}

}  // namespace penumbra::study
