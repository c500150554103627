#include "study/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
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

// The values of one figure for every scene.
class SceneFigures {
 public:
  void add(const std::optional<double>& value, const std::optional<Interval>& interval) {
    if (value) figures_.push_back({*value, interval ? interval->standard_error : 0.0});
  }
  std::size_t count() const { return figures_.size(); }
  std::optional<Estimate> mean(double most) const {
    if (figures_.empty()) return std::nullopt;
    double sum = 0.0;
    for (const SceneFigure& figure : figures_) sum += figure.value;
    return Estimate{sum / static_cast<double>(figures_.size()), mean_interval(figures_, 0.0, most)};
  }

 private:
  std::vector<SceneFigure> figures_;
};

// Returns the fetches with those of passes at lower resolution.
std::optional<double> of_all_passes(const std::optional<double>& fetches, const Metrics& metrics) {
  return fetches ? std::optional(*fetches + metrics.preprocess_fetches_per_pixel) : std::nullopt;
}

SummaryLine line_of(const Results& results, const Choice& choice, double light_degrees) {
  SceneFigures rmse;
  SceneFigures rmse_all;
  SceneFigures leaks;
  SceneFigures false_shadows;
  SceneFigures fetches;
  SceneFigures operations;
  Mean time;
  for (const std::string& scene : scene_names(results)) {
    const Record* record = find_record(results, choice.label, scene, light_degrees);
    if (record == nullptr) continue;
    const Metrics& metrics = record->metrics;
    rmse.add(metrics.rmse_penumbra, metrics.intervals.rmse_penumbra);
    rmse_all.add(metrics.rmse_all, metrics.intervals.rmse_all);
    leaks.add(metrics.leak_rate, metrics.intervals.leak_rate);
    false_shadows.add(metrics.false_shadow_rate, metrics.intervals.false_shadow_rate);
    fetches.add(of_all_passes(metrics.fetches_mean, metrics), metrics.intervals.fetches_mean);
    operations.add(record->operations_per_pixel, std::nullopt);
    if (record->time) time.add(record->time->median_ms);
  }
  SummaryLine line{choice, light_degrees, rmse.count()};
  line.rmse_penumbra = rmse.mean(1.0);
  line.rmse_all = rmse_all.mean(1.0);
  line.leak_rate = leaks.mean(1.0);
  line.false_shadow_rate = false_shadows.mean(1.0);
  line.fetches = fetches.mean(std::numeric_limits<double>::infinity());
  line.operations = operations.mean(std::numeric_limits<double>::infinity());
  line.time_ms = time.value();
  line.complete = rmse.count() > 0 && rmse.count() == sample_of(results, light_degrees).scenes;
  return line;
}

Choice choice_of(const Record& record, bool same_map) {
  const std::string map = same_map ? "" : fmt::format(" ({})", map_name(record));
  return {record.technique, record.technique + map, record.title,
          short_title(record.technique, record.title) + map};
}

struct Overall {
  Choice choice;
  double rmse = 0.0;
  double fetches = 0.0;
};

// Returns one entry per choice that is complete for every light.
std::vector<Overall> overall(const Results& results) {
  const std::vector<SummaryLine> lines = summarise(results);
  std::vector<Overall> entries;
  for (const Choice& choice : choices(results)) {
    Mean rmse;
    Mean fetches;
    for (const SummaryLine& line : lines) {
      if (line.choice != choice || !line.complete || !line.fetches) continue;
      if (line.rmse_penumbra) rmse.add(line.rmse_penumbra->value);
      fetches.add(line.fetches->value);
    }
    if (rmse.count() == light_sizes(results).size() && rmse.count() > 0) {
      entries.push_back({choice, *rmse.value(), *fetches.value()});
    }
  }
  return entries;
}

std::vector<std::string> distinct(const Results& results, std::string Record::*field) {
  std::vector<std::string> values;
  for (const Record& record : results.records)
    if (std::find(values.begin(), values.end(), record.*field) == values.end())
      values.push_back(record.*field);
  return values;
}

}  // namespace

std::vector<std::string> scene_names(const Results& results) {
  return distinct(results, &Record::scene);
}

std::vector<std::string> technique_names(const Results& results) {
  return distinct(results, &Record::technique);
}

std::vector<double> light_sizes(const Results& results) {
  std::set<double> sizes;
  for (const Record& record : results.records) sizes.insert(record.light_degrees);
  return {sizes.begin(), sizes.end()};
}

Choice choice_of(const Results& results, const Record& record) {
  return choice_of(record, one_map(results));
}

std::vector<Choice> choices(const Results& results) {
  std::vector<Choice> list;
  const bool same_map = one_map(results);
  for (const Record& record : results.records) {
    Choice choice = choice_of(record, same_map);
    if (std::find(list.begin(), list.end(), choice) == list.end()) list.push_back(std::move(choice));
  }
  return list;
}

const Record* find_record(const Results& results, const std::string& label, const std::string& scene,
                          double light_degrees) {
  const bool same_map = one_map(results);
  const auto found = std::find_if(results.records.begin(), results.records.end(), [&](const Record& record) {
    return record.scene == scene && record.light_degrees == light_degrees &&
           choice_of(record, same_map).label == label;
  });
  return found == results.records.end() ? nullptr : &*found;
}

LightSample sample_of(const Results& results, double light_degrees) {
  std::map<std::string, std::size_t> pixels;  // penumbra pixels of each scene, whoever measures it
  for (const Record& record : results.records) {
    if (record.light_degrees != light_degrees || record.metrics.penumbra_pixels == 0) continue;
    pixels[record.scene] = record.metrics.penumbra_pixels;
  }
  LightSample sample;
  for (const auto& [scene, count] : pixels) {
    sample.smallest_penumbra_pixels =
        sample.scenes == 0 ? count : std::min(sample.smallest_penumbra_pixels, count);
    sample.penumbra_pixels += count;
    ++sample.scenes;
  }
  return sample;
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
  std::vector<Headline> all{{fmt::format("{:.3f}", best.rmse), "lowest penumbra error (RMSE)",
                             best.choice.shown + ", " + cost(best)}};
  if (bargain != &best) {
    all.push_back({fmt::format("{:.3g}", bargain->fetches), "fetches per pixel come within 10 % of it",
                   fmt::format("{}, error {:.3f}", bargain->choice.shown, bargain->rmse)});
  }
  if (&cheapest != &best) {
    all.push_back({fmt::format("{:.3f}", cheapest.rmse), "error of the cheapest technique",
                   cheapest.choice.shown + ", " + cost(cheapest)});
  }
  return all;
}

std::string short_title(const std::string& name, const std::string& title) {
  if (title.empty()) return name;
  const bool has_file = title.starts_with(name + " (") && title.ends_with(")");
  return has_file ? name : title;
}

}  // namespace penumbra::study
