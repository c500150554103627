#include "study/earlier_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "input/input_error.h"
#include "input/nearest_name.h"
#include "study/summary.h"

namespace penumbra::study {

namespace {

constexpr const char* kRemedy = "measure all techniques in one run";

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string place_of(const std::string& scene, double light_degrees) {
  return fmt::format("{} at {} degrees", scene, light_degrees);
}

std::string seen_in(const Record& record) {
  return fmt::format("a map of {} texels of {}, {} cascades, {} rays per pixel", record.map_size,
                     record.map_format, record.cascades, record.reference.samples);
}

// A table of results has seven digits of the noise floor.
bool same_reference(const ReferenceNote& note, const ReferenceNote& other) {
  return note.kind == other.kind && note.samples == other.samples &&
         std::abs(note.noise_floor - other.noise_floor) <=
             1e-6 * std::max(note.noise_floor, other.noise_floor);
}

bool same_sample(const Record& record, const Record& other) {
  return record.map_size == other.map_size && record.map_format == other.map_format &&
         record.cascades == other.cascades && same_reference(record.reference, other.reference) &&
         record.metrics.pixels == other.metrics.pixels &&
         record.metrics.penumbra_pixels == other.metrics.penumbra_pixels;
}

void require_same_frames(const Results& results, const Results& earlier, const std::string& file) {
  for (const MeasuredFrame& frame : results.frames) {
    const auto other =
        std::find_if(earlier.frames.begin(), earlier.frames.end(), [&](const MeasuredFrame& one) {
          return one.scene == frame.scene && one.light_degrees == frame.light_degrees;
        });
    const std::string place = place_of(frame.scene, frame.light_degrees);
    if (other == earlier.frames.end()) throw InputError(file, place + " was not measured there", kRemedy);
    if (!(*other == frame)) throw InputError(file, place + " has another picture or light there", kRemedy);
  }
}

// Returns the record of the same scene and light.
const Record& record_beside(const Results& results, const Record& record, const std::string& file) {
  for (const Record& own : results.records)
    if (own.scene == record.scene && own.light_degrees == record.light_degrees) return own;
  throw InputError(file, place_of(record.scene, record.light_degrees) + " was measured there alone", kRemedy);
}

// The runs that measured the techniques: this file's, or those that its rows were taken from.
void add_runs(Results& results, const Results& earlier, std::vector<std::string> techniques) {
  for (EarlierRun run : earlier.earlier) {
    std::erase_if(run.techniques, [&](const std::string& name) { return !contains(techniques, name); });
    if (run.techniques.empty()) continue;
    std::erase_if(techniques, [&](const std::string& name) { return contains(run.techniques, name); });
    results.earlier.push_back(std::move(run));
  }
  if (techniques.empty()) return;
  results.earlier.push_back(
      {std::move(techniques), earlier.library_version, earlier.commit, earlier.packages, earlier.command});
}

}  // namespace

void check_earlier_rows(const Results& earlier, const std::vector<std::string>& techniques,
                        const std::optional<std::string>& front_end, const std::filesystem::path& file) {
  if (earlier.front_end != front_end)
    throw InputError(file.string(),
                     fmt::format("its shaders were compiled by {}, those here are by {}",
                                 earlier.front_end.value_or(kGlslang), front_end.value_or(kGlslang)),
                     "measure both with the same --front-end");
  const std::vector<std::string> known = technique_names(earlier);
  for (const std::string& technique : techniques)
    if (!contains(known, technique))
      throw InputError(file.string(), "it has no technique '" + technique + "'",
                       unknown_name_remedy(technique, known));
}

void add_earlier_rows(Results& results, const Results& earlier, const std::vector<std::string>& techniques,
                      const std::filesystem::path& file) {
  check_earlier_rows(earlier, techniques, results.front_end, file);
  const std::string name = file.string();
  require_same_frames(results, earlier, name);
  for (const Record& own : results.records)
    if (contains(techniques, own.technique))
      throw InputError(name, "'" + own.technique + "' was measured again",
                       "leave it out of --technique, or out of --earlier-rows");
  std::vector<Record> taken;
  for (const Record& record : earlier.records) {
    if (!contains(techniques, record.technique)) continue;
    const Record& own = record_beside(results, record, name);
    if (!same_sample(record, own))
      throw InputError(
          name,
          fmt::format("{} was measured there with {}, here with {}",
                      place_of(record.scene, record.light_degrees), seen_in(record), seen_in(own)),
          kRemedy);
    taken.push_back(record);
  }
  results.records.insert(results.records.end(), taken.begin(), taken.end());
  add_runs(results, earlier, techniques);
}

}  // namespace penumbra::study
