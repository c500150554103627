#include "cli/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "cli/option_text.h"
#include "input/nearest_name.h"

namespace penumbra::cli {
namespace {

constexpr std::string_view kTo = " .. ";

double number_or_nan(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return text.empty() || *end != '\0' ? std::numeric_limits<double>::quiet_NaN() : value;
}

}  // namespace

CLI::Validator within(double smallest, double largest) {
  const std::string rule = fmt::format("{}{}{}", smallest, kTo, largest);
  const auto check = [=](std::string& text) {
    const double value = number_or_nan(text);
    if (std::isnan(value)) return fmt::format("'{}' is not a number", text);
    return value >= smallest && value <= largest ? std::string() : text + " is outside " + rule;
  };
  return {check, rule};
}

CLI::Validator positive() {
  const auto check = [](std::string& text) {
    const double value = number_or_nan(text);
    if (std::isnan(value)) return fmt::format("'{}' is not a number", text);
    return value > 0.0 && std::isfinite(value) ? std::string() : text + " is not greater than 0";
  };
  return {check, "greater than 0"};
}

CLI::Validator one_of(std::vector<std::string> names) {
  std::string rule = fmt::format("{}", fmt::join(names, "|"));
  const auto check = [names = std::move(names)](std::string& text) {
    if (std::find(names.begin(), names.end(), text) != names.end()) return std::string();
    return fmt::format("unknown value '{}'\n  {}", text, unknown_name_remedy(text, names));
  };
  return {check, std::move(rule)};
}

CLI::Option* not_empty(CLI::Option* option) {
  const auto check = [](std::string& text) { return std::string(text.empty() ? "is empty" : ""); };
  return option->transform(CLI::Validator(check, ""));
}

ValueHint value_hint(const CLI::Option& option) {
  ValueHint hint;
  if (option.get_items_expected_max() == 0) return hint;
  const std::string text = option.get_type_name();  // CLI11 sets each validator's description after a colon
  // A colon in brackets belongs to the placeholder.
  const std::size_t colon = text.find(':', text.find(']') == std::string::npos ? 0 : text.rfind(']'));
  hint.placeholder = text.substr(0, colon);
  if (colon == std::string::npos) return hint;
  hint.rule = text.substr(colon + 1);
  if (const std::size_t to = hint.rule.find(kTo); to != std::string::npos) {
    hint.bounds = {number_or_nan(hint.rule.substr(0, to)), number_or_nan(hint.rule.substr(to + kTo.size()))};
  }
  return hint;
}

CLI::Option* as_list(CLI::Option* option) {
  return option->delimiter(',')->allow_extra_args(false);
}

CLI::Option* one_each(CLI::Option* option) {
  return option->allow_extra_args(false);
}

CLI::Option* as_vector(CLI::Option* option, int least, int most) {
  return option->delimiter(',')->expected(least, most);
}

std::vector<std::string> names_or_files(const std::vector<std::string>& given) {
  std::vector<std::string> names;
  for (const std::string& text : given) {
    std::error_code none;
    if (std::filesystem::exists(text, none)) {
      names.push_back(text);
      continue;
    }
    for (std::string& name : split(text, ','))
      if (!name.empty()) names.push_back(std::move(name));
  }
  return names;
}

}  // namespace penumbra::cli
