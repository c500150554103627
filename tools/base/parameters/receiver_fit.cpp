#include "parameters/receiver_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "input/input_error.h"
#include "parameters/half_angle.h"
#include "parameters/split_tiles.h"

namespace penumbra::parameters {
namespace {

// A shader selects cascades in floats: receivers this near to a sphere, relative to its radius, may be on
// either side of it.
constexpr double kSphereTolerance = 1e-4;
// Texels are at most this many times smaller than the sphere's: one receiver alone has no size.
constexpr double kLargestGain = 64.0;
// The margin is a share of the depth range: the farthest receiver must not be at the far plane, which counts
// as unshadowed.
constexpr double kFarMargin = 1e-3;

// The area that a filter may read for one receiver, in light space: a disc.
struct Footprint {
  glm::dvec2 centre;
  double radius = 0.0;
};

struct Square {
  LightAxes axes;
  glm::dvec2 centre;
  double half_extent = 0.0;
};

double next_size(double half_extent) {
  return std::exp2(std::ceil(std::log2(half_extent) * kSizesPerOctave - 1e-9) / kSizesPerOctave);
}

LightAxes turned(const LightAxes& axes, double radians) {
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  return {c * axes.right + s * axes.up, c * axes.up - s * axes.right, axes.forward};
}

// Returns the square around all footprints, whose centres are given without the turn.
Square square_around(const std::vector<Footprint>& footprints, const LightAxes& axes, double radians) {
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  glm::dvec2 low(HUGE_VAL);
  glm::dvec2 high(-HUGE_VAL);
  for (const Footprint& print : footprints) {
    const glm::dvec2 centre(c * print.centre.x + s * print.centre.y, c * print.centre.y - s * print.centre.x);
    low = glm::min(low, centre - print.radius);
    high = glm::max(high, centre + print.radius);
  }
  return {turned(axes, radians), 0.5 * (low + high), 0.5 * std::max(high.x - low.x, high.y - low.y)};
}

// A quarter turn leaves a square as it is.
Square smallest_square(const std::vector<Footprint>& footprints, const LightAxes& axes, bool turns,
                       double smallest_half_extent) {
  std::optional<Square> best;
  for (double degrees = 0.0; degrees < (turns ? 90.0 : kTurnDegrees); degrees += kTurnDegrees) {
    Square square = square_around(footprints, axes, degrees * std::numbers::pi / 180.0);
    square.half_extent = next_size(std::max(square.half_extent, smallest_half_extent));
    if (!best || square.half_extent < best->half_extent) best = square;
  }
  return *best;
}

// Returns the receivers of a cascade: those in its sphere and in none before it.
std::vector<glm::dvec3> receivers_of(const std::vector<SplitTile>& tiles, std::size_t cascade,
                                     std::span<const glm::dvec3> receivers) {
  const auto holds = [](const SplitSphere& sphere, const glm::dvec3& point, double scale) {
    return glm::distance(sphere.centre, point) < sphere.radius * scale;
  };
  std::vector<glm::dvec3> own;
  for (const glm::dvec3& receiver : receivers) {
    const auto before = tiles.begin() + static_cast<std::ptrdiff_t>(cascade);
    if (holds(tiles[cascade].sphere, receiver, 1.0 + kSphereTolerance) &&
        std::none_of(tiles.begin(), before, [&](const SplitTile& tile) {
          return holds(tile.sphere, receiver, 1.0 - kSphereTolerance);
        }))
      own.push_back(receiver);
  }
  return own;
}

void tighten(const std::vector<glm::dvec3>& receivers, const Light& light, const ShadowSettings& settings,
             bool turns, SplitTile& tile) {
  if (receivers.empty()) return;
  TileBox& box = tile.box;
  std::vector<Footprint> footprints;
  double farthest = -HUGE_VAL;
  for (const glm::dvec3& receiver : receivers) {
    const glm::dvec3 at = tile.axes.into(receiver);
    const double gap = std::max(at.z - box.near_depth, 0.0);
    footprints.push_back({glm::dvec2(at), tan_half(light.angular_diameter_degrees) * gap});
    farthest = std::max(farthest, at.z);
  }
  if (!settings.depth_range_metres) {
    const double far_depth =
        std::min(box.far_depth, farthest + kFarMargin * (box.far_depth - box.near_depth));
    if (far_depth > box.near_depth) box.far_depth = far_depth;
  }
  const Square square = smallest_square(footprints, tile.axes, turns, tile.sphere.radius / kLargestGain);
  if (square.half_extent >= box.half_extent) return;
  tile.axes = square.axes;
  box.centre = square.centre;
  box.half_extent = square.half_extent;
  box.margin_texels = kSnapMarginTexels + kKernelMarginTexels;
}

// The camera's frustum begins at the nearest receiver, and the settings' shadows end at the farthest.
struct SeenRange {
  Camera camera;
  ShadowSettings settings;
};

SeenRange seen_range(const Camera& camera, const ShadowSettings& settings,
                     std::span<const glm::dvec3> receivers) {
  SeenRange seen{camera, settings};
  double nearest = HUGE_VAL;
  double farthest = 0.0;
  const glm::dvec3 forward = glm::normalize(camera.forward);
  for (const glm::dvec3& receiver : receivers) {
    const double depth = glm::dot(receiver - camera.position, forward);
    if (depth < camera.near_plane || depth > settings.distance_metres) continue;
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  if (!(nearest < farthest)) return seen;
  // The distances take the steps of the tile's size, outwards.
  seen.camera.near_plane = std::clamp(1.0 / next_size(1.0 / nearest), camera.near_plane, nearest);
  seen.settings.distance_metres = std::min(next_size(farthest), settings.distance_metres);
  // Splits are fractions of the distance; here they are fractions of the part between both distances.
  seen.settings.splits = effective_splits(settings);
  const double begin = seen.camera.near_plane / seen.settings.distance_metres;
  for (double& split : seen.settings.splits) split = begin + (1.0 - begin) * split;
  return seen;
}

CascadeSet fit_to(const Camera& camera, const Light& light, const ShadowSettings& settings, bool turns,
                  std::span<const glm::dvec3> receivers) {
  std::vector<SplitTile> tiles = split_tiles(camera, light, settings);
  for (std::size_t i = 0; i < tiles.size(); ++i)
    tighten(receivers_of(tiles, i, receivers), light, settings, turns, tiles[i]);
  return placed(tiles, light, settings);
}

void require_finite(std::span<const glm::dvec3> receivers) {
  for (const glm::dvec3& receiver : receivers) {
    if (std::isfinite(receiver.x) && std::isfinite(receiver.y) && std::isfinite(receiver.z)) continue;
    throw InputError("", "a receiver's position is not finite", "leave out pixels that show no surface");
  }
}

}  // namespace

std::string_view name_of(LightFit fit) {
  switch (fit) {
    case LightFit::sphere:
      return "sphere";
    case LightFit::casters:
      return "casters";
    case LightFit::receivers:
      return "receivers";
    case LightFit::turned_receivers:
      return "turned-receivers";
    case LightFit::turned_receivers_range:
      return "turned-receivers-range";
  }
  return "sphere";
}

std::optional<LightFit> light_fit_named(std::string_view name) {
  for (const LightFit fit : kLightFits)
    if (name_of(fit) == name) return fit;
  return std::nullopt;
}

CascadeSet fit_cascades(const Camera& camera, const Light& light, const ShadowSettings& settings,
                        LightFit fit, std::span<const glm::dvec3> receivers) {
  require_finite(receivers);
  switch (fit) {
    case LightFit::sphere:
      return fit_cascades(camera, light, settings);
    case LightFit::casters: {
      ShadowSettings tight = settings;
      tight.fit_to_bounds = settings.caster_bounds.has_value();
      return fit_cascades(camera, light, tight);
    }
    case LightFit::receivers:
      return fit_to(camera, light, settings, false, receivers);
    case LightFit::turned_receivers:
      return fit_to(camera, light, settings, true, receivers);
    case LightFit::turned_receivers_range: {
      const SeenRange seen = seen_range(camera, settings, receivers);
      return fit_to(seen.camera, light, seen.settings, true, receivers);
    }
  }
  return fit_cascades(camera, light, settings);
}

}  // namespace penumbra::parameters
