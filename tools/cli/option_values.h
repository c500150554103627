// The values of options. Each function sets the option's placeholder in help and its check, so that the two
// agree.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace penumbra::cli {

// Accepts numbers from the smallest to the largest, inclusive.
CLI::Validator within(double smallest, double largest);
// Accepts numbers greater than 0.
CLI::Validator positive();
// Accepts one of these names; another is refused with the nearest.
CLI::Validator one_of(std::vector<std::string> names);

// Rejects an empty value, or an empty one of several: an unset variable of a script is not a file. Must
// precede the option's other checks.
CLI::Option* not_empty(CLI::Option* option);

// The information that these functions store for an option.
struct ValueHint {
  std::string placeholder;                          // "FILE"; empty for a flag
  std::string rule;                                 // "0 .. 30", "table|json"; empty if anything is allowed
  std::optional<std::pair<double, double>> bounds;  // bounds for within()
};
ValueHint value_hint(const CLI::Option& option);

// The option is a list: its values are separated by commas, or the option is repeated, or both.
CLI::Option* as_list(CLI::Option* option);
// The option can be repeated, with one value each time, for values that contain commas.
CLI::Option* one_each(CLI::Option* option);
// The option takes from `least` to `most` numbers, separated by spaces or commas.
CLI::Option* as_vector(CLI::Option* option, int least, int most);

// Returns the elements of a list whose elements may be files: a text that is the name of an existing file is
// not split.
std::vector<std::string> names_or_files(const std::vector<std::string>& given);

}  // namespace penumbra::cli
