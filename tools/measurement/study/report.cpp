#include "study/report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>

#include "input/counted.h"
#include "study/colour_map.h"
#include "study/html_text.h"
#include "study/report_assets.h"
#include "study/report_charts.h"
#include "study/report_table.h"
#include "study/summary.h"

namespace penumbra::study {
namespace {

using Json = nlohmann::ordered_json;

// The data of a picture of visibility, by pixel.
struct Planes {
  Picture visibility;  // in 255ths; 0 where there is none
  Picture receivers;   // 255 where there is one
  Picture invalid;     // 255 where the result is no visibility; empty without such a pixel
};

Planes planes_of(const Picture& painted) {
  const Picture empty{painted.width, painted.height, 1, {}};
  Planes planes{empty, empty, empty};
  bool all_valid = true;
  for (int y = 0; y < painted.height; ++y) {
    for (int x = 0; x < painted.width; ++x) {
      const Rgb colour = pixel(painted, x, y);
      const bool receiver = !(colour == kNoReceiver);
      const bool valid = !(colour == kInvalid);
      planes.visibility.samples.push_back(receiver && valid ? colour.g : 0);
      planes.receivers.samples.push_back(receiver ? 255 : 0);
      planes.invalid.samples.push_back(valid ? 0 : 255);
      all_valid = all_valid && valid;
    }
  }
  if (all_valid) planes.invalid.samples.clear();
  return planes;
}

// Returns a ramp as the bytes of its colours, in base64.
std::string ramp(Rgb (*colour)(double), double from, double to) {
  const Picture strip = ramp_strip(colour, from, to);
  return base64(std::as_bytes(std::span(strip.samples)));
}

std::string css_colour(Rgb colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b);
}

class Album {
 public:
  Album(const Results& results, const std::vector<PictureRow>& rows) : results_(results) {
    for (std::size_t i = 0; i < rows.size(); ++i) add(i, rows[i]);
  }

  std::string html() const {
    Json index;
    index["ramps"] = {{"error", ramp(error_colour, -1.0, 1.0)}, {"fetches", ramp(fetch_colour, 0.0, 1.0)}};
    index["noReceiver"] = css_colour(kNoReceiver);
    index["invalid"] = css_colour(kInvalid);
    index["stages"] = stages_;
    return json_script("picture-index", index) + data_;
  }

 private:
  void add(std::size_t place, const PictureRow& row) {
    Json& stage = stage_of(row);
    const Planes result = planes_of(row.result);
    Json item;
    item["id"] = place;
    item["technique"] = row.technique;
    const Record* record = record_of(row);
    item["shown"] = record == nullptr ? row.technique : short_title(record->technique, record->title);
    if (record != nullptr && record->metrics.rmse_penumbra) item["rmse"] = *record->metrics.rmse_penumbra;
    item["errorScale"] = row.error_scale;
    item["fetchScale"] = row.fetch_scale;
    item["result"] = store(result.visibility);
    if (!result.invalid.samples.empty()) item["invalid"] = store(result.invalid);
    if (!row.fetch_counts.empty()) item["fetches"] = store(row.fetch_counts.png());
    if (!row.mask.empty()) item["mask"] = store(planes_of(row.mask).visibility);
    stage["items"].push_back(std::move(item));
  }

  Json& stage_of(const PictureRow& row) {
    for (Json& stage : stages_) {
      if (stage["scene"] == row.scene && stage["light"] == row.light_degrees) return stage;
    }
    const Planes reference = planes_of(row.reference);
    const Picture& size = reference.visibility;
    stages_.push_back({{"scene", row.scene},
                       {"light", row.light_degrees},
                       {"width", size.width},
                       {"height", size.height},
                       {"reference", store(reference.visibility)},
                       {"receivers", store(reference.receivers)},
                       {"items", Json::array()}});
    return stages_.back();
  }

  const Record* record_of(const PictureRow& row) const {
    const auto found =
        std::find_if(results_.records.begin(), results_.records.end(), [&row](const Record& record) {
          return record.scene == row.scene && record.technique == row.technique &&
                 record.light_degrees == row.light_degrees;
        });
    return found == results_.records.end() ? nullptr : &*found;
  }

