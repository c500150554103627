// Progress of long work, on standard error: a bar on a terminal, a line every ten seconds in a file or a CI
// system's log, nothing with --quiet.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace penumbra::cli {

// The output of progress; there is one for a whole run, whose stages follow each other.
struct ProgressOutlet {
  using Clock = std::chrono::steady_clock;

  bool bar = false;  // a bar, else lines
  std::function<Clock::time_point()> now = Clock::now;
  std::function<void(std::string_view)> write;
  Clock::time_point started = Clock::now();
  Clock::time_point last_line = started;

  ProgressOutlet();  // writes to standard error
};

inline constexpr std::chrono::seconds kProgressLineInterval{10};

// A stage of the work. A line reads "penumbra: LABEL: 120/400 shaders (30 %), 1 min 20 s", the time being
// that since the start of the run. update() writes it when it is due, so update() must be called at least as
// often.
class Progress {
 public:
  // Without an outlet, nothing is written.
  Progress(std::shared_ptr<ProgressOutlet> outlet, std::string label);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // `unit` names the things that are counted.
  void update(double done, double total, std::string_view unit = "");

 private:
  void draw_bar(double done, double total, std::string_view unit);
  void write_line(double done, double total, std::string_view unit);

  std::shared_ptr<ProgressOutlet> outlet_;
  std::string label_;
  ProgressOutlet::Clock::time_point start_;
  ProgressOutlet::Clock::time_point drawn_{};
  double done_at_start_ = -1.0;  // resumed work does not count towards the rate
};

}  // namespace penumbra::cli
