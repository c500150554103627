// The list of settings is what the reader of --config reads, with the defaults and bounds that are in force.
#include "parameters/setting_keys.h"

#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "input/input_error.h"
#include "input/located_json.h"
#include "parameters/settings_input.h"

namespace penumbra::parameters {
namespace {

using testing::HasSubstr;
using testing::Not;

using Pointer = nlohmann::json::json_pointer;

std::string refusal(const nlohmann::json& settings) {
  try {
    read_settings(LocatedJson::parse(settings.dump(), "config.json"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// Settings with values that no other setting contradicts.
nlohmann::json with(const SettingKey& setting, double value) {
  const std::string key = setting.key;
  nlohmann::json settings = nlohmann::json::object();
  if (key == "/camera/near") settings["camera"]["far"] = 1e9;
  if (key == "/camera/far" || key == "/shadows/distance_metres") settings["camera"]["near"] = 1e-6;
  if (key == "/shadows/splits") settings["shadows"]["cascades"] = 2;
  if (key.starts_with("/shadows/caster_bounds/"))
    settings["shadows"]["caster_bounds"] = {{"min", {-1e9, -1e9, -1e9}}, {"max", {1e9, 1e9, 1e9}}};
  const std::string type = setting.type;
  if (type == "3 numbers") {
    settings[Pointer(key)] = {value, value, value};
  } else if (type == "up to 3 numbers") {
    settings[Pointer(key)] = nlohmann::json::array({value});
  } else {
    settings[Pointer(key)] = value;
  }
  return settings;
}

TEST(SettingKeys, AreThoseThatTheReaderKnows) {
  std::map<std::string, std::set<std::string>> listed;
  for (const SettingKey& setting : setting_keys()) {
    const Pointer pointer(setting.key);
    listed[pointer.parent_pointer().to_string()].insert(pointer.back());
  }
  for (const auto& [section, keys] : listed) {
    nlohmann::json settings;
    if (section == "/shadows/caster_bounds")
      settings["shadows"]["caster_bounds"] = {{"min", {0, 0, 0}}, {"max", {1, 1, 1}}};
    settings[Pointer(section)]["qqqqqqqqqqqqqqqqqqqqqqqqqqqq"] =
        1;  // a key near nothing, so that the message names every key
    const std::string message = refusal(settings);
    const std::size_t start = message.find("known are:");
    ASSERT_NE(start, std::string::npos) << message;
    std::istringstream words(message.substr(start + 10));
    std::set<std::string> read;
    for (std::string word; words >> word;) read.insert(word);
    EXPECT_EQ(read, keys) << section;
  }
}

TEST(SettingKeys, BoundsAreThoseInForce) {
  int bounded = 0;
  for (const SettingKey& setting : setting_keys()) {
    if (!setting.has_bounds()) continue;
    ++bounded;
    const double step = std::string(setting.type) == "whole number" ? 1.0 : 1e-9 + 1e-9 * setting.largest;
    for (const double bound : {setting.smallest, setting.largest}) {
      const double outward = bound == setting.smallest ? -step : step;
      const std::string at = refusal(with(setting, bound));
      const std::string beyond = refusal(with(setting, bound + outward));
      if (setting.between) {
        EXPECT_THAT(at, testing::AnyOf(HasSubstr("not between"), HasSubstr("are all zero"))) << setting.key;
      } else {
        EXPECT_THAT(at, Not(HasSubstr("outside"))) << setting.key;
        EXPECT_THAT(beyond, HasSubstr("outside " + setting.bounds())) << setting.key;
      }
    }
  }
  EXPECT_GT(bounded, 12);
}

TEST(SettingKeys, DefaultsAreThoseOfTheReader) {
  for (const SettingKey& setting : setting_keys()) {
    const nlohmann::json value = nlohmann::json::parse(setting.preset, nullptr, false);
    if (value.is_discarded()) continue;  // the value is a word such as "none"
    nlohmann::json settings;
    settings[Pointer(setting.key)] = value;
    EXPECT_EQ(refusal(settings), "") << setting.key;
  }
  const FitInput input = read_settings(LocatedJson::parse("{}", "config.json"));
  EXPECT_EQ(setting_key("/camera/fov_y_degrees").preset,
            std::to_string(static_cast<int>(input.camera.fov_y_degrees)));
  EXPECT_EQ(setting_key("/shadows/soft_quality").preset, name_of(input.shadows.soft_quality));
}

TEST(SettingKeys, AnUnknownKeyNamesTheOneThatItIsAPartOf) {
  EXPECT_THAT(refusal({{"camera", {{"fov", 60}}}}), HasSubstr("did you mean 'fov_y_degrees'?"));
  EXPECT_THAT(refusal({{"light", {{"angular_diameter", 1}}}}), HasSubstr("'angular_diameter_degrees'"));
  EXPECT_THAT(refusal({{"shadows", {{"distance", 1}}}}), HasSubstr("'distance_metres'"));
  EXPECT_THAT(refusal({{"shadow", 1}}), HasSubstr("'shadows'"));
}

}  // namespace
}  // namespace penumbra::parameters
