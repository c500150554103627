// What every room throws for input a person can mend: exit code 2 at the command line.
#pragma once

#include <stdexcept>
#include <string>

#include "input/visible_text.h"

namespace penumbra {

// where: "file", "file:line" or "file:line:column", or empty when the input has no place of its own.
// what() is "where: problem" followed, when there is one, by "\n  way out", with control characters as
// escapes (visible_text.h): names and texts of untrusted files stand in all three. The way out may have
// several lines.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& where, const std::string& problem, const std::string& way_out = {})
      : std::runtime_error(visible(where.empty() ? problem : where + ": " + problem) +
                           (way_out.empty() ? "" : "\n  " + visible_lines(way_out))) {}
};

// A missing device, package root or program: exit code 3.
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace penumbra
