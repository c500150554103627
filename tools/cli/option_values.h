// What an option's value may be. Each function gives the option its place-holder in help, its check and what
// a shell completes, so that the three agree.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace penumbra::cli {

// Numbers from the smallest to the largest, both allowed.
CLI::Validator within(double smallest, double largest);
// Numbers greater than 0.
CLI::Validator positive();
// One of these names; another is refused with the nearest.
CLI::Validator one_of(std::vector<std::string> names);

// The option's value, or each of several, is refused where it is empty: an unset variable of a script is no
// file. Comes before the option's other checks.
CLI::Option* not_empty(CLI::Option* option);

// What those said of an option.
struct ValueHint {
  std::string placeholder;                          // "FILE"; empty for a flag
  std::string rule;                                 // "0 .. 30", "table|json"; empty where anything goes
  std::vector<std::string> choices;                 // of one_of
  std::optional<std::pair<double, double>> bounds;  // of within
};
ValueHint value_hint(const CLI::Option& option);

// A list: its values are parted by commas, or the option is repeated, or both.
CLI::Option* as_list(CLI::Option* option);
// Repeatable, one value each time: for values that have commas of their own.
CLI::Option* one_each(CLI::Option* option);
// So many numbers, parted by blanks or commas.
CLI::Option* as_vector(CLI::Option* option, int least, int most);

// The elements of a list whose elements may be files: a text that is the name of a file is no list.
std::vector<std::string> names_or_files(const std::vector<std::string>& given);

}  // namespace penumbra::cli
