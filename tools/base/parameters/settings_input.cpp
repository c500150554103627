#include "parameters/settings_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "input/input_error.h"
#include "input/located_json.h"
#include "input/nearest_name.h"
#include "parameters/settings_check.h"

namespace penumbra::parameters {

namespace {

template <typename Value>
using Names = std::vector<std::pair<std::string, Value>>;

const Names<SoftQuality>& soft_quality_names() {
  static const Names<SoftQuality> names = {{"off", SoftQuality::off},
                                           {"low", SoftQuality::low},
                                           {"medium", SoftQuality::medium},
                                           {"high", SoftQuality::high}};
  return names;
}

const Names<ClipDepth>& clip_depth_names() {
  static const Names<ClipDepth> names = {{"zero_to_one", ClipDepth::zero_to_one},
                                         {"minus_one_to_one", ClipDepth::minus_one_to_one}};
  return names;
}

template <typename Value>
const Value* find_named(const Names<Value>& names, const std::string& name) {
  const auto found = std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == name; });
  return found == names.end() ? nullptr : &found->second;
}

template <typename Value>
std::string remedy(const Names<Value>& names, const std::string& given) {
  std::vector<std::string> known;
  for (const auto& name : names) known.push_back(name.first);
  return unknown_name_remedy(given, known);
}

template <typename Value>
const char* find_name(const Names<Value>& names, Value value) {
  for (const auto& name : names) {
    if (name.second == value) return name.first.c_str();
  }
  return "";
}

template <typename Value>
Value named(const Names<Value>& names, const char* kind, const std::string& name) {
  if (const Value* value = find_named(names, name)) return *value;
  throw InputError("", fmt::format("unknown {} '{}'", kind, name), remedy(names, name));
}

template <typename Value>
Value read_named(const Names<Value>& names, JsonObject& object, const std::string& key, Value fallback) {
  const std::string text = object.text(key, find_name(names, fallback));
  if (const Value* value = find_named(names, text)) return *value;
  object.fail(key, fmt::format("unknown value '{}'", text), remedy(names, text));
}

glm::dvec3 read_vector(JsonObject& object, const std::string& key, const glm::dvec3& fallback) {
  if (!object.has(key)) return fallback;
  const std::vector<double> numbers = object.numbers(key, 3);
  return {numbers[0], numbers[1], numbers[2]};
}

Camera read_camera(JsonObject object) {
  Camera camera;
  camera.position = read_vector(object, "position", camera.position);
  camera.forward = read_vector(object, "forward", camera.forward);
  camera.up = read_vector(object, "up", camera.up);
  camera.fov_y_degrees = object.number("fov_y_degrees", camera.fov_y_degrees);
  camera.aspect = object.number("aspect", camera.aspect);
  camera.near_plane = object.number("near", camera.near_plane);
  camera.far_plane = object.number("far", camera.far_plane);
  object.finish();
  return camera;
}

Light read_light(JsonObject object) {
  Light light;
  light.direction = read_vector(object, "direction", light.direction);
  light.angular_diameter_degrees = object.number("angular_diameter_degrees", light.angular_diameter_degrees);
  object.finish();
  return light;
}

// The list has as many splits as cascades have inner ends; or three, as Unity's asset always holds, of which
// those in use count.
void read_splits(const LocatedJson& document, JsonObject& object, ShadowSettings& shadows) {
  if (!object.has("splits")) return;
  const auto& given = document.at(LocatedJson::Pointer("/shadows/splits"));
  const auto needed = static_cast<std::size_t>(std::clamp(shadows.cascades, 1, 4) - 1);
  const std::size_t count = given.is_array() && given.size() == 3 ? 3 : needed;
  const std::vector<double> numbers = object.numbers("splits", count);
  if (needed == 0) return;
  std::copy(numbers.begin(), numbers.end(), shadows.splits.begin());
  if (shadows.splits == std::array<double, 3>{}) {
    object.fail("splits", "are all zero", "leave the key out for URP's defaults");
  }
}

std::optional<Bounds> read_bounds(JsonObject& object) {
  if (!object.has("caster_bounds")) return std::nullopt;
  JsonObject bounds = object.object("caster_bounds");
  for (const char* key : {"min", "max"}) {
    if (!bounds.has(key)) object.fail("caster_bounds", fmt::format("has no '{}'", key), "give min and max");
  }
  const Bounds result{read_vector(bounds, "min", {}), read_vector(bounds, "max", {})};
  bounds.finish();
  return result;
}

ShadowSettings read_shadows(const LocatedJson& document, JsonObject object) {
  ShadowSettings shadows;
  shadows.distance_metres = object.number("distance_metres", shadows.distance_metres);
  shadows.cascades = object.integer("cascades", shadows.cascades);
  read_splits(document, object, shadows);
  shadows.resolution = object.integer("resolution", shadows.resolution);
  shadows.depth_bias = object.number("depth_bias", shadows.depth_bias);
  shadows.normal_bias = object.number("normal_bias", shadows.normal_bias);
  shadows.soft_quality = read_soft_quality(object, "soft_quality", shadows.soft_quality);
  shadows.reversed_z = object.boolean("reversed_z", shadows.reversed_z);
  shadows.clip_depth = read_clip_depth(object, "clip_depth", shadows.clip_depth);
  if (object.has("depth_range_metres")) shadows.depth_range_metres = object.number("depth_range_metres", 0.0);
  shadows.caster_bounds = read_bounds(object);
  shadows.fit_to_bounds = object.boolean("fit_to_bounds", shadows.fit_to_bounds);
  shadows.near_plane_offset_metres =
      object.number("near_plane_offset_metres", shadows.near_plane_offset_metres);
  object.finish();
  return shadows;
}

// Returns the place of a setting: its own, or that of the nearest enclosing object that the file holds.
std::string place_of(const LocatedJson& document, const std::string& key) {
  LocatedJson::Pointer pointer(key);
  while (!pointer.empty() && !document.value().contains(pointer)) pointer.pop_back();
  return document.where(pointer);
}

}  // namespace

FitInput read_settings(const LocatedJson& document) {
  JsonObject root(document);
  const FitInput input{read_camera(root.object("camera")), read_light(root.object("light")),
                       read_shadows(document, root.object("shadows"))};
  root.finish();
  if (const auto problem = find_problem(input.camera, input.light, input.shadows)) {
    throw InputError(place_of(document, problem->key), problem->key.substr(1) + " " + problem->problem,
                     problem->remedy);
  }
  return input;
}

SoftQuality soft_quality_named(const std::string& name) {
  return named(soft_quality_names(), "soft quality", name);
}
ClipDepth clip_depth_named(const std::string& name) {
  return named(clip_depth_names(), "clip depth convention", name);
}
const char* name_of(SoftQuality quality) {
  return find_name(soft_quality_names(), quality);
}
const char* name_of(ClipDepth convention) {
  return find_name(clip_depth_names(), convention);
}

SoftQuality read_soft_quality(JsonObject& object, const std::string& key, SoftQuality fallback) {
  return read_named(soft_quality_names(), object, key, fallback);
}
ClipDepth read_clip_depth(JsonObject& object, const std::string& key, ClipDepth fallback) {
  return read_named(clip_depth_names(), object, key, fallback);
}

}  // namespace penumbra::parameters
