#include <nlohmann/json.hpp>

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
}

Json json_of(const Record& record, std::string_view kind) {
  Json json;
  json["scene"] = record.scene;
  json["technique"] = record.technique;
  json["title"] = record.title;
  json["parameters"] = Json::object();
  for (const auto& [name, values] : record.parameters) json["parameters"][name] = values;
  json["light_degrees"] = record.light_degrees;
  json["map_size"] = record.map_size;
  json["map_format"] = record.map_format;
  json["cascades"] = record.cascades;
  json["device"] = record.device;
  add_metrics(json, record.metrics);
  if (record.shimmer) {
    json["shimmer"] = {{"frames", record.shimmer->frames},
                       {"static_noise", json_of(record.shimmer->static_noise)},
                       {"per_frame_noise", json_of(record.shimmer->per_frame_noise)}};
  }
  json["time_kind"] = kind;
  json["time_ms_median"] = record.time ? Json(record.time->median_ms) : Json(nullptr);
  json["time_ms_spread"] = record.time ? Json(record.time->spread_ms) : Json(nullptr);
  json["reference"] = {{"kind", record.reference.kind},
                       {"samples", record.reference.samples},
                       {"noise_floor", record.reference.noise_floor}};
  return json;
}

}  // namespace

std::string to_json(const Results& results) {
  Json json;
  json["schema_version"] = kResultsSchemaVersion;
  json["library_version"] = results.library_version;
  json["command"] = results.command;
  json["hardware"] = results.hardware;
  json["device"] = results.device;
  json["driver"] = results.driver;
  json["is_software"] = results.is_software;
  json["records"] = Json::array();
  for (const Record& record : results.records) json["records"].push_back(json_of(record, time_kind(results)));
  // Names come from files and devices: a byte that is no UTF-8 becomes U+FFFD instead of an exception.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace penumbra::study
