#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "input/input_error.h"
#include "input/json_table.h"
#include "input/located_json.h"
#include "input/text_file.h"
#include "parameters/settings_input.h"
#include "study/results.h"

namespace penumbra::study {
namespace {

using Pointer = LocatedJson::Pointer;

constexpr double kAnything = 1e300;

// An object of results.json, where every key must be there; figures may be null where the schema says so.
class StrictObject {
 public:
  StrictObject(const LocatedJson& document, const Pointer& at)
      : document_(document), at_(at), object_(document, at) {}

  std::string text(const std::string& key) {
    require(key);
    return object_.text(key, {});
  }

  double number(const std::string& key, double least, double most) {
    require(key);
    const double value = object_.number(key, 0.0);
    if (value < least || value > most) {
      object_.fail(key, fmt::format("'{}' must be between {} and {}, found {}", key, least, most, value));
    }
    return value;
  }

  std::size_t count(const std::string& key) {
    require(key);
    const int value = object_.integer(key, 0);
    if (value < 0) object_.fail(key, fmt::format("'{}' must not be negative, found {}", key, value));
    return static_cast<std::size_t>(value);
  }

  parameters::SoftQuality soft_quality(const std::string& key) {
    require(key);
    return parameters::read_soft_quality(object_, key, {});
  }

  bool boolean(const std::string& key) {
    require(key);
    return object_.boolean(key, false);
  }

  std::optional<double> figure(const std::string& key, double least, double most) {
    return is_null(key) ? std::nullopt : std::optional(number(key, least, most));
  }

  bool is_null(const std::string& key) {
    require(key);
    return document_.at(at_ / key).is_null();
  }

  std::vector<std::string> texts(const std::string& key) {
    require(key);
    return object_.texts(key);
  }

  StrictObject object(const std::string& key) {
    require(key);
    return {document_, at_ / key};
  }

  std::size_t array_size(const std::string& key) {
    require(key);
    if (!document_.at(at_ / key).is_array()) object_.fail(key, "'" + key + "' must be an array");
    return document_.at(at_ / key).size();
  }

  std::vector<StrictObject> objects(const std::string& key) {
    std::vector<StrictObject> result;
    for (std::size_t i = 0; i < array_size(key); ++i) result.emplace_back(document_, at_ / key / i);
    return result;
  }

  std::vector<double> numbers(const std::string& key, std::size_t count) {
    require(key);
    return object_.numbers(key, count);
  }

  glm::dvec3 vector(const std::string& key) {
    const std::vector<double> found = numbers(key, 3);
    return {found[0], found[1], found[2]};
  }

  std::map<std::string, std::vector<double>> number_lists(const std::string& key) {
    require(key);
    JsonObject lists(document_, at_ / key);
    std::map<std::string, std::vector<double>> result;
    for (const std::string& name : lists.keys()) {
      const nlohmann::json& list = document_.at(at_ / key / name);
      result[name] = lists.numbers(name, list.is_array() ? list.size() : 1);
    }
    return result;
  }

  bool has(const std::string& key) { return object_.has(key); }  // used for the keys that may be missing

  void finish() const { object_.finish(); }
  [[noreturn]] void fail(const std::string& key, const std::string& problem,
                         const std::string& way_out = {}) const {
    object_.fail(key, problem, way_out);
  }

 private:
  void require(const std::string& key) {
    if (!object_.has(key)) object_.fail(key, "the key '" + key + "' is missing");
  }

