#include "parameters/spot_light.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "input/input_error.h"
#include "parameters/half_angle.h"
#include "parameters/light_axes.h"
#include "parameters/setting_keys.h"

namespace penumbra::parameters {
namespace {

constexpr double kFarthestMetres = 1e9;  // metres
constexpr double kNearestMetres = 1e-6;
constexpr double kWidestDegrees = 179.0;

void check_range(const char* what, double value, double smallest, double largest, const char* unit) {
  if (value >= smallest && value <= largest) return;
  throw InputError("", fmt::format("the spot light's {} is {}, outside {} .. {} {}", what, value, smallest,
                                   largest, unit));
}

void check_setting(const char* key, double value) {
  const SettingKey& setting = setting_key(key);
  if (value >= setting.smallest && value <= setting.largest) return;
  throw InputError("",
                   fmt::format("{} is {}, outside {} {}", key + 1, value, setting.bounds(), setting.unit));
}

glm::dmat4 from_rows(const glm::dvec4& x, const glm::dvec4& y, const glm::dvec4& z, const glm::dvec4& w) {
  glm::dmat4 matrix(1.0);
  for (int column = 0; column < 4; ++column) matrix[column] = {x[column], y[column], z[column], w[column]};
  return matrix;
}

// Stored depth times w is first * w + second.
struct DepthLine {
  double first;
  double second;
};

DepthLine depth_line(const SpotShadow& shadow) {
  const double near = shadow.light.shadow_near_plane_metres, far = shadow.light.range_metres;
  if (shadow.reversed_z) return {-near / (far - near), near * far / (far - near)};
  return {far / (far - near), -near * far / (far - near)};
}

void place_matrices(SpotShadow& shadow, double tan_half) {
  const LightAxes axes = axes_of(shadow.light.direction);
  const glm::dvec3 eye = axes.into(shadow.light.position);
  const double near = shadow.light.shadow_near_plane_metres, far = shadow.light.range_metres;
  shadow.view = from_rows(glm::dvec4(axes.right, -eye.x), glm::dvec4(axes.up, -eye.y),
                          glm::dvec4(-axes.forward, eye.z), {0, 0, 0, 1});
  const glm::dvec4 depth =
      shadow.clip_depth == ClipDepth::zero_to_one
          ? glm::dvec4(0, 0, -far / (far - near), -near * far / (far - near))
          : glm::dvec4(0, 0, -(far + near) / (far - near), -2.0 * near * far / (far - near));
  shadow.projection = from_rows({1.0 / tan_half, 0, 0, 0}, {0, 1.0 / tan_half, 0, 0}, depth, {0, 0, -1, 0});

  // This is (u, v) = 1/2 + across / (2 tan w), written out so that no product of matrices rounds in between.
  const glm::dvec4 w(axes.forward, -eye.z);
  const DepthLine line = depth_line(shadow);
  shadow.world_to_shadow = from_rows(glm::dvec4(axes.right, -eye.x) * shadow.uv_per_tangent + 0.5 * w,
                                     glm::dvec4(axes.up, -eye.y) * shadow.uv_per_tangent + 0.5 * w,
                                     line.first * w + glm::dvec4(0, 0, 0, line.second), w);
}

}  // namespace

double SpotShadow::stored_depth(double axial_metres) const {
  const DepthLine line = depth_line(*this);
  return line.first + line.second / axial_metres;
}

double SpotShadow::axial_depth(double stored) const {
  const DepthLine line = depth_line(*this);
  return line.second / (stored - line.first);
}

double penumbra_radius_metres(const SpotLight& light, double receiver_metres, double blocker_metres) {
  return light.source_radius_metres * (receiver_metres - blocker_metres) / blocker_metres;
}

void check_spot_light(const SpotLight& light) {
  for (int axis = 0; axis < 3; ++axis)
    check_range("position", light.position[axis], -kFarthestMetres, kFarthestMetres, "m");
  const double length = glm::length(light.direction);
  if (!(length > 1e-150 && length < 1e150)) {
    throw InputError("", "the spot light's direction is zero or not finite",
                     "give the direction in which the light travels");
  }
  check_range("outer angle", light.outer_angle_degrees, 1.0, kWidestDegrees, "degrees");
  check_range("inner angle", light.inner_angle_degrees, 0.0, light.outer_angle_degrees, "degrees");
  check_range("guard angle", light.shadow_guard_degrees, 0.0, kWidestDegrees - light.outer_angle_degrees,
              "degrees");
  check_range("range", light.range_metres, kNearestMetres, kFarthestMetres, "m");
  check_range("source radius", light.source_radius_metres, 0.0, light.range_metres, "m");
  check_range("shadow near plane", light.shadow_near_plane_metres, kNearestMetres, kFarthestMetres, "m");
  if (light.shadow_near_plane_metres < light.range_metres) return;
  throw InputError(
      "", fmt::format("the spot light's shadow near plane is at {} m, not closer than its range of {} m",
                      light.shadow_near_plane_metres, light.range_metres));
}

SpotShadow spot_shadow(const SpotLight& light, const ShadowSettings& settings) {
  check_spot_light(light);
  check_setting("/shadows/resolution", settings.resolution);
  check_setting("/shadows/depth_bias", settings.depth_bias);
  check_setting("/shadows/normal_bias", settings.normal_bias);
  SpotShadow shadow;
  shadow.reversed_z = settings.reversed_z;
  shadow.clip_depth = settings.clip_depth;
  shadow.light = light;
  shadow.light.direction = glm::normalize(light.direction);
  shadow.resolution = settings.resolution;
  const double tan_half = parameters::tan_half(light.outer_angle_degrees + light.shadow_guard_degrees);
  shadow.uv_per_tangent = 0.5 / tan_half;
  place_matrices(shadow, tan_half);
  // The formula is w / d_r = R (1 / d_b - 1 / d_r), and 1 / d is linear in the stored depth.
  const double radial = light.source_radius_metres * shadow.uv_per_tangent;
  const double depth = std::abs(depth_line(shadow).second);
  shadow.depth_to_radial = radial / depth;
  if (radial > 0.0) shadow.radial_to_depth = depth / radial;
  const double texel =
      parameters::tan_half(light.outer_angle_degrees) * light.range_metres / settings.resolution;
  const double kernel = kernel_radius_texels(settings.soft_quality) * texel;
  shadow.depth_bias_metres = 0.0 - settings.depth_bias * kernel;
  shadow.normal_bias_metres = 0.0 - settings.normal_bias * kernel;
  return shadow;
}

}  // namespace penumbra::parameters