  std::size_t store(const Picture& grey) { return store(encode_png(grey)); }

  std::size_t store(std::span<const std::byte> png) {
    data_ += fmt::format("<script type=\"text/plain\" id=\"png-{}\">{}</script>\n", stored_, base64(png));
    return stored_++;
  }

  const Results& results_;
  Json stages_ = Json::array();
  std::string data_;
  std::size_t stored_ = 0;
};

constexpr std::string_view kViewer =
    R"html(<p class="no-script">The viewer needs JavaScript. The same pictures are in the folder
<code>pictures</code> next to this file.</p>
<div class="viewer needs-script" id="viewer">
<form class="controls">
<div class="line">
<label>Scene <select name="scene"></select></label>
<label>Light <select name="light"></select></label>
<label>Left <select name="left"></select></label>
<fieldset><legend>Right</legend>
<label><input type="radio" name="kind" value="result" checked><span>Result</span></label>
<label><input type="radio" name="kind" value="error"><span>Error</span></label>
<label><input type="radio" name="kind" value="fetches"><span>Fetches</span></label>
<label><input type="radio" name="kind" value="mask"><span>Mask</span></label></fieldset>
<fieldset><legend>Compare by</legend>
<label><input type="radio" name="mode" value="slider" checked><span>Slider</span></label>
<label><input type="radio" name="mode" value="blink"><span>Blink</span></label></fieldset>
</div>
<div class="techniques" role="group" aria-label="Technique on the right"></div>
</form>
<div class="stage" tabindex="0" role="group" aria-label="Comparison" aria-describedby="viewer-keys">
<canvas role="img"></canvas>
<span class="tag left" aria-hidden="true"></span><span class="tag right" aria-hidden="true"></span>
<div class="divider" role="slider" tabindex="0" aria-label="Border between left and right, percent from the left"
 aria-valuemin="0" aria-valuemax="100" aria-valuenow="50"><span class="grip" aria-hidden="true"></span></div>
</div>
<div class="line below">
<div class="zoom" role="group" aria-label="Zoom"><button type="button" name="out" aria-label="Zoom out">−</button>
<output></output><button type="button" name="in" aria-label="Zoom in">+</button>
<button type="button" name="fit">Fit</button></div>
<label class="scale">Full colour at an error of ± <input type="range" name="scale" min="0" max="100" step="1">
<output></output></label>
<span class="legend"><span class="from"></span><canvas width="256" height="1" role="img"></canvas><span class="to"></span></span>
</div>
<p class="readout">Point at the picture to read the values of a pixel.</p>
</div>
)html";

constexpr std::string_view kExplanation =
    R"html(<p class="quiet" id="viewer-keys">Drag the border, or the picture when it is enlarged.
Ctrl and the wheel, or two fingers, zoom. Keys on the picture: + and − zoom, 0 fits the picture to the window, arrow keys move it, comma and full stop move the
border, B blinks, X swaps left and right, N and P select the next and the previous technique.</p>
<p class="quiet">One frame, of the first noise seed. Pictures hold 8 bits: differences below 1/255 (0.004) do not show, and
fetches are cut off at 255. <span class="swatch no-receiver"></span> no surface; <span class="swatch invalid"></span> invalid
result, reported as a finding.</p>
)html";

constexpr std::string_view kNone =
    R"html(<p>This report was made from a results file, which contains no pictures. The command
below measures again and adds the pictures:</p>
)html";

// Pictures are grey PNGs in base64, one byte a pixel: visibility in 255ths, or fetches. Reference and
// receivers stand once per scene and light; the browser computes the error. Without pictures the text says
// how to get some.
std::string pictures_html(const Results& results, const std::vector<PictureRow>& pictures) {
  if (results.records.empty()) return {};
  if (pictures.empty()) return std::string(kNone) + command_html(results.command + " --output report");
  return std::string(kViewer) + std::string(kExplanation) + Album(results, pictures).html();
}

struct Section {
  std::string id;
  std::string title;
  std::string body;  // if empty, the section is left out
};

