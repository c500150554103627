#include "parameters/setting_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "parameters/cascades.h"
#include "parameters/settings_input.h"

namespace penumbra::parameters {
namespace {

// Beyond these limits a float of the emitted matrices overflows, or a texel is too small for a float.
constexpr double kLongest = 1e9;
constexpr double kShortest = 1e-6;

std::string text_of(const glm::dvec3& v) {
  return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

std::string text_of(double number) {
  return fmt::format("{:.6g}", number);
}

std::vector<SettingKey> camera_keys() {
  const Camera camera;
  return {
      {"/camera/position", "3 numbers", "m", -kLongest, kLongest, false, text_of(camera.position),
       "--position", "camera position"},
      {"/camera/forward", "3 numbers", "", 0, 0, false, text_of(camera.forward), "--forward",
       "viewing direction; any length except 0"},
      {"/camera/up", "3 numbers", "", 0, 0, false, text_of(camera.up), "",
       "the camera's up vector, not parallel to forward"},
      {"/camera/fov_y_degrees", "number", "degrees", 0, 180, true, text_of(camera.fov_y_degrees), "--fov",
       "vertical field of view, full angle"},
      {"/camera/aspect", "number", "", 1e-3, 1e3, false, text_of(camera.aspect), "--aspect",
       "aspect ratio, width / height"},
      {"/camera/near", "number", "m", kShortest, kLongest, false, text_of(camera.near_plane), "--near",
       "near plane, closer than the far plane"},
      {"/camera/far", "number", "m", kShortest, kLongest, false, text_of(camera.far_plane), "--far",
       "far plane"},
  };
}

std::vector<SettingKey> light_keys() {
  const Light light;
  return {
      {"/light/direction", "3 numbers", "", 0, 0, false, text_of(light.direction), "--light-direction",
       "direction in which the light travels; any length except 0"},
      {"/light/angular_diameter_degrees", "number", "degrees", 0, 30, false,
       text_of(light.angular_diameter_degrees), "--light", "angular diameter of the light's disc"},
  };
}

std::vector<SettingKey> shadow_keys() {
  const ShadowSettings shadows;
  const auto truth = [](bool value) { return std::string(value ? "true" : "false"); };
  return {
      {"/shadows/distance_metres", "number", "m", kShortest, kLongest, false,
       text_of(shadows.distance_metres), "--distance", "shadow distance, farther than the near plane"},
      {"/shadows/cascades", "whole number", "", 1, 4, false, fmt::format("{}", shadows.cascades),
       "--cascades", "number of cascades"},
      {"/shadows/splits", "up to 3 numbers", "", 0, 1, true, "URP's", "--splits",
       "ends of all cascades except the last, as increasing fractions of the shadow distance"},
      {"/shadows/resolution", "whole number", "texels", 8, 16384, false,
       fmt::format("{}", shadows.resolution), "--map-size", "width of the cascade atlas"},
      {"/shadows/depth_bias", "number", "", 0, 1e3, false, text_of(shadows.depth_bias), "--depth-bias",
       "URP's depth bias setting"},
      {"/shadows/normal_bias", "number", "", 0, 1e3, false, text_of(shadows.normal_bias), "--normal-bias",
       "URP's normal bias setting"},
      {"/shadows/soft_quality", "name", "", 0, 0, false, name_of(shadows.soft_quality), "--soft-quality",
       "off, low, medium or high: URP's soft shadow quality, which scales both biases"},
      {"/shadows/reversed_z", "true or false", "", 0, 0, false, truth(shadows.reversed_z), "--reversed-z",
       "whether depth is reversed: 1 near the light"},
      {"/shadows/clip_depth", "name", "", 0, 0, false, name_of(shadows.clip_depth), "--clip-depth",
       "zero_to_one or minus_one_to_one: clip-space depth range of the printed projections"},
      {"/shadows/depth_range_metres", "number", "m", kShortest, kLongest, false, "computed", "--depth-range",
       "depth range of every cascade; not together with caster_bounds"},
      {"/shadows/caster_bounds", "object", "", 0, 0, false, "none", "",
       "world-space bounding box of all shadow casters, which sets the depth range"},
      {"/shadows/caster_bounds/min", "3 numbers", "m", -kLongest, kLongest, false, "required", "",
       "minimum corner"},
      {"/shadows/caster_bounds/max", "3 numbers", "m", -kLongest, kLongest, false, "required", "",
       "maximum corner"},
      {"/shadows/fit_to_bounds", "true or false", "", 0, 0, false, truth(shadows.fit_to_bounds), "",
       "whether the cascades are also fitted to caster_bounds"},
      {"/shadows/near_plane_offset_metres", "number", "m", 0, kLongest, false,
       text_of(shadows.near_plane_offset_metres), "",
       "Unity's shadow near plane offset, added in front of the cascade's bounding sphere"},
  };
}

using Row = std::array<std::string, 7>;

std::string line_of(const Row& row, const std::array<std::size_t, 7>& widths) {
  std::string line = "|";
  for (std::size_t i = 0; i < row.size(); ++i) line += fmt::format(" {:{}} |", row[i], widths[i]);
  return line + "\n";
}

std::string code(const std::string& text) {
  return text.empty() ? "" : "`" + text + "`";
}

}  // namespace

std::string SettingKey::bounds() const {
  if (!has_bounds()) return "";
  return between ? fmt::format("between {} and {}", smallest, largest)
                 : fmt::format("{} .. {}", smallest, largest);
}

const std::vector<SettingKey>& setting_keys() {
  static const std::vector<SettingKey> keys = [] {
    std::vector<SettingKey> all = camera_keys();
    for (const auto& more : {light_keys(), shadow_keys()}) all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return keys;
}

const SettingKey& setting_key(std::string_view key) {
  for (const SettingKey& setting : setting_keys())
    if (setting.key == key) return setting;
  throw std::out_of_range("unknown setting " + std::string(key));
}

std::string setting_keys_table() {
  std::vector<Row> rows{{"key", "type", "unit", "default", "bounds", "option", "meaning"}};
  for (const SettingKey& key : setting_keys()) {
    std::string path = std::string(key.key).substr(1);
    std::replace(path.begin(), path.end(), '/', '.');
    rows.push_back({code(path), key.type, key.unit, key.preset, key.bounds(), code(key.flag), key.meaning});
  }
  std::array<std::size_t, 7> widths{};
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  Row rule;
  for (std::size_t i = 0; i < rule.size(); ++i) rule[i] = std::string(widths[i], '-');
  std::string table = line_of(rows.front(), widths) + line_of(rule, widths);
  for (std::size_t i = 1; i < rows.size(); ++i) table += line_of(rows[i], widths);
  return table;
}

}  // namespace penumbra::parameters
