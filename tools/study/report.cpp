#include "study/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "study/chart.h"
#include "study/colour_map.h"
#include "study/html_text.h"
#include "study/pareto_chart.h"
#include "study/report_style.h"
#include "study/report_table.h"
#include "study/report_words.h"
#include "study/summary.h"

namespace penumbra::study {
namespace {

std::string section(const std::string& title, const std::string& body) {
  return body.empty() ? "" : "<section>\n<h2>" + title + "</h2>\n" + body + "</section>\n";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string introduction(const Results& results) {
  std::vector<std::string> lights;
  for (const double degrees : light_sizes(results)) lights.push_back(fmt::format("{}°", degrees));
  return fmt::format(
      "<h1>Penumbra: measured soft shadows</h1>\n"
      "<p>{} techniques, run from the library's real shader files, against ray tracing: {} scenes ({}), "
      "lights of "
      "{}. Error is that of visibility, from 0 (hidden) to 1 (lit).</p>\n",
      choices(results).size(), scene_names(results).size(), escape_html(joined(scene_names(results))),
      joined(lights));
}

std::string findings(const Results& results) {
  std::string html;
  for (const Record& record : results.records) {
    if (record.metrics.invalid == 0) continue;
    html += fmt::format("<p class=\"finding\">{} in {} at {}°: {} results are no visibility.</p>\n",
                        escape_html(record.technique), escape_html(record.scene), record.light_degrees,
                        record.metrics.invalid);
  }
  return html;
}

std::string headline_cards(const Results& results) {
  std::string html;
  for (const Headline& headline : headlines(results)) {
    html +=
        fmt::format("<div class=\"card\"><p class=\"value\">{}</p><p class=\"name\">{}</p><p>{}</p></div>\n",
                    escape_html(headline.value), escape_html(headline.name), escape_html(headline.detail));
  }
  if (html.empty()) return {};
  return "<div class=\"cards\">\n" + html +
         "</div>\n<p class=\"quiet\">Means over all scenes and lights; every scene weighs the same.</p>\n";
}

std::string machine(const Results& results) {
  const auto entry = [](const char* name, const std::string& value) {
    return fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, value);
  };
  const std::string note = results.is_software
                               ? "Software device: milliseconds are CPU time and rank nothing."
                               : "Graphics card: milliseconds are GPU time.";
  return "<dl class=\"machine\">\n" + entry("Hardware", escape_html(results.hardware)) +
         entry("Device", escape_html(results.device)) + entry("Driver", escape_html(results.driver)) +
         entry("Library", "Penumbra " + escape_html(results.library_version)) +
         entry("Command", "<code>" + escape_html(results.command) + "</code>") + entry("Times", note) +
         "</dl>\n";
}

std::string charts(const std::vector<ReportChart>& list) {
  std::string html;
  for (const ReportChart& chart : list) {
    html += "<figure class=\"chart\">\n" + inline_svg(chart.svg) + "<figcaption>" +
            escape_html(chart.caption) + "</figcaption>\n</figure>\n";
  }
  return html;
}

std::string image(const Picture& picture, const std::string& description) {
  return fmt::format("<img width=\"{}\" height=\"{}\" alt=\"{}\" src=\"{}\">\n", picture.width,
                     picture.height, escape_html(description), png_data_uri(encode_png(picture)));
}

std::string legend(const Picture& strip, const std::string& from, const std::string& to) {
  return "<span class=\"legend\">" + from + " " + image(strip, "colour scale from " + from + " to " + to) +
         " " + to + "</span>";
}

std::string figure(const Picture& picture, const std::string& name, const std::string& scale) {
  return "<figure>" + image(picture, name) + "<figcaption>" + escape_html(name) + " " + scale +
         "</figcaption></figure>\n";
}

std::string picture_row(const PictureRow& row) {
  const std::string grey = legend(ramp_strip(visibility_colour, 0.0, 1.0), "0", "1");
  const std::string error = legend(ramp_strip(error_colour, -1.0, 1.0), fmt::format("−{}", row.error_scale),
                                   fmt::format("+{}", row.error_scale));
  const std::string fetches =
      legend(ramp_strip(fetch_colour, 0.0, 1.0), "0", fmt::format("{}", row.fetch_scale));
  return fmt::format("<h3>{}, {}° light: {}</h3>\n", escape_html(row.scene), row.light_degrees,
                     escape_html(row.technique)) +
         "<div class=\"row\">\n" + figure(row.reference, "Ray traced (T1)", grey) +
         figure(row.result, row.technique, grey) +
         figure(row.error, "Error: blue too dark, red too bright", error) +
         figure(row.fetches, "Fetches per pixel", fetches) + "</div>\n";
}

std::string pictures(const std::vector<PictureRow>& rows) {
  if (rows.empty()) return {};
  std::string html =
      "<p class=\"quiet\">Pale blue-grey: no surface there. Magenta: no valid result, a finding.</p>\n";
  for (const PictureRow& row : rows) html += picture_row(row);
  return html;
}

// Which reference stands behind the figures, and how exact it is, per scene and light.
std::string references(const Results& results) {
  std::string rows;
  std::vector<std::tuple<std::string, double, ReferenceNote>> seen;
  for (const Record& record : results.records) {
    std::tuple<std::string, double, ReferenceNote> entry{record.scene, record.light_degrees,
                                                         record.reference};
    if (std::find(seen.begin(), seen.end(), entry) != seen.end()) continue;
    rows += fmt::format(
        "<tr><td class=\"name\">{}</td><td>{}°</td><td "
        "class=\"name\">{}</td><td>{}</td><td>{:.4f}</td></tr>\n",
        escape_html(record.scene), record.light_degrees, escape_html(record.reference.kind),
        record.reference.samples, record.reference.noise_floor);
    seen.push_back(std::move(entry));
  }
  if (rows.empty()) return {};
  return "<div class=\"scroll\"><table>\n<thead><tr><th class=\"name\">Scene</th><th>Light</th>"
         "<th class=\"name\">Reference</th><th>Rays per pixel</th><th>Noise "
         "floor</th></tr></thead>\n<tbody>\n" +
         rows + "</tbody></table></div>\n";
}

}  // namespace

std::vector<ReportChart> report_charts(const Results& results) {
  std::vector<ReportChart> list;
  if (const Chart chart = fetches_chart(results); !chart.panels.empty()) {
    list.push_back(
        {"pareto-fetches",
         "Blue: nothing measured here is both cheaper and closer to ray tracing. Means over all scenes.",
         render_svg(chart)});
  }
  if (const Chart chart = time_chart(results); !chart.panels.empty()) {
    list.push_back({"pareto-time",
                    results.is_software
                        ? "CPU time of a software device. It ranks nothing: a graphics card weighs "
                          "fetches and arithmetic differently."
                        : "Blue: nothing measured here is both faster and closer to ray tracing.",
                    render_svg(chart)});
  }
  return list;
}

std::string render_report(const ReportContent& content) {
  const Results& results = content.results;
  std::string html =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
      "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>Penumbra: measured soft shadows</title>\n<style>";
  html += kReportStyle;
  html += "</style>\n</head>\n<body>\n<header>\n" + introduction(results) + headline_cards(results) +
          findings(results) + machine(results) + "</header>\n<main>\n";
  html += section("Cost against error", charts(content.charts));
  html += section("Pictures", pictures(content.pictures));
  html += section("All figures", record_table(results));
  html += section("How exact the reference is", references(results));
  html += section("What the errors are taken against", reference_definitions_html());
  html += section("What each figure means", metric_definitions_html());
  html += "</main>\n<script>";
  html += kReportScript;
  return html + "</script>\n</body>\n</html>\n";
}

}  // namespace penumbra::study