std::string section_html(const Section& section) {
  return "<section id=\"" + section.id + "\">\n<h2>" + section.title + "</h2>\n" + section.body +
         "</section>\n";
}

std::string navigation(const std::vector<Section>& sections) {
  std::string html;
  for (const Section& section : sections) {
    html += "<a href=\"#" + section.id + "\">" + section.title + "</a>\n";
  }
  return "<nav aria-label=\"Sections\">\n" + html + "</nav>\n";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string introduction(const Results& results) {
  std::vector<std::string> lights;
  for (const double degrees : light_sizes(results)) lights.push_back(fmt::format("{}°", degrees));
  const std::vector<std::string> scenes = scene_names(results);
  return fmt::format(
      "<h1>Penumbra: measured soft shadows</h1>\n"
      "<p class=\"lead\">{}, each measured from its own shader file against ray tracing in {} ({}) under "
      "lights of {}. Errors are those of visibility, from 0 (hidden) to 1 (lit).</p>\n",
      counted(choices(results).size(), "technique"), counted(scenes.size(), "scene"),
      escape_html(joined(scenes)), joined(lights));
}

std::string findings(const Results& results) {
  std::string html;
  for (const Record& record : results.records) {
    if (record.metrics.invalid == 0) continue;
    html += fmt::format(
        "<p class=\"finding\">{} in {} at {}°: {} results are NaN, infinite or outside [0, 1].</p>\n",
        escape_html(choice_of(results, record).shown), escape_html(record.scene), record.light_degrees,
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
         "</div>\n<p class=\"quiet\">Means over all scenes and lights; every scene has the same "
         "weight.</p>\n";
}

std::string machine(const Results& results) {
  const auto entry = [](const char* name, const std::string& value) {
    return fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, value);
  };
  const std::string note =
      results.is_software ? "Software device: milliseconds are CPU time and say little about speed on a GPU."
                          : "Hardware GPU: milliseconds are GPU time.";
  std::string library = "Penumbra " + escape_html(results.library_version);
  if (results.commit) library += ", commit <code>" + escape_html(*results.commit) + "</code>";
  std::string packages;
  const auto add_packages = [&](const std::vector<PackageNote>& notes) {
    for (const PackageNote& package : notes)
      packages +=
          entry("Package", escape_html(package.name + " " + package.version.value_or("(no version)")));
  };
  add_packages(results.packages);
  std::string earlier;
  for (const EarlierRun& run : results.earlier) {
    add_packages(run.packages);
    earlier += fmt::format("<h3>{}, by Penumbra {}{}</h3>\n{}",
                           escape_html(fmt::format("{}", fmt::join(run.techniques, ", "))),
                           escape_html(run.library_version),
                           run.commit ? ", commit <code>" + escape_html(*run.commit) + "</code>" : "",
                           command_html(run.command));
  }
  return "<dl class=\"machine\">\n" + entry("Hardware", escape_html(results.hardware)) +
         entry("Device", escape_html(results.device)) + entry("Driver", escape_html(results.driver)) +
         entry("Compiler", escape_html(results.front_end.value_or(kGlslang))) + entry("Library", library) +
         packages + entry("Times", note) + "</dl>\n<h3>The command</h3>\n" + command_html(results.command) +
         earlier;
}

// Lists the reference of the figures and its accuracy, per scene and light.
std::string references(const Results& results) {
  std::string rows;
  std::vector<std::tuple<std::string, double, ReferenceNote>> seen;
  for (const Record& record : results.records) {
    std::tuple<std::string, double, ReferenceNote> entry{record.scene, record.light_degrees,
                                                         record.reference};
    if (std::find(seen.begin(), seen.end(), entry) != seen.end()) continue;
    rows += fmt::format(
        "<tr><th scope=\"row\" class=\"name\">{}</th><td>{}</td><td "
        "class=\"name\">{}</td><td>{}</td><td>{:.4f}</td></tr>\n",
        escape_html(record.scene), record.light_degrees, escape_html(record.reference.kind),
        record.reference.samples, record.reference.noise_floor);
    seen.push_back(std::move(entry));
  }
  if (rows.empty()) return {};
  return "<div class=\"scroll\" role=\"region\" aria-label=\"References\" tabindex=\"0\"><table "
         "class=\"plain\">\n<thead><tr>"
         "<th scope=\"col\" class=\"name\">Scene</th><th scope=\"col\">Light, °</th>"
         "<th scope=\"col\" class=\"name\">Reference</th><th scope=\"col\">Rays per pixel</th>"
         "<th scope=\"col\">Noise floor, RMSE</th></tr></thead>\n<tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string figure_cell(const std::string& text) {
  return "<td>" + escape_html(text) + "</td>";
}

// Returns one row for each technique; empty if nothing is known of any.
std::string technique_table(const ReportContent& content) {
  const std::vector<TechniqueRow> rows = technique_rows(content.results, content.facts);
  if (rows.empty()) return {};
  const auto head = [](const std::string& text, const std::string& unit) {
    return "<th scope=\"col\">" + escape_html(text) + "<span class=\"unit\">" + escape_html(unit) +
           "</span></th>";
  };
  std::string heads = "<th scope=\"col\" class=\"name\">Technique</th>";
  for (const double light : light_sizes(content.results))
    heads += head("Penumbra RMSE", fmt::format("{}°", light));
  heads += head("Fetches per pixel", fmt::format("{}°", middle_light(content.results))) + head("Maps", "MiB");
  const bool advice = has_advice(rows);
  std::string body;
  for (const TechniqueRow& row : rows) {
    body += "<tr><th scope=\"row\" class=\"name\">" +
            escape_html(row.choice.title.empty() ? row.choice.label : row.choice.title) + "</th>";
    for (const std::optional<Estimate>& rmse : row.rmse_penumbra) body += figure_cell(figure_text(rmse));
    body += figure_cell(fetches_text(row.fetches)) + figure_cell(fmt::format("{:.1f}", row.map_mebibytes));
    if (advice)
      body += "<td class=\"name\">" + escape_html(row.use_when) + "</td><td class=\"name\">" +
              escape_html(row.not_when) + "</td>";
    body += "</tr>\n";
  }
  if (advice)
    heads +=
        "<th scope=\"col\" class=\"name\">Use it when</th><th scope=\"col\" class=\"name\">Not when</th>";
  return "<p>" + escape_html(rows_explained(rows)) +
         "</p>\n<div class=\"scroll\" role=\"region\" aria-label=\"One row for each technique\" "
         "tabindex=\"0\">"
         "<table class=\"plain\">\n<thead><tr>" +
         heads + "</tr></thead>\n<tbody>\n" + body + "</tbody></table></div>\n";
}

std::vector<Section> sections(const ReportContent& content) {
  const Results& results = content.results;
  std::vector<Section> all = {
      {"cost", "Cost against error", charts_html(content.charts)},
      {"figures", "All figures", record_table(results, content.pictures)},
      {"techniques", "One row for each technique", technique_table(content)},
      {"pictures", "Pictures", pictures_html(results, content.pictures)},
      {"words", "What each figure means", std::string(kMetricWords)},
      {"references", "What the errors are measured against",
       std::string(kReferenceWords) + references(results)},
      {"machine", "How it was measured", machine(results)},
  };
  std::erase_if(all, [](const Section& section) { return section.body.empty(); });
  return all;
}

}  // namespace

std::string render_report(const ReportContent& content) {
  const std::vector<Section> parts = sections(content);
  std::string html =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
      "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>Penumbra: measured soft shadows</title>\n<style>";
  html += kReportStyle;
  html +=
      "</style>\n<script>document.documentElement.classList.add(\"scripted\");</script>\n</head>\n<body>\n";
  html += "<header>\n" + introduction(content.results) + headline_cards(content.results) +
          findings(content.results) + navigation(parts) + "</header>\n<main>\n";
  for (const Section& part : parts) html += section_html(part);
  html += "</main>\n<div id=\"tooltip\" role=\"tooltip\" hidden></div>\n<script>\n";
  html += kReportScript;
  return html + "</script>\n</body>\n</html>\n";
}

}  // namespace penumbra::study