  const LocatedJson& document_;
  Pointer at_;
  JsonObject object_;
};

std::optional<ErrorShare> read_share(StrictObject& split, const std::string& key) {
  if (split.is_null(key)) return std::nullopt;
  StrictObject share = split.object(key);
  const ErrorShare result{share.number("mean", -1.0, 1.0), share.number("rmse", 0.0, 1.0)};
  share.finish();
  return result;
}

std::optional<Interval> read_interval(StrictObject& intervals, const std::string& key, double most) {
  if (intervals.is_null(key)) return std::nullopt;
  StrictObject interval = intervals.object(key);
  const Interval result{interval.number("low", 0.0, most), interval.number("high", 0.0, most),
                        interval.number("standard_error", 0.0, kAnything)};
  if (result.low > result.high) interval.fail("high", "must not lie below 'low'");
  interval.finish();
  return result;
}

MetricIntervals read_intervals(StrictObject intervals) {
  MetricIntervals result;
  result.rmse_penumbra = read_interval(intervals, "rmse_penumbra", 1.0);
  result.rmse_all = read_interval(intervals, "rmse_all", 1.0);
  result.leak_rate = read_interval(intervals, "leak_rate", 1.0);
  result.false_shadow_rate = read_interval(intervals, "false_shadow_rate", 1.0);
  result.fetches_mean = read_interval(intervals, "fetches_mean", kAnything);
  intervals.finish();
  return result;
}

Metrics read_metrics(StrictObject& record) {
  Metrics metrics;
  metrics.pixels = record.count("pixels");
  metrics.penumbra_pixels = record.count("penumbra_pixels");
  metrics.seeds = record.count("seeds");
  metrics.invalid = record.count("invalid");
  metrics.rmse_penumbra = record.figure("rmse_penumbra", 0.0, 1.0);
  metrics.rmse_all = record.figure("rmse_all", 0.0, 1.0);
  metrics.bias = record.figure("bias", -1.0, 1.0);
  metrics.variance = record.figure("variance", 0.0, 1.0);
  metrics.p99 = record.figure("p99", 0.0, 1.0);
  metrics.max_error = record.figure("max_error", 0.0, 1.0);
  metrics.leak_rate = record.figure("leak_rate", 0.0, 1.0);
  metrics.false_shadow_rate = record.figure("false_shadow_rate", 0.0, 1.0);
  metrics.fetches_mean = record.figure("fetches_mean", 0.0, kAnything);
  metrics.fetches_p95 = record.figure("fetches_p95", 0.0, kAnything);
  metrics.fetches_penumbra_mean = record.figure("fetches_penumbra_mean", 0.0, kAnything);
  metrics.preprocess_fetches_per_pixel = record.number("preprocess_fetches_per_pixel", 0.0, kAnything);
  if (record.has("mask")) {
    StrictObject mask = record.object("mask");
    metrics.mask =
        MaskShares{mask.number("pixels_saved", 0.0, 1.0), mask.figure("penumbra_pixels_missed", 0.0, 1.0)};
    mask.finish();
  }
  StrictObject split = record.object("error_split");
  metrics.split = {read_share(split, "map"), read_share(split, "algorithm"), read_share(split, "sampling")};
  split.finish();
  metrics.intervals = read_intervals(record.object("intervals"));
  return metrics;
}

std::optional<Timing> read_time(StrictObject& record, std::string_view kind) {
  if (record.text("time_kind") != kind) {
    record.fail("time_kind", fmt::format("must be \"{}\", as 'is_software' of the file says", kind));
  }
  const std::optional<double> median = record.figure("time_ms_median", 0.0, kAnything);
  const std::optional<double> spread = record.figure("time_ms_spread", 0.0, kAnything);
  if (median.has_value() != spread.has_value()) {
    record.fail("time_ms_spread", "must be null exactly when 'time_ms_median' is");
  }
  return median ? std::optional(Timing{*median, *spread}) : std::nullopt;
}

std::optional<Seam> read_seam(StrictObject& record, const std::string& key) {
  if (!record.has(key)) return std::nullopt;
  StrictObject seam = record.object(key);
  const Seam result{seam.count("pairs"), seam.figure("step", 0.0, 2.0), seam.figure("elsewhere", 0.0, 2.0)};
  seam.finish();
  return result;
}

std::optional<Shimmer> read_shimmer(StrictObject& record) {
  if (!record.has("shimmer")) return std::nullopt;
  StrictObject shimmer = record.object("shimmer");
  const Shimmer result{static_cast<int>(shimmer.count("frames")), shimmer.figure("static_noise", 0.0, 1.0),
                       shimmer.figure("per_frame_noise", 0.0, 1.0)};
  shimmer.finish();
  return result;
}

std::vector<CascadeRecord> read_cascades(StrictObject& record, int cascades) {
  std::vector<CascadeRecord> result;
  if (!record.has("per_cascade")) return result;
  for (StrictObject& cascade : record.objects("per_cascade")) {
    CascadeRecord& figures = result.emplace_back();
    figures.pixels = cascade.count("pixels");
    figures.penumbra_pixels = cascade.count("penumbra_pixels");
    figures.rmse_penumbra = cascade.figure("rmse_penumbra", 0.0, 1.0);
    figures.bias = cascade.figure("bias", -1.0, 1.0);
    figures.leak_rate = cascade.figure("leak_rate", 0.0, 1.0);
    figures.false_shadow_rate = cascade.figure("false_shadow_rate", 0.0, 1.0);
    figures.fetches_mean = cascade.figure("fetches_mean", 0.0, kAnything);
    figures.intervals = read_intervals(cascade.object("intervals"));
    if (cascade.has("technique")) {
      figures.technique = cascade.text("technique");
      figures.parameters = cascade.number_lists("parameters");
    }
    if (cascade.has("texel_size_metres"))
      figures.texel_size_metres = cascade.number("texel_size_metres", 0.0, kAnything);
    cascade.finish();
  }
  if (result.size() != static_cast<std::size_t>(cascades))
    record.fail("per_cascade",
                fmt::format("'per_cascade' must have one entry for each of the {} cascades, not {}", cascades,
                            result.size()));
  return result;
}

std::vector<DistanceRecord> read_distances(StrictObject& record) {
  std::vector<DistanceRecord> result;
  if (!record.has("by_distance")) return result;
  for (StrictObject& ring : record.objects("by_distance")) {
    DistanceRecord& figures = result.emplace_back();
    figures.from_metres = ring.number("from_metres", 0.0, kAnything);
    figures.to_metres = ring.number("to_metres", 0.0, kAnything);
    if (figures.to_metres <= figures.from_metres) ring.fail("to_metres", "must lie above 'from_metres'");
    figures.pixels = ring.count("pixels");
    figures.penumbra_pixels = ring.count("penumbra_pixels");
    figures.rmse_penumbra = ring.figure("rmse_penumbra", 0.0, 1.0);
    figures.rmse_all = ring.figure("rmse_all", 0.0, 1.0);
    figures.bias = ring.figure("bias", -1.0, 1.0);
    figures.leak_rate = ring.figure("leak_rate", 0.0, 1.0);
    figures.false_shadow_rate = ring.figure("false_shadow_rate", 0.0, 1.0);
    figures.fetches_mean = ring.figure("fetches_mean", 0.0, kAnything);
    ring.finish();
  }
  return result;
}

std::vector<PassRecord> read_passes(StrictObject& record) {
  std::vector<PassRecord> passes;
  if (!record.has("passes")) return passes;
  for (StrictObject& pass : record.objects("passes")) {
    PassRecord result;
    result.pass = pass.text("pass");
    result.runs = pass.text("runs");
    result.fetches_per_pixel = pass.number("fetches_per_pixel", 0.0, kAnything);
    result.texels_written_per_pixel = pass.number("texels_written_per_pixel", 0.0, kAnything);
    if (pass.has("operations_per_pixel"))
      result.operations_per_pixel = pass.number("operations_per_pixel", 0.0, kAnything);
    if (pass.has("invocations_per_pixel"))
      result.invocations_per_pixel = pass.number("invocations_per_pixel", 0.0, kAnything);
    if (pass.has("time_ms_median")) result.time_ms_median = pass.number("time_ms_median", 0.0, kAnything);
    if (pass.has("fetches_per_cascade"))
      result.fetches_per_cascade = pass.number("fetches_per_cascade", 0.0, kAnything);
    pass.finish();
    passes.push_back(std::move(result));
  }
  return passes;
}

parameters::LightFit read_light_fit(StrictObject& settings) {
  const std::string name = settings.text("light_fit");
  const std::optional<parameters::LightFit> fit = parameters::light_fit_named(name);
  if (!fit) settings.fail("light_fit", "there is no fit '" + name + "'");
  return *fit;
}

RunSettings read_settings(StrictObject settings, int cascades) {
  RunSettings result;
  result.depth_bias = settings.number("depth_bias", 0.0, kAnything);
  result.normal_bias = settings.number("normal_bias", 0.0, kAnything);
  result.constant_bias = settings.number("constant_bias", 0.0, kAnything);
  result.slope_bias = settings.number("slope_bias", 0.0, kAnything);
  result.soft_quality = settings.soft_quality("soft_quality");
  result.light_scale = settings.number("light_scale", 0.0, kAnything);
  result.splits = settings.numbers("splits", static_cast<std::size_t>(std::max(cascades - 1, 0)));
  result.reversed_z = settings.boolean("reversed_z");
  if (settings.has("light_fit")) result.cascade_choices.light_fit = read_light_fit(settings);
  if (settings.has("map_age_degrees"))
    result.cascade_choices.map_age_degrees =
        settings.number("map_age_degrees", 0.0, scene::kOldestMapDegrees);
  if (settings.has("cascade_border")) {
    result.cascade_choices.blend.border = settings.number("cascade_border", 0.0, 1.0);
    const std::string blend = settings.text("cascade_blend");
    if (blend != "mix" && blend != "dither") settings.fail("cascade_blend", "it is either 'mix' or 'dither'");
    result.cascade_choices.blend.mixed = blend == "mix";
  }
  settings.finish();
  return result;
}

parameters::Camera read_camera(StrictObject camera) {
  parameters::Camera result;
  result.position = camera.vector("position");
  result.forward = camera.vector("forward");
  result.up = camera.vector("up");
  result.fov_y_degrees = camera.number("fov_y_degrees", 0.0, 180.0);
  result.near_plane = camera.number("near", 0.0, kAnything);
  result.far_plane = camera.number("far", 0.0, kAnything);
  camera.finish();
  return result;
}

MeasuredFrame read_frame(StrictObject frame) {
  MeasuredFrame result;
  result.scene = frame.text("scene");
  result.light_degrees = frame.number("light_degrees", 0.0, 180.0);
  result.sun_direction = frame.vector("sun_direction");
  if (frame.has("source_radius_metres"))
    result.source_radius_metres = frame.number("source_radius_metres", 0.0, kAnything);
  result.width = static_cast<int>(frame.count("width"));
  result.height = static_cast<int>(frame.count("height"));
  result.shadow_distance_metres = frame.number("shadow_distance_metres", 0.0, kAnything);
  result.camera = read_camera(frame.object("camera"));
  frame.finish();
  return result;
}

PackageNote read_package(StrictObject package) {
  PackageNote result{package.text("name"), std::nullopt};
  if (!package.is_null("version")) result.version = package.text("version");
  package.finish();
  return result;
}

Record read_record(StrictObject record, std::string_view kind) {
  Record result;
  result.scene = record.text("scene");
  result.technique = record.text("technique");
  result.title = record.text("title");
  result.parameters = record.number_lists("parameters");
  result.light_degrees = record.number("light_degrees", 0.0, 180.0);
  result.map_size = static_cast<int>(record.count("map_size"));
  result.map_format = record.text("map_format");
  result.cascades = static_cast<int>(record.count("cascades"));
  result.settings = read_settings(record.object("settings"), result.cascades);
  result.device = record.text("device");
  result.metrics = read_metrics(record);
  result.per_cascade = read_cascades(record, result.cascades);
  result.by_distance = read_distances(record);
  if (record.has("operations_per_pixel"))
    result.operations_per_pixel = record.number("operations_per_pixel", 0.0, kAnything);
  if (record.has("baked_mebibytes"))
    result.baked_mebibytes = record.number("baked_mebibytes", 0.0, kAnything);
  result.passes = read_passes(record);
  result.shimmer = read_shimmer(record);
  result.seam = read_seam(record, "seam");
  result.far_seam = read_seam(record, "far_seam");
  result.time = read_time(record, kind);
  StrictObject reference = record.object("reference");
  result.reference = {reference.text("kind"), static_cast<int>(reference.count("samples")),
                      reference.number("noise_floor", 0.0, 1.0)};
  reference.finish();
  record.finish();
  return result;
}

std::string identity(const Record& record) {
  return fmt::format("{} × {} × {}° × {} {} × {} cascades", record.scene, record.technique,
                     record.light_degrees, record.map_size, record.map_format, record.cascades);
}

bool is_of(const MeasuredFrame& frame, const std::string& scene, double light_degrees) {
  return frame.scene == scene && frame.light_degrees == light_degrees;
}

void read_frames(const LocatedJson& document, StrictObject& top, Results& results) {
  const std::size_t count = top.array_size("frames");
  for (std::size_t i = 0; i < count; ++i) {
    const Pointer at = Pointer("/frames") / i;
    MeasuredFrame frame = read_frame({document, at});
    for (const MeasuredFrame& other : results.frames) {
      if (!is_of(other, frame.scene, frame.light_degrees)) continue;
      throw InputError(document.where(at),
                       fmt::format("a second frame of {} × {}°", frame.scene, frame.light_degrees),
                       "remove one of them");
    }
    results.frames.push_back(std::move(frame));
  }
}

void read_records(const LocatedJson& document, StrictObject& top, Results& results) {
  std::set<std::string> seen;
  const std::size_t count = top.array_size("records");
  for (std::size_t i = 0; i < count; ++i) {
    const Pointer at = Pointer("/records") / i;
    Record record = read_record({document, at}, time_kind(results));
    if (const std::string id = identity(record); !seen.insert(id).second) {
      throw InputError(document.where(at), "a second record of " + id, "remove one of them");
    }
    const bool framed = std::any_of(
        results.frames.begin(), results.frames.end(),
        [&](const MeasuredFrame& frame) { return is_of(frame, record.scene, record.light_degrees); });
    if (!framed) {
      throw InputError(document.where(at), fmt::format("'frames' has no entry of the record's {} × {}°",
                                                       record.scene, record.light_degrees));
    }
    results.records.push_back(std::move(record));
  }
}

std::vector<PackageNote> read_packages(const LocatedJson& document, StrictObject& owner, const Pointer& at) {
  std::vector<PackageNote> packages;
  const std::size_t size = owner.array_size("packages");
  for (std::size_t i = 0; i < size; ++i) packages.push_back(read_package({document, at / i}));
  return packages;
}

EarlierRun read_earlier(const LocatedJson& document, const Pointer& at) {
  StrictObject object(document, at);
  EarlierRun run;
  run.techniques = object.texts("techniques");
  run.library_version = object.text("library_version");
  if (!object.is_null("commit")) run.commit = object.text("commit");
  run.packages = read_packages(document, object, at / "packages");
  run.command = object.text("command");
  object.finish();
  return run;
}

Results read_document(const LocatedJson& document) {
  StrictObject top(document, Pointer());
  const std::size_t version = top.count("schema_version");
  if (version != static_cast<std::size_t>(kResultsSchemaVersion)) {
    top.fail(
        "schema_version",
        fmt::format("schema version {} is not the {} this program reads", version, kResultsSchemaVersion),
        "write the file again with this version's 'penumbra measure'");
  }
  Results results;
  results.library_version = top.text("library_version");
  if (!top.is_null("commit")) results.commit = top.text("commit");
  results.packages = read_packages(document, top, Pointer("/packages"));
  results.command = top.text("command");
  results.hardware = top.text("hardware");
  results.device = top.text("device");
  results.driver = top.text("driver");
  results.is_software = top.boolean("is_software");
  if (top.has("front_end")) results.front_end = top.text("front_end");
  if (top.has("earlier"))
    for (std::size_t i = 0; i < top.array_size("earlier"); ++i)
      results.earlier.push_back(read_earlier(document, Pointer("/earlier") / i));
  read_frames(document, top, results);
  read_records(document, top, results);
  top.finish();
  return results;
}

}  // namespace

Results parse_results(std::string_view text, const std::string& name) {
  return read_document(is_json_table(text) ? parse_json_table(text, name, "records")
                                           : LocatedJson::parse(text, name));
}

Results read_results(const std::filesystem::path& file) {
  return parse_results(read_text_file(file), file.string());
}

}  // namespace penumbra::study
