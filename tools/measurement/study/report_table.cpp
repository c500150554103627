#include "study/report_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "parameters/settings_input.h"
#include "study/html_text.h"
#include "study/interval.h"
#include "study/summary.h"

namespace penumbra::study {
namespace {

using Json = nlohmann::ordered_json;

// Figures get a minus sign, not a hyphen.
std::string with_minus(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = i == 0 || text[i - 1] == ' ';
    const bool figure = i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9';
    result += text[i] == '-' && begins && figure ? std::string("−") : std::string(1, text[i]);
  }
  return result;
}

// Terms and their definitions, under one heading. Absent figures are not added.
class Group {
 public:
  explicit Group(std::string title) : title_(std::move(title)) {}

  void add_text(const std::string& term, const std::string& text) {
    entries_.push_back({term, with_minus(text)});
  }

  void add(const char* term, const std::optional<double>& value, const char* format, double scale = 1.0) {
    if (value) add_text(term, fmt::format(fmt::runtime(format), *value * scale));
  }

  void add_to(Json& groups) const {
    if (!entries_.empty()) groups.push_back({{"title", title_}, {"entries", entries_}});
  }

 private:
  std::string title_;
  Json entries_ = Json::array();
};

std::string yes_or_no(bool yes) {
  return yes ? "yes" : "no";
}

// Lists the parameters, and the settings at which the technique was measured.
void add_about(Json& groups, const Record& record) {
  Group group(record.title.empty() ? record.technique : record.title);
  group.add_text("name", record.technique);
  for (const auto& [name, values] : record.parameters) {
    group.add_text(name, fmt::format("{}", fmt::join(values, " ")));
  }
  const RunSettings& settings = record.settings;
  group.add_text("shadow map",
                 fmt::format("{} texels wide, {}, {} cascade{}", record.map_size, record.map_format,
                             record.cascades, record.cascades == 1 ? "" : "s"));
  if (!settings.splits.empty())
    group.add_text("splits", fmt::format("{:.3g}", fmt::join(settings.splits, ", ")));
  const scene::CascadeChoices& cascades = settings.cascade_choices;
  if (cascades.light_fit != parameters::LightFit::sphere)
    group.add_text("cascades fitted to", std::string(parameters::name_of(cascades.light_fit)));
  if (cascades.blend.border > 0.0)
    group.add_text("border between cascades",
                   fmt::format("{:g} of the split sphere's radius, {}", cascades.blend.border,
                               cascades.blend.mixed ? "mixed" : "dithered"));
  if (cascades.map_age_degrees > 0.0)
    group.add_text("sun's movement since the map was drawn",
                   fmt::format("{:g} degrees", cascades.map_age_degrees));
  group.add_text("depth bias", fmt::format("{}", settings.depth_bias));
  group.add_text("normal bias", fmt::format("{}", settings.normal_bias));
  if (settings.slope_bias != 0.0) group.add_text("slope bias", fmt::format("{}", settings.slope_bias));
  group.add_text("soft quality", std::string(parameters::name_of(settings.soft_quality)));
  if (settings.light_scale != 1.0) {
    group.add_text("light's diameter", fmt::format("multiplied by {}", settings.light_scale));
  }
  group.add_text("reversed depth", yes_or_no(settings.reversed_z));
  group.add_to(groups);
}

void add_intervals(Json& groups, const MetricIntervals& intervals) {
  Group group("95 % intervals");
  const auto add = [&group](const char* term, const std::optional<Interval>& interval, double scale) {
    if (!interval || interval->low == interval->high) return;  // a constant has no interval
    group.add_text(term, fmt::format("{:.4g} to {:.4g}", interval->low * scale, interval->high * scale));
  };
  add("RMSE in penumbra", intervals.rmse_penumbra, 1.0);
  add("RMSE of all pixels", intervals.rmse_all, 1.0);
  add("leaks, %", intervals.leak_rate, 100.0);
  add("false shadow, %", intervals.false_shadow_rate, 100.0);
  add("fetches of the shadow function", intervals.fetches_mean, 1.0);
  group.add_to(groups);
}

void add_errors(Json& groups, const Metrics& metrics) {
  Group group("Error");
  group.add("bias", metrics.bias, "{:+.4f}");
  group.add("variance over seeds", metrics.variance, "{:.5f}");
  group.add("99th percentile", metrics.p99, "{:.3f}");
  group.add("largest", metrics.max_error, "{:.3f}");
  group.add_to(groups);
}

void add_split(Json& groups, const ErrorSplit& split) {
  Group group("Where the error comes from");
  const auto add = [&group](const char* term, const std::optional<ErrorShare>& share) {
    if (share) group.add_text(term, fmt::format("mean {:+.4f}, RMSE {:.4f}", share->mean, share->rmse));
  };
  add("map", split.map);
  add("algorithm", split.algorithm);
  add("sampling", split.sampling);
  group.add_to(groups);
}

void add_fetches(Json& groups, const Record& record) {
  const Metrics& metrics = record.metrics;
  Group group("Fetches and operations per pixel");
  group.add("of the shadow function", metrics.fetches_mean, "{:.1f}");
  group.add("95th percentile", metrics.fetches_p95, "{:.0f}");
  group.add("in penumbra", metrics.fetches_penumbra_mean, "{:.1f}");
  if (metrics.preprocess_fetches_per_pixel > 0.0) {
    group.add("of passes at lower resolution", metrics.preprocess_fetches_per_pixel, "{:.2f}");
  }
  group.add("scalar operations of all passes", record.operations_per_pixel, "{:.0f}");
  if (metrics.mask) {
    group.add("pixels skipped by the mask, %", metrics.mask->pixels_saved, "{:.1f}", 100.0);
    group.add("penumbra pixels missed by the mask, %", metrics.mask->penumbra_pixels_missed, "{:.2f}", 100.0);
  }
  group.add_to(groups);
}

void add_passes(Json& groups, const Record& record) {
  Group group("Passes, per pixel of the picture");
  for (const PassRecord& pass : record.passes) {
    std::string text = fmt::format("{:.2f} fetches", pass.fetches_per_pixel);
    const auto add = [&text](const char* format, const std::optional<double>& value) {
      if (value) text += fmt::format(fmt::runtime(format), *value);
    };
    add(", {:.0f} operations", pass.operations_per_pixel);
    add(", {:.1f} bytes read", pass.bytes_read_per_pixel);
    add(", {:.1f} written", pass.bytes_written_per_pixel);
    add("; draws: {:.0f}", pass.draws);
    add("; dispatches: {:.0f}", pass.dispatches);
    add(", groups: {:.0f}", pass.groups);
    add(" with {:.3g} barriers each", pass.barriers_per_group);
    group.add_text(pass.pass, text);
  }
  group.add_to(groups);
}

void add_cascades(Json& groups, const Record& record) {
  Group group("By the cascade that pixels read");
  for (std::size_t i = 0; i < record.per_cascade.size(); ++i) {
    const CascadeRecord& cascade = record.per_cascade[i];
    std::string text = fmt::format("{} penumbra pixels", cascade.penumbra_pixels);
    const auto add = [&text](const char* term, const std::optional<double>& value, const char* format,
                             double scale = 1.0) {
      if (value) text += fmt::format(", {} ", term) + fmt::format(fmt::runtime(format), *value * scale);
    };
    add("RMSE", cascade.rmse_penumbra, "{:.4f}");
    if (cascade.intervals.rmse_penumbra)
      text += fmt::format(" ({:.2g} to {:.2g})", cascade.intervals.rmse_penumbra->low,
                          cascade.intervals.rmse_penumbra->high);
    add("leaks", cascade.leak_rate, "{:.2f} %", 100.0);
    add("false shadow", cascade.false_shadow_rate, "{:.2f} %", 100.0);
    add("fetches", cascade.fetches_mean, "{:.1f}");
    if (!cascade.technique.empty() && cascade.technique != record.technique)
      text += ", by " + cascade.technique;
    for (const auto& [name, values] : cascade.parameters)
      text += fmt::format(", {} {}", name, fmt::join(values, " "));
    group.add_text(fmt::format("cascade {}", i), text);
  }
  group.add_to(groups);
}

void add_motion(Json& groups, const Record& record) {
  Group group("Shimmer");
  if (!record.shimmer) return;
  group.add("static noise", record.shimmer->static_noise, "{:.4f}");
  group.add("new noise per frame", record.shimmer->per_frame_noise, "{:.4f}");
  group.add_to(groups);
}

void add_frame(Group& group, const Results& results, const Record& record) {
  const auto found =
      std::find_if(results.frames.begin(), results.frames.end(), [&record](const MeasuredFrame& frame) {
        return frame.scene == record.scene && frame.light_degrees == record.light_degrees;
      });
  if (found == results.frames.end()) return;
  const auto vector = [](const glm::dvec3& v) {
    return fmt::format("{:.2f}, {:.2f}, {:.2f}", v.x, v.y, v.z);
  };
  group.add_text("picture", fmt::format("{} × {} pixels", found->width, found->height));
  group.add_text("shadow distance", fmt::format("{} m", found->shadow_distance_metres));
  group.add_text("sun's direction", vector(found->sun_direction));
  group.add_text("camera position", vector(found->camera.position));
  group.add_text("camera direction", vector(found->camera.forward));
}

void add_provenance(Json& groups, const Results& results, const Record& record) {
  const Metrics& metrics = record.metrics;
  Group group("Measured on");
  add_frame(group, results, record);
  group.add_text("pixels with a surface", fmt::format("{}", metrics.pixels));
  group.add_text("noise seeds", fmt::format("{}", metrics.seeds));
  if (metrics.invalid > 0) group.add_text("invalid results", fmt::format("{}", metrics.invalid));
  if (record.time) {
    group.add_text(
        std::string(time_kind(results)),
        fmt::format("{:.2f} ms, spread {:.2f} ms", record.time->median_ms, record.time->spread_ms));
  }
  group.add_text("reference", fmt::format("{}, {} rays per pixel, noise floor {:.4f}", record.reference.kind,
                                          record.reference.samples, record.reference.noise_floor));
  group.add_to(groups);
}

// Returns groups of terms and their texts, {"title": ..., "entries": [[term, text], ...]}; figures that were
// not measured are left out. The first group names the technique and its parameters.
Json record_detail(const Results& results, const Record& record) {
  Json groups = Json::array();
  add_about(groups, record);
  add_intervals(groups, record.metrics.intervals);
  add_errors(groups, record.metrics);
  add_split(groups, record.metrics.split);
  add_fetches(groups, record);
  add_passes(groups, record);
  add_cascades(groups, record);
  add_motion(groups, record);
  add_provenance(groups, results, record);
  return groups;
}

// Returns the same of a mean over scenes. `any` is one of its records, which share parameters and settings.
Json mean_detail(const Results& results, const Record& any) {
  Json groups = Json::array();
  add_about(groups, any);
  const LightSample sample = sample_of(results, any.light_degrees);
  Group group("Mean of");
  group.add_text("scenes", fmt::format("{}", sample.scenes));
  group.add_text("penumbra pixels, all scenes", fmt::format("{}", sample.penumbra_pixels));
  group.add_text("penumbra pixels, fewest in a scene", fmt::format("{}", sample.smallest_penumbra_pixels));
  group.add_to(groups);
  return groups;
}

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
