#include "study/report_detail.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "parameters/settings_input.h"
#include "study/summary.h"

namespace penumbra::study {

using Json = nlohmann::ordered_json;

namespace {

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
  if (found->source_radius_metres)
    group.add_text("spot light's source radius", fmt::format("{:.4g} m", *found->source_radius_metres));
  group.add_text(found->source_radius_metres ? "spot light's axis" : "sun's direction",
                 vector(found->sun_direction));
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

}  // namespace

Json record_detail(const Results& results, const Record& record) {
  Json groups = Json::array();
  add_about(groups, record);
  add_intervals(groups, record.metrics.intervals);
  add_errors(groups, record.metrics);
  add_split(groups, record.metrics.split);
  add_fetches(groups, record);
  add_cascades(groups, record);
  add_motion(groups, record);
  add_provenance(groups, results, record);
  return groups;
}

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

}  // namespace penumbra::study
