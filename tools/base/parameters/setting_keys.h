// Every key of a --config file: its meaning, type, unit, default and bounds. The code that checks settings,
// reads flags and prints help takes the bounds from here.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penumbra::parameters {

struct SettingKey {
  const char* key;  // JSON pointer in the file: "/camera/fov_y_degrees"
  const char*
      type;  // "number", "whole number", "3 numbers", "up to 3 numbers", "true or false", "name", "object"
  const char* unit;  // empty if there is none
  double smallest;   // smallest of a number, and of each of several; both bounds are allowed ...
  double largest;
  bool between;        // ... unless this is set
  std::string preset;  // the default as text
  std::string flag;    // flag of `penumbra constants`; empty where only the file has it
  const char* meaning;

  bool has_bounds() const { return smallest < largest; }
  std::string bounds() const;  // "0 .. 30", "between 0 and 180", or empty
};

// The keys are in the order of the documentation; defaults are those of Camera, Light and ShadowSettings.
const std::vector<SettingKey>& setting_keys();

const SettingKey& setting_key(std::string_view key);  // throws std::out_of_range for an unknown key

// Returns all of them as a Markdown table, aligned so that it can be read as it stands.
std::string setting_keys_table();

}  // namespace penumbra::parameters
