#include "study/exits_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "techniques/technique_list.h"

namespace penumbra::study {
namespace {

struct ComparedError {
  const char* name;
  std::optional<double> Metrics::*value;
};

constexpr std::array<ComparedError, 5> kComparedErrors{
    {{"RMSE of all pixels", &Metrics::rmse_all},
     {"RMSE in penumbra", &Metrics::rmse_penumbra},
     {"bias in penumbra", &Metrics::bias},
     {"share of light leaks", &Metrics::leak_rate},
     {"share of false shadow", &Metrics::false_shadow_rate}}};

// A row of several settings is called by its technique and what is set: "tent-5 minFilterTexels=2".
std::string row_with_exits(const std::string& row) {
  const std::size_t end = std::min(row.find(' '), row.size());
  return row.substr(0, end) + techniques::exits_ending + row.substr(end);
}

bool is_of_same_case(const Record& exits, const Record& plain) {
  return exits.technique == row_with_exits(plain.technique) && exits.scene == plain.scene &&
         exits.light_degrees == plain.light_degrees && exits.parameters == plain.parameters &&
         exits.map_size == plain.map_size && exits.map_format == plain.map_format &&
         exits.cascades == plain.cascades && exits.settings == plain.settings && exits.device == plain.device;
}

double apart_by(const std::optional<double>& with, const std::optional<double>& without) {
  if (with.has_value() != without.has_value()) return std::numeric_limits<double>::infinity();
  if (!with) return 0.0;
  const double apart = std::abs(*with - *without);
  return std::isnan(apart) ? std::numeric_limits<double>::infinity() : apart;
}

}  // namespace

std::vector<ExitsDifference> differing_exits(const Results& results) {
  std::vector<ExitsDifference> found;
  for (const Record& exits : results.records) {
    const auto plain = std::find_if(results.records.begin(), results.records.end(),
                                    [&](const Record& other) { return is_of_same_case(exits, other); });
    if (plain == results.records.end()) continue;
    const auto apart = [&](const ComparedError& figure) {
      return apart_by(exits.metrics.*figure.value, plain->metrics.*figure.value);
    };
    const ComparedError& worst = *std::max_element(
        kComparedErrors.begin(), kComparedErrors.end(),
        [&](const ComparedError& a, const ComparedError& b) { return apart(a) < apart(b); });
    if (!(apart(worst) > kExitsTolerance)) continue;
    found.push_back({&exits, &*plain, worst.name, (exits.metrics.*worst.value).value_or(0.0),
                     (plain->metrics.*worst.value).value_or(0.0)});
  }
  return found;
}

}  // namespace penumbra::study
