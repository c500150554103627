#include <nlohmann/json.hpp>

#include "input/json_table.h"
#include "parameters/settings_input.h"
#include "study/results.h"

namespace penumbra::study {
namespace {

using Json = nlohmann::ordered_json;  // keeps the order in which a person wants to read the keys

Json json_of(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const std::optional<ErrorShare>& share) {
  return share ? Json{{"mean", share->mean}, {"rmse", share->rmse}} : Json(nullptr);
}

Json json_of(const std::optional<Interval>& interval) {
  if (!interval) return nullptr;
  return {{"low", interval->low}, {"high", interval->high}, {"standard_error", interval->standard_error}};
}

Json json_of(const MetricIntervals& intervals) {
  return {{"rmse_penumbra", json_of(intervals.rmse_penumbra)},
          {"rmse_all", json_of(intervals.rmse_all)},
          {"leak_rate", json_of(intervals.leak_rate)},
          {"false_shadow_rate", json_of(intervals.false_shadow_rate)},
          {"fetches_mean", json_of(intervals.fetches_mean)}};
}

Json json_of(const RunSettings& settings) {
  Json json{{"depth_bias", settings.depth_bias},
            {"normal_bias", settings.normal_bias},
            {"constant_bias", settings.constant_bias},
            {"slope_bias", settings.slope_bias},
            {"soft_quality", parameters::name_of(settings.soft_quality)},
            {"light_scale", settings.light_scale},
            {"splits", settings.splits},
            {"reversed_z", settings.reversed_z}};
  const scene::CascadeChoices& cascades = settings.cascade_choices;
  if (cascades.light_fit != parameters::LightFit::sphere)
    json["light_fit"] = parameters::name_of(cascades.light_fit);
  if (cascades.blend.border > 0.0) {
    json["cascade_border"] = cascades.blend.border;
    json["cascade_blend"] = cascades.blend.mixed ? "mix" : "dither";
  }
  if (cascades.map_age_degrees > 0.0) json["map_age_degrees"] = cascades.map_age_degrees;
  return json;
}

Json json_of(const glm::dvec3& vector) {
  return {vector.x, vector.y, vector.z};
}

Json json_of(const MeasuredFrame& frame) {
  const parameters::Camera& camera = frame.camera;
  Json json{{"scene", frame.scene},
            {"light_degrees", frame.light_degrees},
            {"sun_direction", json_of(frame.sun_direction)},
            {"width", frame.width},
            {"height", frame.height},
            {"shadow_distance_metres", frame.shadow_distance_metres},
            {"camera",
             {{"position", json_of(camera.position)},
              {"forward", json_of(camera.forward)},
              {"up", json_of(camera.up)},
              {"fov_y_degrees", camera.fov_y_degrees},
              {"near", camera.near_plane},
              {"far", camera.far_plane}}}};
  if (frame.source_radius_metres) json["source_radius_metres"] = *frame.source_radius_metres;
  return json;
}

Json json_of(const PackageNote& package) {
  return {{"name", package.name}, {"version", package.version ? Json(*package.version) : Json(nullptr)}};
}

Json json_of(const EarlierRun& run) {
  Json json = {{"techniques", run.techniques},
               {"library_version", run.library_version},
               {"commit", run.commit ? Json(*run.commit) : Json(nullptr)},
               {"packages", Json::array()},
               {"command", run.command}};
  for (const PackageNote& package : run.packages) json["packages"].push_back(json_of(package));
  return json;
}

void add_metrics(Json& record, const Metrics& metrics) {
  record["pixels"] = metrics.pixels;
  record["penumbra_pixels"] = metrics.penumbra_pixels;
  record["seeds"] = metrics.seeds;
  record["invalid"] = metrics.invalid;
  record["rmse_penumbra"] = json_of(metrics.rmse_penumbra);
  record["rmse_all"] = json_of(metrics.rmse_all);
  record["bias"] = json_of(metrics.bias);
  record["variance"] = json_of(metrics.variance);
  record["p99"] = json_of(metrics.p99);
  record["max_error"] = json_of(metrics.max_error);
  record["leak_rate"] = json_of(metrics.leak_rate);
  record["false_shadow_rate"] = json_of(metrics.false_shadow_rate);
  record["fetches_mean"] = json_of(metrics.fetches_mean);
  record["fetches_p95"] = json_of(metrics.fetches_p95);
  record["fetches_penumbra_mean"] = json_of(metrics.fetches_penumbra_mean);
  record["preprocess_fetches_per_pixel"] = metrics.preprocess_fetches_per_pixel;
  if (metrics.mask) {
    record["mask"] = {{"pixels_saved", metrics.mask->pixels_saved},
                      {"penumbra_pixels_missed", json_of(metrics.mask->penumbra_pixels_missed)}};
  }
  record["error_split"] = {{"map", json_of(metrics.split.map)},
                           {"algorithm", json_of(metrics.split.algorithm)},
                           {"sampling", json_of(metrics.split.sampling)}};
  record["intervals"] = json_of(metrics.intervals);
}

Json json_of(const std::map<std::string, std::vector<double>>& parameters) {
  Json json = Json::object();
  for (const auto& [name, values] : parameters) json[name] = values;
  return json;
}

Json json_of(const CascadeRecord& cascade) {
  Json json{{"pixels", cascade.pixels},
            {"penumbra_pixels", cascade.penumbra_pixels},
            {"rmse_penumbra", json_of(cascade.rmse_penumbra)},
            {"bias", json_of(cascade.bias)},
            {"leak_rate", json_of(cascade.leak_rate)},
            {"false_shadow_rate", json_of(cascade.false_shadow_rate)},
            {"fetches_mean", json_of(cascade.fetches_mean)},
            {"intervals", json_of(cascade.intervals)}};
  if (!cascade.technique.empty()) {
    json["technique"] = cascade.technique;
    json["parameters"] = json_of(cascade.parameters);
  }
  if (cascade.texel_size_metres) json["texel_size_metres"] = *cascade.texel_size_metres;
  return json;
}

Json json_of(const DistanceRecord& ring) {
  return {{"from_metres", ring.from_metres},
          {"to_metres", ring.to_metres},
          {"pixels", ring.pixels},
          {"penumbra_pixels", ring.penumbra_pixels},
          {"rmse_penumbra", json_of(ring.rmse_penumbra)},
          {"rmse_all", json_of(ring.rmse_all)},
          {"bias", json_of(ring.bias)},
          {"leak_rate", json_of(ring.leak_rate)},
          {"false_shadow_rate", json_of(ring.false_shadow_rate)},
          {"fetches_mean", json_of(ring.fetches_mean)}};
}

Json json_of(const Seam& seam) {
  return {{"pairs", seam.pairs}, {"step", json_of(seam.step)}, {"elsewhere", json_of(seam.elsewhere)}};
}

Json json_of(const PassRecord& pass) {
  Json json{{"pass", pass.pass},
            {"runs", pass.runs},
            {"fetches_per_pixel", pass.fetches_per_pixel},
            {"texels_written_per_pixel", pass.texels_written_per_pixel}};
  if (pass.operations_per_pixel) json["operations_per_pixel"] = *pass.operations_per_pixel;
  if (pass.invocations_per_pixel) json["invocations_per_pixel"] = *pass.invocations_per_pixel;
  if (pass.time_ms_median) json["time_ms_median"] = *pass.time_ms_median;
  if (pass.fetches_per_cascade) json["fetches_per_cascade"] = *pass.fetches_per_cascade;
  return json;
}

Json json_of(const Record& record, std::string_view kind) {
  Json json;
  json["scene"] = record.scene;
  json["technique"] = record.technique;
  json["title"] = record.title;
  json["parameters"] = json_of(record.parameters);
  json["light_degrees"] = record.light_degrees;
  json["map_size"] = record.map_size;
  json["map_format"] = record.map_format;
  json["cascades"] = record.cascades;
  json["settings"] = json_of(record.settings);
  json["device"] = record.device;
  add_metrics(json, record.metrics);
  if (!record.per_cascade.empty()) {
    json["per_cascade"] = Json::array();
    for (const CascadeRecord& cascade : record.per_cascade) json["per_cascade"].push_back(json_of(cascade));
  }
  if (!record.by_distance.empty()) {
    json["by_distance"] = Json::array();
    for (const DistanceRecord& ring : record.by_distance) json["by_distance"].push_back(json_of(ring));
  }
  if (record.operations_per_pixel) json["operations_per_pixel"] = *record.operations_per_pixel;
  if (record.baked_mebibytes) json["baked_mebibytes"] = *record.baked_mebibytes;
  if (!record.passes.empty()) {
    json["passes"] = Json::array();
    for (const PassRecord& pass : record.passes) json["passes"].push_back(json_of(pass));
  }
  if (record.shimmer) {
    json["shimmer"] = {{"frames", record.shimmer->frames},
                       {"static_noise", json_of(record.shimmer->static_noise)},
                       {"per_frame_noise", json_of(record.shimmer->per_frame_noise)}};
  }
  if (record.seam) json["seam"] = json_of(*record.seam);
  if (record.far_seam) json["far_seam"] = json_of(*record.far_seam);
  json["time_kind"] = kind;
  json["time_ms_median"] = record.time ? Json(record.time->median_ms) : Json(nullptr);
  json["time_ms_spread"] = record.time ? Json(record.time->spread_ms) : Json(nullptr);
  json["reference"] = {{"kind", record.reference.kind},
                       {"samples", record.reference.samples},
                       {"noise_floor", record.reference.noise_floor}};
  return json;
}

// Indented JSON whose short objects and arrays stand on one line.
class LineWriter {
 public:
  std::string text_of(const Json& json) {
    write(json, 0);
    return text_ + "\n";
  }

