// Thrown by every folder for invalid input that the user can correct: exit code 2 at the command line.
#pragma once

#include <stdexcept>
#include <string>

#include "input/visible_text.h"

namespace penumbra {

// `where` is "file", "file:line" or "file:line:column", or empty if the input has no location. what() is
// "where: problem" followed, if there is a way out, by "\n  way out", with control characters escaped
// (visible_text.h), because all three may contain text of untrusted files. The way out may have several
// lines.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& where, const std::string& problem, const std::string& remedy = {})
      : std::runtime_error(visible(where.empty() ? problem : where + ": " + problem) +
                           (remedy.empty() ? "" : "\n  " + visible_lines(remedy))) {}
};

// Thrown for a missing device, package root or program: exit code 3.
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace penumbra
