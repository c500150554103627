// Results over all scenes: one line per technique, map and light, and the three figures that matter most.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "study/interval.h"
#include "study/results.h"

namespace penumbra::study {

// A technique on a map setting. `label` is the technique's name and `shown` its short title
// both with the map when the results hold several.
struct Choice {
  std::string technique;
  std::string label;
  std::string title;
  std::string shown;

  bool operator==(const Choice&) const = default;
};

// The means over scenes, each scene weighing the same, whatever its number of penumbra pixels, with 95 %
// intervals over scenes and the pixels of each (study/interval.h). A mean over fewer scenes than the light
// was measured on is not comparable: `complete` is false, and the line is not ranked.
struct SummaryLine {
  Choice choice;
  double light_degrees = 0.0;
  std::size_t scenes = 0;  // scenes with a penumbra to measure
  bool complete = true;
  std::optional<Estimate> rmse_penumbra{};
  std::optional<Estimate> rmse_all{};
  std::optional<Estimate> leak_rate{};
  std::optional<Estimate> false_shadow_rate{};
  std::optional<Estimate> fetches{};     // per pixel of the frame, preparation included
  std::optional<Estimate> operations{};  // scalar operations per pixel; absent in older files
  std::optional<double> time_ms{};       // median of a frame
};

// The sample behind the means of one light.
struct LightSample {
  std::size_t scenes = 0;                    // scenes with a penumbra to measure
  std::size_t smallest_penumbra_pixels = 0;  // the smallest number of those scenes
  std::size_t penumbra_pixels = 0;           // sum over all scenes
};
LightSample sample_of(const Results& results, double light_degrees);

// Returns lines in the order in which the records bring technique and map first, lights rising within each.
std::vector<SummaryLine> summarise(const Results& results);

std::vector<std::string> scene_names(const Results& results);      // in record order
std::vector<std::string> technique_names(const Results& results);  // in record order
std::vector<double> light_sizes(const Results& results);           // degrees, rising
std::vector<Choice> choices(const Results& results);               // in record order
Choice choice_of(const Results& results, const Record& record);

// Returns the one record of that choice, scene and light; null when there is none.
const Record* find_record(const Results& results, const std::string& label, const std::string& scene,
                          double light_degrees);

// A headline: for a card of the report, and a line of the demo.
struct Headline {
  std::string value;  // "0.097"
  std::string name;   // "lowest penumbra error"
  std::string detail;
};

// Returns the lowest error, the cheapest technique within 10 % of it, and the error of the cheapest technique
// of all; the latter two only if they are a different technique. Figures are means over all scenes and
// lights, costs in fetches (times on a software device rank nothing). Empty when no technique was measured on
// every scene and light.
std::vector<Headline> headlines(const Results& results);

// Returns an adapter's title without its file: "mine" for "mine (Mine.hlsl)". Every other title is unchanged.
// Without a title it is the name.
std::string short_title(const std::string& name, const std::string& title);

}  // namespace penumbra::study
