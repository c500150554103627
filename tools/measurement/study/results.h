// results.json: the results of one run of `penumbra measure`, one record per scene, technique, light and map;
// and one entry of `frames` per scene and light, with the properties that its records share.
//
// Nothing in it depends on the date or the folder: the same run writes the same bytes, except for times.
// Times are milliseconds per frame; on a software device they are CPU time, are labelled so, and rank
// nothing.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parameters/cascades.h"
#include "parameters/receiver_fit.h"
#include "scene/frame.h"
#include "study/metrics.h"

namespace penumbra::study {

// The milliseconds of one frame. The spread is the interquartile range: neither figure is sensitive to
// outliers.
struct Timing {
  double median_ms = 0.0;
  double spread_ms = 0.0;

  bool operator==(const Timing&) const = default;
};

// The quartiles are interpolated linearly between order statistics; the result is absent without a sample.
std::optional<Timing> summarise(std::vector<double> milliseconds);

inline constexpr int kResultsSchemaVersion = 2;

struct ReferenceNote {
  std::string kind;  // the method, for example "ray-traced disc light"
  int samples = 0;   // rays per pixel
  double noise_floor =
      0.0;  // RMSE of T1 itself in penumbra: half the RMS difference of two halves of its rays

  bool operator==(const ReferenceNote&) const = default;
};

// The settings at which a subject was measured: its own recommended settings by default.
struct RunSettings {
  double depth_bias = 1.0;  // URP's unitless settings of the casters
  double normal_bias = 1.0;
  double constant_bias = 0.0;  // the rasteriser's, times the map format's smallest step
  double slope_bias = 0.0;     // the rasteriser's, times the depth's change from texel to texel
  parameters::SoftQuality soft_quality = parameters::SoftQuality::medium;  // URP scales both by it
  double light_scale = 1.0;    // the diameter that the subject is given, divided by the light's
  std::vector<double> splits;  // fractions of the shadow distance where all cascades but the last end
  bool reversed_z = true;
  scene::CascadeChoices cascade_choices{};

  bool operator==(const RunSettings&) const = default;
};

// The properties of one scene under one light that all subjects share.
struct MeasuredFrame {
  std::string scene;
  double light_degrees = 0.0;
  glm::dvec3 sun_direction{0.0, -1.0, 0.0};  // unit, the way the light travels
  int width = 0;                             // size of the picture in pixels
  int height = 0;
  double shadow_distance_metres = 0.0;
  parameters::Camera camera;  // world space

  bool operator==(const MeasuredFrame& other) const;
};

// A Unity package whose files a subject included, by its package.json.
struct PackageNote {
  std::string name;
  std::optional<std::string> version;  // absent if its package.json has none

  bool operator==(const PackageNote&) const = default;
};

// What one pass of a technique does in a frame, as in resolve::PassCounts.
struct PassRecord {
  std::string pass;
  std::string runs;                // frame, cascade or bake
  double fetches_per_pixel = 0.0;  // per pixel of the picture
  double texels_written_per_pixel = 0.0;
  std::optional<double> fetches_per_cascade;     // for a pass over the shadow map: in one cascade, all texels
  std::optional<double> operations_per_pixel{};  // executed scalar operations; absent in older files
  std::optional<double> invocations_per_pixel{};  // threads or fragments; absent in older files
  std::optional<double> time_ms_median{};  // waits before it included; absent without a GPU's timestamps
  // Absent in older files: bytes of the texels that are read and written, per pixel of the picture; draws; of
  // kernels dispatches, their groups, and barriers for each of these.
  std::optional<double> bytes_read_per_pixel{};
  std::optional<double> bytes_written_per_pixel{};
  std::optional<double> draws{};
  std::optional<double> dispatches{};
  std::optional<double> groups{};
  std::optional<double> barriers_per_group{};

  bool operator==(const PassRecord&) const = default;
};

// The figures of the pixels that read one cascade, as in Metrics.
struct CascadeRecord {
  std::size_t pixels = 0;
  std::size_t penumbra_pixels = 0;
  std::optional<double> rmse_penumbra;
  std::optional<double> bias;
  std::optional<double> leak_rate;
  std::optional<double> false_shadow_rate;
  std::optional<double> fetches_mean;
  MetricIntervals intervals;
  // The technique whose filter runs in the cascade, and the values that its rule sets, where the technique
  // has a rule for the cascade.
  std::string technique{};
  std::map<std::string, std::vector<double>> parameters{};
  std::optional<double> texel_size_metres{};  // size of the shadow map's texels; absent in older files

