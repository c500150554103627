#include "parameters/settings_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "parameters/setting_keys.h"

namespace penumbra::parameters {

namespace {

// Collects the first problem only: users correct one at a time, and later ones are often its consequences.
class Inspector {
 public:
  void number(const char* key, double value) {
    const SettingKey& setting = setting_key(key);
    const bool inside = setting.between ? value > setting.smallest && value < setting.largest
                                        : value >= setting.smallest && value <= setting.largest;
    if (inside) return;
    const std::string unit = *setting.unit == '\0' ? "" : std::string(" ") + setting.unit;
    report(key,
           fmt::format("is {}, {} {}{}", value, setting.between ? "not" : "outside", setting.bounds(), unit));
  }

  // `key` names the object that holds the point, where messages should name that.
  void point(const char* key, const char* bounds_of, const glm::dvec3& value) {
    const SettingKey& setting = setting_key(bounds_of);
    for (int axis = 0; axis < 3; ++axis) {
      if (value[axis] >= setting.smallest && value[axis] <= setting.largest) continue;
      report(key, fmt::format("is {}, outside {} {}", value[axis], setting.bounds(), setting.unit));
    }
  }

  void direction(const char* key, const glm::dvec3& value) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(value[axis])) return report(key, "is not finite");
    }
    const double length = glm::length(value);
    if (!(length > 1e-150 && length < 1e150)) {
      report(key, fmt::format("has length {}, so it has no direction", length),
             "any length except zero is valid");
    }
  }

  void report(const char* key, std::string problem, std::string remedy = {}) {
    if (!found_) found_ = SettingProblem{key, std::move(problem), std::move(remedy)};
  }

  bool clean() const { return !found_; }
  std::optional<SettingProblem> take() { return std::move(found_); }

 private:
  std::optional<SettingProblem> found_;
};

void inspect_camera(const Camera& camera, Inspector& inspect) {
  inspect.point("/camera/position", "/camera/position", camera.position);
  inspect.direction("/camera/forward", camera.forward);
  inspect.direction("/camera/up", camera.up);
  if (inspect.clean()) {
    const double sine = glm::length(glm::cross(glm::normalize(camera.forward), glm::normalize(camera.up)));
    if (sine < 1e-6) inspect.report("/camera/up", "is parallel to camera/forward", "use another up vector");
  }
  inspect.number("/camera/fov_y_degrees", camera.fov_y_degrees);
  inspect.number("/camera/aspect", camera.aspect);
  inspect.number("/camera/near", camera.near_plane);
  inspect.number("/camera/far", camera.far_plane);
  if (camera.near_plane >= camera.far_plane) {
    inspect.report("/camera/near", fmt::format("is {} m, not closer than the far plane at {} m",
                                               camera.near_plane, camera.far_plane));
  }
}

void inspect_light(const Light& light, Inspector& inspect) {
  inspect.direction("/light/direction", light.direction);
  inspect.number("/light/angular_diameter_degrees", light.angular_diameter_degrees);
}

void inspect_splits(const Camera& camera, const ShadowSettings& settings, Inspector& inspect) {
  if (!inspect.clean()) return;
  const auto splits = effective_splits(settings);
  const double distance = std::min(settings.distance_metres, camera.far_plane);
  double previous = camera.near_plane / distance;
  for (int i = 0; i + 1 < settings.cascades; ++i) {
    const double split = splits[static_cast<std::size_t>(i)];
    if (!(split > 0.0 && split < 1.0)) {
      inspect.report("/shadows/splits", fmt::format("[{}] is {}, not between 0 and 1", i, split),
                     "splits are fractions of the shadow distance");
    } else if (split <= previous) {
      inspect.report("/shadows/splits",
                     i == 0
                         ? fmt::format("[0] ends cascade 0 at {} m, not farther than the near plane at {} m",
                                       split * distance, camera.near_plane)
                         : fmt::format("[{}] is {}, not greater than {} before it", i, split, previous),
                     "splits increase from the near plane to the shadow distance");
    }
    previous = split;
  }
}

void inspect_bounds(const ShadowSettings& settings, Inspector& inspect) {
  if (settings.fit_to_bounds && !settings.caster_bounds) {
    inspect.report("/shadows/fit_to_bounds", "is set without caster_bounds", "set the bounds to fit to");
  }
  if (!settings.caster_bounds) return;
  inspect.point("/shadows/caster_bounds", "/shadows/caster_bounds/min", settings.caster_bounds->minimum);
  inspect.point("/shadows/caster_bounds", "/shadows/caster_bounds/max", settings.caster_bounds->maximum);
  for (int axis = 0; axis < 3; ++axis) {
    if (settings.caster_bounds->minimum[axis] > settings.caster_bounds->maximum[axis]) {
      inspect.report("/shadows/caster_bounds",
                     fmt::format("has a minimum of {} above its maximum of {} on {}",
                                 settings.caster_bounds->minimum[axis], settings.caster_bounds->maximum[axis],
                                 "xyz"[axis]));
    }
  }
  if (settings.depth_range_metres) {
    inspect.report("/shadows/caster_bounds",
                   "is given together with depth_range_metres; only one can set the range",
                   "remove one of them");
  }
}

void inspect_shadows(const Camera& camera, const ShadowSettings& settings, Inspector& inspect) {
  inspect.number("/shadows/distance_metres", settings.distance_metres);
  if (settings.distance_metres <= camera.near_plane) {
    inspect.report("/shadows/distance_metres",
                   fmt::format("is {} m, not farther than the camera's near plane at {} m",
                               settings.distance_metres, camera.near_plane));
  }
  inspect.number("/shadows/cascades", settings.cascades);
  inspect.number("/shadows/resolution", settings.resolution);
  inspect.number("/shadows/depth_bias", settings.depth_bias);
  inspect.number("/shadows/normal_bias", settings.normal_bias);
  inspect.number("/shadows/near_plane_offset_metres", settings.near_plane_offset_metres);
  if (settings.depth_range_metres) {
    inspect.number("/shadows/depth_range_metres", *settings.depth_range_metres);
  }
  inspect_splits(camera, settings, inspect);
  inspect_bounds(settings, inspect);
}

}  // namespace

std::optional<SettingProblem> find_problem(const Camera& camera, const Light& light,
                                           const ShadowSettings& settings) {
  Inspector inspect;
  inspect_camera(camera, inspect);
  inspect_light(light, inspect);
  inspect_shadows(camera, settings, inspect);
  return inspect.take();
}

}  // namespace penumbra::parameters
