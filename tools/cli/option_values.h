// The values of options. Each function sets the option's placeholder in help, its check and its shell
// completion, so that the three agree.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace penumbra::cli {

// Numbers from the smallest to the largest, inclusive.
CLI::Validator within(double smallest, double largest);
// Numbers greater than 0.
CLI::Validator positive();
// One of these names; another is refused with the nearest.
CLI::Validator one_of(std::vector<std::string> names);

// Rejects an empty value, or an empty one of several: an unset variable of a script is not a file. Must
// precede the option's other checks.
CLI::Option* not_empty(CLI::Option* option);

// The information that these functions store for an option.
struct ValueHint {
  std::string placeholder;                          // "FILE"; empty for a flag
  std::string rule;                                 // "0 .. 30", "table|json"; empty if anything is allowed
  std::vector<std::string> choices;                 // of one_of
  std::optional<std::pair<double, double>> bounds;  // of within
};
ValueHint value_hint(const CLI::Option& option);

// A list: its values are separated by commas, or the option is repeated, or both.
CLI::Option* as_list(CLI::Option* option);
// Repeatable, one value each time: for values that contain commas.
CLI::Option* one_each(CLI::Option* option);
// A number of numbers, separated by spaces or commas.
CLI::Option* as_vector(CLI::Option* option, int least, int most);

// The elements of a list whose elements may be files: a text that is the name of an existing file is not
// split.
std::vector<std::string> names_or_files(const std::vector<std::string>& given);

}  // namespace penumbra::cli
