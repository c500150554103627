#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "cli/subcommand.h"
#include "platform/terminal.h"

namespace penumbra::cli {
namespace {

using Clock = std::chrono::steady_clock;

std::string with_si_prefix(double value) {
  static constexpr const char* kPrefixes[] = {"", "k", "M", "G", "T"};
  std::size_t prefix = 0;
  while (value >= 1000.0 && prefix + 1 < std::size(kPrefixes)) {
    value /= 1000.0;
    ++prefix;
  }
  return fmt::format("{:.3g} {}", value, kPrefixes[prefix]);
}

std::string duration(double seconds) {
  const int whole = static_cast<int>(std::min(seconds, 359999.0));
  return whole < 60 ? fmt::format("{} s", whole) : fmt::format("{} min {:02} s", whole / 60, whole % 60);
}

}  // namespace

struct Progress::State {
  std::string label;
  bool shown = false;
  bool drawn = false;
  Clock::time_point start = Clock::now();
  Clock::time_point last{};
  double done_at_start = -1.0;  // resumed work does not count towards the rate
};

Progress::Progress(const Context& context, std::string label) : state_(new State) {
  state_->label = std::move(label);
  state_->shown = !context.quiet && platform::stderr_is_terminal();
}

Progress::~Progress() {
  if (state_->drawn) std::fputs("\r\x1b[K", stderr);
  delete state_;
}

void Progress::update(double done, double total, std::string_view unit) {
  if (!state_->shown || total <= 0.0) return;
  if (state_->done_at_start < 0.0) state_->done_at_start = done;
  const Clock::time_point now = Clock::now();
  if (now - state_->last < std::chrono::milliseconds(100) && done < total) return;
  state_->last = now;
  state_->drawn = true;

  constexpr int kWidth = 24;
  const double fraction = std::clamp(done / total, 0.0, 1.0);
  const int filled = static_cast<int>(fraction * kWidth);
  const double seconds = std::chrono::duration<double>(now - state_->start).count();
  const double rate = seconds > 0.0 ? (done - state_->done_at_start) / seconds : 0.0;
  std::string line = fmt::format("\r\x1b[K{} [{}{}] {:3.0f} %", state_->label, std::string(filled, '#'),
                                 std::string(kWidth - filled, '.'), 100.0 * fraction);
  if (rate > 0.0) {
    line += fmt::format("  {}{}/s  {} left", with_si_prefix(rate), unit, duration((total - done) / rate));
  }
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace penumbra::cli
