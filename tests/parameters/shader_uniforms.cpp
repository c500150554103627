#include "parameters/shader_uniforms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "parameters/half_angle.h"

namespace penumbra::parameters {

namespace {

using Real = long double;

constexpr double kLongestMetres = 1e6;
constexpr double kWidestFilterTexels = 64.0;
constexpr double kLargestClump = 8.0;
constexpr double kLargestLightDegrees = 30.0;
constexpr double kLargestConeDegrees = 90.0;

double bounded(double value, double low, double high) {
  return std::isnan(value) ? low : std::clamp(value, low, high);
}

double metres(double value) {
  return bounded(value, 0.0, kLongestMetres);
}

Real bounded_tan_half(double degrees, double largest) {
  return tan_half<Real>(bounded(degrees, 0.0, largest));
}

// HDRP's cones are ordered: the search is never narrower than the light, and the smallest filter is never
// narrower than the search.
struct Cones {
  Real light;
  Real search;
  Real min_filter;
};

Cones cones_of(const SoftShadowParameters& parameters) {
  const Real light = bounded_tan_half(parameters.angular_diameter_degrees, kLargestLightDegrees);
  const Real search = std::max(light, bounded_tan_half(parameters.hdrp_search_degrees, kLargestConeDegrees));
  return {light, search,
          std::max(search, bounded_tan_half(parameters.hdrp_min_filter_degrees, kLargestConeDegrees))};
}

double inverse(Real value) {
  return value > 0 ? static_cast<double>(1 / value) : 0.0;
}

}  // namespace

double tan_half_of(double degrees) {
  return static_cast<double>(bounded_tan_half(degrees, kLargestLightDegrees));
}

double degrees_of(double tan_half) {
  return static_cast<double>(2 * std::atan(Real{tan_half}) * 180 / std::numbers::pi_v<Real>);
}

ShaderUniforms shader_uniforms(const SoftShadowParameters& parameters, const AtlasLayout& layout,
                               int cascades, int frame_index) {
  const Cones cones = cones_of(parameters);
  const int frame = ((frame_index % 64) + 64) % 64;
  return {.atlas_texel_size = {1.0 / layout.width, 1.0 / layout.height, layout.width, layout.height},
          .main_light_params = {cascades, static_cast<double>(cones.light), frame, 0},
          .hdrp_tan_half = {static_cast<double>(cones.search), static_cast<double>(cones.min_filter)}};
}

HdrpVectors hdrp_vectors(const Cascade& cascade, const SoftShadowParameters& parameters) {
  const Cones cones = cones_of(parameters);
  const Real scale = 2 * Real{cascade.uv_per_metre} / cascade.depth_per_metre;
  // Nothing beyond the depth range is a blocker, so at 0 degrees the range is the farthest distance.
  const Real farthest = metres(parameters.max_penumbra_metres) / (2 * cones.light);
  const bool finite = farthest <= std::numeric_limits<float>::max();
  return {.params0 = {static_cast<double>(cones.light * scale), inverse(cones.light * scale),
                      static_cast<double>(finite ? farthest : 1 / Real{cascade.depth_per_metre}),
                      metres(parameters.max_sampling_metres)},
          .params1 = {bounded(parameters.min_filter_texels, 0.0, kWidestFilterTexels),
                      inverse(cones.min_filter * scale), inverse(cones.search * scale),
                      0.5 * bounded(parameters.blocker_clump, 1.0, kLargestClump)}};
}

}  // namespace penumbra::parameters
