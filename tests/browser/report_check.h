// Opens a report as a reader would, in headless Chromium, and tells what went wrong in there.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra::browser {

struct PageCheck {
  std::vector<std::string> problems;  // errors of scripts, console and policy; broken pictures; empty charts
  int images = 0;                     // <img> elements that were looked at
  int charts = 0;                     // inline <svg> elements
  int buttons = 0;                    // pressed one after the other, twice each

  bool passed() const { return problems.empty(); }
};

// Opens a copy of the page with a probe script put first in its head; the file itself is not touched. No
// network is used. Throws EnvironmentError when Chromium is missing (with the line that installs it) or gives
// no answer within a minute, InputError when the file cannot be read or has no <head>.
PageCheck check_page(const std::filesystem::path& html_file);

}  // namespace penumbra::browser
