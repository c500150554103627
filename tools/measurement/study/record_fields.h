// The fields of results.json, each listed once: what is written and what is read follow these lists. Internal
// to this folder.
//
// fields(archive, value) gives the archive every key with the member that has its value, in the file's order.
// The archive of results_write.cpp puts them into JSON. That of results_read.cpp takes them from there, and
// refuses what is missing or outside the given range. `number` and `count` are always there, `figure` and
// `nullable` may be null; the keys of `optional`, and those asked for by `present`, may be missing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "study/results.h"

namespace penumbra::study {

inline constexpr double kAnything = 1e300;

template <typename Archive, typename Value>
using Field = std::conditional_t<Archive::reads, Value, const Value>;

template <typename Archive>
void fields(Archive& archive, Field<Archive, ErrorShare>& share) {
  archive.number("mean", share.mean, -1.0, 1.0);
  archive.number("rmse", share.rmse, 0.0, 1.0);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, ErrorSplit>& split) {
  archive.nullable("map", split.map);
  archive.nullable("algorithm", split.algorithm);
  archive.nullable("sampling", split.sampling);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, Interval>& interval, double most) {
  archive.number("low", interval.low, 0.0, most);
  archive.number("high", interval.high, 0.0, most);
  archive.number("standard_error", interval.standard_error, 0.0, kAnything);
  archive.require(interval.low <= interval.high, "high", "must not lie below 'low'");
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, MetricIntervals>& intervals) {
  archive.nullable("rmse_penumbra", intervals.rmse_penumbra, 1.0);
  archive.nullable("rmse_all", intervals.rmse_all, 1.0);
  archive.nullable("leak_rate", intervals.leak_rate, 1.0);
  archive.nullable("false_shadow_rate", intervals.false_shadow_rate, 1.0);
  archive.nullable("fetches_mean", intervals.fetches_mean, kAnything);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, MaskShares>& mask) {
  archive.number("pixels_saved", mask.pixels_saved, 0.0, 1.0);
  archive.figure("penumbra_pixels_missed", mask.penumbra_pixels_missed, 0.0, 1.0);
}

// Of the object of a record itself.
template <typename Archive>
void fields(Archive& archive, Field<Archive, Metrics>& metrics) {
  archive.count("pixels", metrics.pixels);
  archive.count("penumbra_pixels", metrics.penumbra_pixels);
  archive.count("seeds", metrics.seeds);
  archive.count("invalid", metrics.invalid);
  archive.figure("rmse_penumbra", metrics.rmse_penumbra, 0.0, 1.0);
  archive.figure("rmse_all", metrics.rmse_all, 0.0, 1.0);
  archive.figure("bias", metrics.bias, -1.0, 1.0);
  archive.figure("variance", metrics.variance, 0.0, 1.0);
  archive.figure("p99", metrics.p99, 0.0, 1.0);
  archive.figure("max_error", metrics.max_error, 0.0, 1.0);
  archive.figure("leak_rate", metrics.leak_rate, 0.0, 1.0);
  archive.figure("false_shadow_rate", metrics.false_shadow_rate, 0.0, 1.0);
  archive.figure("fetches_mean", metrics.fetches_mean, 0.0, kAnything);
  archive.figure("fetches_p95", metrics.fetches_p95, 0.0, kAnything);
  archive.figure("fetches_penumbra_mean", metrics.fetches_penumbra_mean, 0.0, kAnything);
  archive.number("preprocess_fetches_per_pixel", metrics.preprocess_fetches_per_pixel, 0.0, kAnything);
  archive.optional("mask", metrics.mask);
  archive.object("error_split", metrics.split);
  archive.object("intervals", metrics.intervals);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, CascadeRecord>& cascade) {
  archive.count("pixels", cascade.pixels);
  archive.count("penumbra_pixels", cascade.penumbra_pixels);
  archive.figure("rmse_penumbra", cascade.rmse_penumbra, 0.0, 1.0);
  archive.figure("bias", cascade.bias, -1.0, 1.0);
  archive.figure("leak_rate", cascade.leak_rate, 0.0, 1.0);
  archive.figure("false_shadow_rate", cascade.false_shadow_rate, 0.0, 1.0);
  archive.figure("fetches_mean", cascade.fetches_mean, 0.0, kAnything);
  archive.object("intervals", cascade.intervals);
  if (archive.present("technique", !cascade.technique.empty())) {
    archive.text("technique", cascade.technique);
    archive.number_lists("parameters", cascade.parameters);
  }
  archive.optional("texel_size_metres", cascade.texel_size_metres, 0.0, kAnything);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, DistanceRecord>& ring) {
  archive.number("from_metres", ring.from_metres, 0.0, kAnything);
  archive.number("to_metres", ring.to_metres, 0.0, kAnything);
  archive.require(ring.to_metres > ring.from_metres, "to_metres", "must lie above 'from_metres'");
  archive.count("pixels", ring.pixels);
  archive.count("penumbra_pixels", ring.penumbra_pixels);
  archive.figure("rmse_penumbra", ring.rmse_penumbra, 0.0, 1.0);
  archive.figure("rmse_all", ring.rmse_all, 0.0, 1.0);
  archive.figure("bias", ring.bias, -1.0, 1.0);
  archive.figure("leak_rate", ring.leak_rate, 0.0, 1.0);
  archive.figure("false_shadow_rate", ring.false_shadow_rate, 0.0, 1.0);
  archive.figure("fetches_mean", ring.fetches_mean, 0.0, kAnything);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, PassRecord>& pass) {
  archive.text("pass", pass.pass);
  archive.text("runs", pass.runs);
  archive.number("fetches_per_pixel", pass.fetches_per_pixel, 0.0, kAnything);
  archive.number("texels_written_per_pixel", pass.texels_written_per_pixel, 0.0, kAnything);
  archive.optional("operations_per_pixel", pass.operations_per_pixel, 0.0, kAnything);
  archive.optional("invocations_per_pixel", pass.invocations_per_pixel, 0.0, kAnything);
  archive.optional("bytes_read_per_pixel", pass.bytes_read_per_pixel, 0.0, kAnything);
  archive.optional("bytes_written_per_pixel", pass.bytes_written_per_pixel, 0.0, kAnything);
  archive.optional("draws", pass.draws, 0.0, kAnything);
  archive.optional("dispatches", pass.dispatches, 0.0, kAnything);
  archive.optional("groups", pass.groups, 0.0, kAnything);
  archive.optional("barriers_per_group", pass.barriers_per_group, 0.0, kAnything);
  archive.optional("time_ms_median", pass.time_ms_median, 0.0, kAnything);
  archive.optional("fetches_per_cascade", pass.fetches_per_cascade, 0.0, kAnything);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, Shimmer>& shimmer) {
  archive.count("frames", shimmer.frames);
  archive.figure("static_noise", shimmer.static_noise, 0.0, 1.0);
  archive.figure("per_frame_noise", shimmer.per_frame_noise, 0.0, 1.0);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, GroupStep>& step) {
  archive.count("pairs", step.pairs);
  archive.figure("across", step.across, 0.0, 2.0);
  archive.figure("inside", step.inside, 0.0, 2.0);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, OverlapRecord>& overlap) {
  archive.count("pixels", overlap.pixels);
  archive.figure("rmse", overlap.rmse, 0.0, 1.0);
  archive.figure("bias", overlap.bias, -1.0, 1.0);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, Seam>& seam) {
  archive.count("pairs", seam.pairs);
  archive.figure("step", seam.step, 0.0, 2.0);
  archive.figure("elsewhere", seam.elsewhere, 0.0, 2.0);
}

// Of the object of a record itself.
template <typename Archive>
void fields(Archive& archive, Field<Archive, std::optional<Timing>>& time, std::string_view kind) {
  archive.constant("time_kind", kind, "as 'is_software' of the file says");
  std::optional<double> median = time ? std::optional(time->median_ms) : std::nullopt;
  std::optional<double> spread = time ? std::optional(time->spread_ms) : std::nullopt;
  archive.figure("time_ms_median", median, 0.0, kAnything);
  archive.figure("time_ms_spread", spread, 0.0, kAnything);
  archive.require(median.has_value() == spread.has_value(), "time_ms_spread",
                  "must be null exactly when 'time_ms_median' is");
  if constexpr (Archive::reads)
    if (median) time = Timing{*median, *spread};
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, ReferenceNote>& reference) {
  archive.text("kind", reference.kind);
  archive.count("samples", reference.samples);
  archive.number("noise_floor", reference.noise_floor, 0.0, 1.0);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, RunSettings>& settings, int cascades) {
  archive.number("depth_bias", settings.depth_bias, 0.0, kAnything);
  archive.number("normal_bias", settings.normal_bias, 0.0, kAnything);
  archive.number("constant_bias", settings.constant_bias, 0.0, kAnything);
  archive.number("slope_bias", settings.slope_bias, 0.0, kAnything);
  archive.soft_quality("soft_quality", settings.soft_quality);
  archive.number("light_scale", settings.light_scale, 0.0, kAnything);
  archive.numbers("splits", settings.splits, static_cast<std::size_t>(std::max(cascades - 1, 0)));
  archive.boolean("reversed_z", settings.reversed_z);
  auto& choices = settings.cascade_choices;
  if (archive.present("light_fit", choices.light_fit != parameters::LightFit::sphere))
    archive.light_fit("light_fit", choices.light_fit);
  if (archive.present("cascade_border", choices.blend.border > 0.0)) {
    archive.number("cascade_border", choices.blend.border, 0.0, 1.0);
    archive.either("cascade_blend", choices.blend.mixed, "mix", "dither");
  }
  if (archive.present("map_age_degrees", choices.map_age_degrees > 0.0))
    archive.number("map_age_degrees", choices.map_age_degrees, 0.0, scene::kOldestMapDegrees);
}

// `kind`: of the times of the file.
template <typename Archive>
void fields(Archive& archive, Field<Archive, Record>& record, std::string_view kind) {
  archive.text("scene", record.scene);
  archive.text("technique", record.technique);
  archive.text("title", record.title);
  archive.number_lists("parameters", record.parameters);
  archive.number("light_degrees", record.light_degrees, 0.0, 180.0);
  archive.count("map_size", record.map_size);
  archive.text("map_format", record.map_format);
  archive.count("cascades", record.cascades);
  archive.object("settings", record.settings, record.cascades);
  archive.text("device", record.device);
  fields(archive, record.metrics);
  if (archive.present("per_cascade", !record.per_cascade.empty())) {
    archive.list("per_cascade", record.per_cascade);
    archive.require(record.per_cascade.size() == static_cast<std::size_t>(record.cascades), "per_cascade",
                    "'per_cascade' must have one entry for each of the " + std::to_string(record.cascades) +
                        " cascades, not " + std::to_string(record.per_cascade.size()));
  }
  if (archive.present("by_distance", !record.by_distance.empty()))
    archive.list("by_distance", record.by_distance);
  archive.optional("operations_per_pixel", record.operations_per_pixel, 0.0, kAnything);
  archive.optional("baked_mebibytes", record.baked_mebibytes, 0.0, kAnything);
  if (archive.present("passes", !record.passes.empty())) archive.list("passes", record.passes);
  archive.optional("shimmer", record.shimmer);
  archive.optional("seam", record.seam);
  archive.optional("far_seam", record.far_seam);
  archive.optional("group_step", record.group_step);
  archive.optional("overlap", record.overlap);
  archive.optional("flip", record.flip, 0.0, 1.0);
  fields(archive, record.time, kind);
  archive.object("reference", record.reference);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, parameters::Camera>& camera) {
  archive.vector("position", camera.position);
  archive.vector("forward", camera.forward);
  archive.vector("up", camera.up);
  archive.number("fov_y_degrees", camera.fov_y_degrees, 0.0, 180.0);
  archive.number("near", camera.near_plane, 0.0, kAnything);
  archive.number("far", camera.far_plane, 0.0, kAnything);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, MeasuredFrame>& frame) {
  archive.text("scene", frame.scene);
  archive.number("light_degrees", frame.light_degrees, 0.0, 180.0);
  archive.vector("sun_direction", frame.sun_direction);
  archive.count("width", frame.width);
  archive.count("height", frame.height);
  archive.number("shadow_distance_metres", frame.shadow_distance_metres, 0.0, kAnything);
  archive.object("camera", frame.camera);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, PackageNote>& package) {
  archive.text("name", package.name);
  archive.nullable("version", package.version);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, EarlierRun>& run) {
  archive.texts("techniques", run.techniques);
  archive.text("library_version", run.library_version);
  archive.nullable("commit", run.commit);
  archive.list("packages", run.packages);
  archive.text("command", run.command);
}

template <typename Archive>
void fields(Archive& archive, Field<Archive, Results>& results) {
  archive.text("library_version", results.library_version);
  archive.nullable("commit", results.commit);
  archive.list("packages", results.packages);
  archive.text("command", results.command);
  archive.text("hardware", results.hardware);
  archive.text("device", results.device);
  archive.text("driver", results.driver);
  archive.boolean("is_software", results.is_software);
  archive.optional("front_end", results.front_end);
  if (archive.present("earlier", !results.earlier.empty())) archive.list("earlier", results.earlier);
  archive.list("frames", results.frames);
  archive.list("records", results.records, time_kind(results));
}

}  // namespace penumbra::study