 private:
  static constexpr std::size_t kLineEnd = 110;

  // Names come from files and devices: an invalid UTF-8 byte becomes U+FFFD instead of an exception.
  static std::string leaf(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  static std::string one_line(const Json& json) {
    if (!json.is_structured()) return leaf(json);
    std::string text;
    for (const auto& [key, value] : json.items()) {
      text += text.empty() ? "" : ", ";
      text += (json.is_object() ? leaf(key) + ": " : "") + one_line(value);
    }
    return json.is_object() ? "{" + text + "}" : "[" + text + "]";
  }

  void write(const Json& json, std::size_t indent) {
    if (!json.is_structured() || json.empty()) {
      text_ += one_line(json);
      return;
    }
    if (indent > 0 && (json.is_array() || indent > 4)) {
      const std::string line = one_line(json);
      if (indent + line.size() <= kLineEnd) {
        text_ += line;
        return;
      }
    }
    const std::string margin(indent + 2, ' ');
    text_ += json.is_object() ? "{" : "[";
    std::string comma;
    for (const auto& [key, value] : json.items()) {
      text_ += comma + "\n" + margin + (json.is_object() ? leaf(key) + ": " : "");
      write(value, indent + 2);
      comma = ",";
    }
    text_ += "\n" + std::string(indent, ' ') + (json.is_object() ? "}" : "]");
  }

  std::string text_;
};

}  // namespace

namespace {

Json json_of(const Results& results) {
  Json json;
  json["schema_version"] = kResultsSchemaVersion;
  json["library_version"] = results.library_version;
  json["commit"] = results.commit ? Json(*results.commit) : Json(nullptr);
  json["packages"] = Json::array();
  for (const PackageNote& package : results.packages) json["packages"].push_back(json_of(package));
  json["command"] = results.command;
  json["hardware"] = results.hardware;
  json["device"] = results.device;
  json["driver"] = results.driver;
  json["is_software"] = results.is_software;
  if (results.front_end) json["front_end"] = *results.front_end;
  for (const EarlierRun& run : results.earlier) json["earlier"].push_back(json_of(run));
  json["frames"] = Json::array();
  for (const MeasuredFrame& frame : results.frames) json["frames"].push_back(json_of(frame));
  json["records"] = Json::array();
  for (const Record& record : results.records) json["records"].push_back(json_of(record, time_kind(results)));
  return json;
}

}  // namespace

std::string to_json(const Results& results) {
  return LineWriter().text_of(json_of(results));
}

std::string to_table(const Results& results) {
  const auto digits = [](const std::string& path) {
    for (const char* setting : {"parameters/", "light_degrees", "settings/"})
      if (path.starts_with(setting)) return kAllDigits;
    // Pages show four digits at most; means of several figures, and differences, keep their last one.
    return path.find("intervals/") == std::string::npos ? 7 : 5;
  };
  return json_table(json_of(results).dump(-1, ' ', false, Json::error_handler_t::replace), "records", digits);
}

}  // namespace penumbra::study
