#include "study/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

namespace penumbra::study {
namespace {

class Mean {
 public:
  void add(const std::optional<double>& value) {
    if (!value) return;
    sum_ += *value;
    ++count_;
  }
  std::size_t count() const { return count_; }
  std::optional<double> value() const {
    return count_ == 0 ? std::nullopt : std::optional(sum_ / static_cast<double>(count_));
  }

 private:
  double sum_ = 0.0;
  std::size_t count_ = 0;
};

std::string map_name(const Record& record) {
  return fmt::format("{} {}, {} cascade{}", record.map_size, record.map_format, record.cascades,
                     record.cascades == 1 ? "" : "s");
}

bool one_map(const Results& results) {
  const auto map = [](const Record& record) {
    return std::tie(record.map_size, record.map_format, record.cascades);
  };
  return std::all_of(results.records.begin(), results.records.end(),
                     [&](const Record& record) { return map(record) == map(results.records.front()); });
}

std::optional<double> total_fetches(const Record& record) {
  const std::optional<double>& resolve = record.metrics.fetches_mean;
  return resolve ? std::optional(*resolve + record.metrics.preprocess_fetches_per_pixel) : std::nullopt;
}

// Scenes in which this light throws a penumbra at all, whoever measures it.
std::size_t scenes_with_penumbra(const Results& results, double light_degrees) {
  std::set<std::string> scenes;
  for (const Record& record : results.records) {
    if (record.light_degrees == light_degrees && record.metrics.penumbra_pixels > 0)
      scenes.insert(record.scene);
  }
  return scenes.size();
}

SummaryLine line_of(const Results& results, const Choice& choice, double light_degrees) {
  Mean rmse;
  Mean fetches;
  Mean time;
  for (const std::string& scene : scene_names(results)) {
    const Record* record = find_record(results, choice.label, scene, light_degrees);
    if (record == nullptr) continue;
    rmse.add(record->metrics.rmse_penumbra);
    fetches.add(total_fetches(*record));
    if (record->time) time.add(record->time->median_ms);
  }
  SummaryLine line{choice, light_degrees, rmse.count(), true, rmse.value(), fetches.value(), time.value()};
  line.complete = rmse.count() > 0 && rmse.count() == scenes_with_penumbra(results, light_degrees);
  return line;
}

struct Overall {
  Choice choice;
  double rmse = 0.0;
  double fetches = 0.0;
};

// One entry per choice that is complete for every light.
std::vector<Overall> overall(const Results& results) {
  const std::vector<SummaryLine> lines = summarise(results);
  std::vector<Overall> entries;
  for (const Choice& choice : choices(results)) {
    Mean rmse;
    Mean fetches;
    for (const SummaryLine& line : lines) {
      if (line.choice != choice || !line.complete || !line.fetches) continue;
      rmse.add(line.rmse_penumbra);
      fetches.add(line.fetches);
    }
    if (rmse.count() == light_sizes(results).size() && rmse.count() > 0) {
      entries.push_back({choice, *rmse.value(), *fetches.value()});
    }
  }
  return entries;
}

}  // namespace

std::vector<std::string> scene_names(const Results& results) {
  std::vector<std::string> names;
  for (const Record& record : results.records) {
    if (std::find(names.begin(), names.end(), record.scene) == names.end()) names.push_back(record.scene);
  }
  return names;
}

std::vector<double> light_sizes(const Results& results) {
  std::set<double> sizes;
  for (const Record& record : results.records) sizes.insert(record.light_degrees);
  return {sizes.begin(), sizes.end()};
}

Choice choice_of(const Results& results, const Record& record) {
  const std::string label =
      one_map(results) ? record.technique : fmt::format("{} ({})", record.technique, map_name(record));
  return {record.technique, label, record.title};
}

std::vector<Choice> choices(const Results& results) {
  std::vector<Choice> list;
  for (const Record& record : results.records) {
    Choice choice = choice_of(results, record);
    if (std::find(list.begin(), list.end(), choice) == list.end()) list.push_back(std::move(choice));
  }
  return list;
}

const Record* find_record(const Results& results, const std::string& label, const std::string& scene,
                          double light_degrees) {
  const auto found = std::find_if(results.records.begin(), results.records.end(), [&](const Record& record) {
    return record.scene == scene && record.light_degrees == light_degrees &&
           choice_of(results, record).label == label;
  });
  return found == results.records.end() ? nullptr : &*found;
}

std::vector<SummaryLine> summarise(const Results& results) {
  std::vector<SummaryLine> lines;
  for (const Choice& choice : choices(results)) {
    for (const double light : light_sizes(results)) {
      SummaryLine line = line_of(results, choice, light);
      if (line.scenes > 0 || line.fetches) lines.push_back(std::move(line));
    }
  }
  return lines;
}

std::vector<Headline> headlines(const Results& results) {
  const std::vector<Overall> entries = overall(results);
  if (entries.empty()) return {};
  const auto less_error = [](const Overall& a, const Overall& b) { return a.rmse < b.rmse; };
  const auto less_cost = [](const Overall& a, const Overall& b) {
    return a.fetches != b.fetches ? a.fetches < b.fetches : a.rmse < b.rmse;
  };
  const Overall& best = *std::min_element(entries.begin(), entries.end(), less_error);
  const Overall& cheapest = *std::min_element(entries.begin(), entries.end(), less_cost);
  const Overall* bargain = &best;
  for (const Overall& entry : entries) {
    if (entry.rmse <= 1.1 * best.rmse && less_cost(entry, *bargain)) bargain = &entry;
  }
  const auto cost = [](const Overall& entry) {
    const std::string count = fmt::format("{:.3g}", entry.fetches);
    return count + (count == "1" ? " fetch per pixel" : " fetches per pixel");
  };
  return {
      {fmt::format("{:.3f}", best.rmse), "lowest penumbra error (RMSE)",
       best.choice.label + ", " + cost(best)},
      {fmt::format("{:.3g}", bargain->fetches), "fetches per pixel come within 10 % of it",
       fmt::format("{}, error {:.3f}", bargain->choice.label, bargain->rmse)},
      {fmt::format("{:.3f}", cheapest.rmse), "error of the cheapest technique",
       cheapest.choice.label + ", " + cost(cheapest)},
  };
}

}  // namespace penumbra::study
