#include "cli/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "platform/terminal.h"

namespace penumbra::cli {
namespace {

std::string with_si_prefix(double value) {
  static constexpr const char* kPrefixes[] = {"", "k", "M", "G", "T"};
  std::size_t prefix = 0;
  while (value >= 1000.0 && prefix + 1 < std::size(kPrefixes)) {
    value /= 1000.0;
    ++prefix;
  }
  return fmt::format("{:.3g} {}{}", value, kPrefixes[prefix], prefix == 0 ? "" : " ");
}

std::string duration(double seconds) {
  const int whole = static_cast<int>(std::min(seconds, 359999.0));
  return whole < 60 ? fmt::format("{} s", whole) : fmt::format("{} min {:02} s", whole / 60, whole % 60);
}

double seconds_between(ProgressOutlet::Clock::time_point start, ProgressOutlet::Clock::time_point end) {
  return std::chrono::duration<double>(end - start).count();
}

}  // namespace

ProgressOutlet::ProgressOutlet()
    : bar(platform::stderr_is_terminal()), write([](std::string_view text) {
        std::fwrite(text.data(), 1, text.size(), stderr);
        std::fflush(stderr);
      }) {}

Progress::Progress(std::shared_ptr<ProgressOutlet> outlet, std::string label)
    : outlet_(std::move(outlet)), label_(std::move(label)) {
  if (outlet_) start_ = outlet_->now();
}

Progress::~Progress() {
  if (drawn_ != ProgressOutlet::Clock::time_point{}) outlet_->write("\r\x1b[K");
}

void Progress::update(double done, double total, std::string_view unit) {
  if (!outlet_ || total <= 0.0) return;
  if (done_at_start_ < 0.0) done_at_start_ = done;
  unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
  if (outlet_->bar) {
    draw_bar(done, total, unit);
  } else {
    write_line(done, total, unit);
  }
}

void Progress::draw_bar(double done, double total, std::string_view unit) {
  const auto now = outlet_->now();
  if (now - drawn_ < std::chrono::milliseconds(100) && done < total) return;
  drawn_ = now;

  constexpr int kWidth = 24;
  const double fraction = std::clamp(done / total, 0.0, 1.0);
  const int filled = static_cast<int>(fraction * kWidth);
  const double seconds = seconds_between(start_, now);
  const double rate = seconds > 0.0 ? (done - done_at_start_) / seconds : 0.0;
  std::string line = fmt::format("\r\x1b[K{} [{}{}] {:3.0f} %", label_, std::string(filled, '#'),
                                 std::string(kWidth - filled, '.'), 100.0 * fraction);
  if (rate > 0.0) {
    line += fmt::format("  {}{}/s  {} left", with_si_prefix(rate), unit, duration((total - done) / rate));
  }
  outlet_->write(line);
}

void Progress::write_line(double done, double total, std::string_view unit) {
  const auto now = outlet_->now();
  if (now - outlet_->last_line < kProgressLineInterval) return;
  outlet_->last_line = now;
  outlet_->write(fmt::format("penumbra: {}: {:.12g}/{:.12g}{}{} ({:.0f} %), {}\n", label_, done, total,
                             unit.empty() ? "" : " ", unit, 100.0 * std::clamp(done / total, 0.0, 1.0),
                             duration(seconds_between(outlet_->started, now))));
}

}  // namespace penumbra::cli