  bool operator==(const CascadeRecord&) const = default;
};

// The figures of the pixels at these distances from the camera, as in Metrics.
struct DistanceRecord {
  double from_metres = 0.0;
  double to_metres = 0.0;
  std::size_t pixels = 0;
  std::size_t penumbra_pixels = 0;
  std::optional<double> rmse_penumbra;
  std::optional<double> rmse_all;
  std::optional<double> bias;
  std::optional<double> leak_rate;
  std::optional<double> false_shadow_rate;
  std::optional<double> fetches_mean;

  bool operator==(const DistanceRecord&) const = default;
};

// The figures of the pixels on which shadows of low and of high casters overlap
// (reference::shadow_overlaps()).
struct OverlapRecord {
  std::size_t pixels = 0;
  std::optional<double> rmse;
  std::optional<double> bias;

  bool operator==(const OverlapRecord&) const = default;
};

struct Record {
  std::string scene;
  std::string technique;
  std::string title;  // the technique's name for tables
  std::map<std::string, std::vector<double>> parameters;
  double light_degrees = 0.0;  // full angular diameter of the disc
  int map_size = 0;            // width of the atlas in texels
  std::string map_format;      // D16, D24 or D32
  int cascades = 1;
  RunSettings settings;
  std::string device;
  Metrics metrics;
  // There is a record for each of several cascades; it is empty with one, and in older files.
  std::vector<CascadeRecord> per_cascade;
  std::vector<DistanceRecord>
      by_distance{};  // for scenes that are seen beyond the shadow distance; else empty
  // The memory of the textures that the technique reads besides the frame.
  std::optional<double> baked_mebibytes{};
  // Executed scalar operations of all passes (shaders/counted_module.h), per pixel of the picture; absent in
  // older files.
  std::optional<double> operations_per_pixel{};
  // The passes in the order in which they run; empty for a filter alone in older files.
  std::vector<PassRecord> passes;
  std::optional<Shimmer> shimmer;  // present when the study panned
  std::optional<Seam> seam;        // present with several cascades; absent in older files
  std::optional<Seam>
      far_seam{};  // present with by_distance: all pixels, between the last cascade and what is beyond
  std::optional<OverlapRecord> overlap{};  // absent unless it was asked for
  std::optional<double> flip{};            // mean FLIP of the lit picture; absent unless it was asked for
  std::optional<GroupStep> group_step{};   // absent in older files
  std::optional<Timing> time;
  ReferenceNote reference;

  bool operator==(const Record&) const = default;
};

// The name of the compiler of shaders where Results::front_end is absent.
inline constexpr const char* kGlslang = "glslang";

// The techniques of the records that were measured before the others, of the same pictures, and their run.
struct EarlierRun {
  std::vector<std::string> techniques;
  std::string library_version;
  std::optional<std::string> commit;
  std::vector<PackageNote> packages;
  std::string command;

  bool operator==(const EarlierRun&) const = default;
};

struct Results {
  std::string library_version;
  std::optional<std::string>
      commit;  // git's, "-dirty" behind it for a changed tree; absent where none is known
  std::vector<PackageNote> packages;
  std::string command;   // the command that reproduces the file
  std::string hardware;  // processor, or graphics card
  std::string device;    // the Vulkan device's own name
  std::string driver;
  bool is_software = true;
  std::optional<std::string> front_end{};  // compiler of all programs; absent means glslang
  std::vector<EarlierRun> earlier{};       // runs whose records are among these
  std::vector<MeasuredFrame> frames;       // one per scene and light, in the order of the records
  std::vector<Record> records;

  bool operator==(const Results&) const = default;
};

// Returns true when a technique returned NaN, infinity or something outside [0, 1]: `measure` exits with
// findings.
bool has_invalid_values(const Results& results);

// Returns "CPU time" or "GPU time".
std::string_view time_kind(const Results& results);

std::string to_json(const Results& results);

// Returns the same as a table (input/json_table.h) with a line for each record. Figures have seven
// significant digits, and the ends of intervals five.
std::string to_table(const Results& results);

// Reads either form. Throws InputError with file:line:column for anything that to_json() would not have
// written: wrong type, missing or unknown key, another schema version, a rate outside [0, 1], two records of
// the same measurement.
Results parse_results(std::string_view text, const std::string& name);
Results read_results(const std::filesystem::path& file);

}  // namespace penumbra::study
