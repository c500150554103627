// results.json: what one run of `penumbra measure` found, one record per scene, technique, light and map.
//
// Nothing in it depends on the day or the folder: the same run writes the same bytes, times apart. Times are
// milliseconds per frame; on a software device they are CPU time, say so, and rank nothing.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/metrics.h"
#include "study/shimmer.h"
#include "study/timing.h"

namespace penumbra::study {

inline constexpr int kResultsSchemaVersion = 1;

struct ReferenceNote {
  std::string kind;          // for example "ray-traced disc light"
  int samples = 0;           // rays per pixel
  double noise_floor = 0.0;  // RMSE of two independent references in penumbra, divided by sqrt(2)

  bool operator==(const ReferenceNote&) const = default;
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
  std::string device;
  Metrics metrics;
  std::optional<Shimmer> shimmer;  // when the study panned
  std::optional<Timing> time;
  ReferenceNote reference;

  bool operator==(const Record&) const = default;
};

struct Results {
  std::string library_version;
  std::string command;   // what reproduces the file
  std::string hardware;  // processor, or graphics card
  std::string device;    // the Vulkan device's own name
  std::string driver;
  bool is_software = true;
  std::vector<Record> records;

  bool operator==(const Results&) const = default;
};

// True when a technique returned NaN, infinity or something outside [0, 1]: `measure` exits with findings.
bool has_invalid_values(const Results& results);

// "CPU time" or "GPU time".
std::string_view time_kind(const Results& results);

std::string to_json(const Results& results);

// Throws InputError with file:line:column for anything to_json would not have written: wrong type, missing or
// unknown key, another schema version, a rate outside [0, 1], two records of the same measurement.
Results parse_results(std::string_view text, const std::string& name);
Results read_results(const std::filesystem::path& file);

}  // namespace penumbra::study
