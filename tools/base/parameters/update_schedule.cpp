#include "parameters/update_schedule.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <stdexcept>
#include <string>

#include "input/input_error.h"

namespace penumbra::parameters {
namespace {

void check(std::span<const int> periods) {
  if (periods.empty() || periods.size() > kMostScheduled)
    throw InputError("", std::to_string(periods.size()) + " periods", "one for each of one to four cascades");
  for (const int period : periods) {
    if (period >= 1 && period <= kLongestPeriod && std::has_single_bit(static_cast<unsigned>(period)))
      continue;
    throw InputError("", "a period of " + std::to_string(period) + " frames",
                     "periods are powers of two from 1 to " + std::to_string(kLongestPeriod));
  }
}

std::size_t checked(int cascade, int count) {
  if (cascade < 0 || cascade >= count)
    throw std::out_of_range("cascade " + std::to_string(cascade) + " of " + std::to_string(count));
  return static_cast<std::size_t>(cascade);
}

int remainder_of(int frame, int period) {
  return ((frame % period) + period) % period;
}

// Returns the phase at which the fewest of the cascades so far are due in any frame; of several the first.
int least_loaded(const std::array<int, kLongestPeriod>& load, int period) {
  int best = 0;
  int fewest = kMostScheduled + 1;
  for (int phase = 0; phase < period; ++phase) {
    int most = 0;
    for (int frame = phase; frame < kLongestPeriod; frame += period)
      most = std::max(most, load[static_cast<std::size_t>(frame)]);
    if (most >= fewest) continue;
    fewest = most;
    best = phase;
  }
  return best;
}

}  // namespace

int UpdateSchedule::age(int cascade, int frame) const {
  const std::size_t at = checked(cascade, cascades);
  return remainder_of(frame - phases.at(at), periods.at(at));
}

int UpdateSchedule::due(int frame) const {
  int bits = 0;
  for (int i = 0; i < cascades; ++i) bits |= is_due(i, frame) ? 1 << i : 0;
  return bits;
}

int UpdateSchedule::most_due() const {
  int most = 0;
  for (int frame = 0; frame < kLongestPeriod; ++frame)
    most = std::max(most, std::popcount(static_cast<unsigned>(due(frame))));
  return most;
}

double UpdateSchedule::mean_due() const {
  double mean = 0.0;
  for (int i = 0; i < cascades; ++i) mean += 1.0 / periods.at(static_cast<std::size_t>(i));
  return mean;
}

double UpdateSchedule::largest_age_degrees(int cascade, double degrees_per_frame) const {
  return (periods.at(checked(cascade, cascades)) - 1) * degrees_per_frame;
}

UpdateSchedule update_schedule(std::span<const int> periods) {
  check(periods);
  UpdateSchedule schedule;
  schedule.cascades = static_cast<int>(periods.size());
  std::copy(periods.begin(), periods.end(), schedule.periods.begin());
  // The shortest periods come first: a longer one always fits into a gap that shorter ones left.
  std::array<int, kMostScheduled> order{};
  std::iota(order.begin(), order.end(), 0);
  const auto used = order.begin() + schedule.cascades;
  std::stable_sort(order.begin(), used, [&](int a, int b) {
    return periods[static_cast<std::size_t>(a)] < periods[static_cast<std::size_t>(b)];
  });
  std::array<int, kLongestPeriod> load{};
  for (auto cascade = order.begin(); cascade != used; ++cascade) {
    const auto at = static_cast<std::size_t>(*cascade);
    schedule.phases.at(at) = least_loaded(load, periods[at]);
    for (int frame = schedule.phases.at(at); frame < kLongestPeriod; frame += periods[at])
      ++load[static_cast<std::size_t>(frame)];
  }
  return schedule;
}

}  // namespace penumbra::parameters
