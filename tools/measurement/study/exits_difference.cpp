#include "study/exits_difference.h"

#include <algorithm>
#include <cmath>

#include "techniques/technique_list.h"

namespace penumbra::study {
namespace {

bool differ(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b) return a.has_value() != b.has_value();
  return !(std::abs(*a - *b) <= kExitsTolerance);
}

bool is_of_same_case(const Record& exits, const Record& plain) {
  return exits.technique == plain.technique + techniques::exits_ending && exits.scene == plain.scene &&
         exits.light_degrees == plain.light_degrees && exits.parameters == plain.parameters &&
         exits.map_size == plain.map_size && exits.map_format == plain.map_format &&
         exits.cascades == plain.cascades && exits.settings == plain.settings && exits.device == plain.device;
}

}  // namespace

std::vector<ExitsDifference> differing_exits(const Results& results) {
  std::vector<ExitsDifference> found;
  for (const Record& exits : results.records) {
    const auto plain = std::find_if(results.records.begin(), results.records.end(),
                                    [&](const Record& other) { return is_of_same_case(exits, other); });
    if (plain == results.records.end()) continue;
    const Metrics& with = exits.metrics;
    const Metrics& without = plain->metrics;
    if (differ(with.rmse_all, without.rmse_all) || differ(with.rmse_penumbra, without.rmse_penumbra))
      found.push_back({&exits, &*plain});
  }
  return found;
}

}  // namespace penumbra::study
