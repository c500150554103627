// The soft shadows of other engines are transcribed from their descriptions in double precision and in their
// own terms: world space, their directions of depth, their divisions. They are the answers of
// peer_filter_test.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/frame.h"

namespace penumbra::resolve::testing_peers {

using glm::dvec2;
using glm::dvec3;

struct Receiver {
  dvec3 position;
  dvec3 normal;        // unit
  double noise = 0.0;  // [0, 1)
};

// The shader's floats may have moved a receiver by this much: its place in the map, its noise.
struct Shift {
  dvec2 texels{0.0};
  double depth = 0.0;
  double noise = 0.0;
};

struct Answer {
  double visibility = 1.0;
  int fetches = 0;
};

// One tile of the map, in texels of the atlas and in distances from the near plane, 0 to 1.
class Tile {
 public:
  Tile(const scene::Frame& frame, int cascade, double angular_diameter_degrees)
      : frame_(frame),
        cascade_(frame.cascades.cascades.at(static_cast<std::size_t>(cascade))),
        tan_half(std::tan(angular_diameter_degrees * M_PI / 360.0)),
        range(1.0 / cascade_.depth_per_metre),
        texel(cascade_.texel_size_metres),
        to_light(-frame.cascades.light_direction),
        size(frame.atlas.width, frame.atlas.height),
        low(dvec2(cascade_.offset_scale.x, cascade_.offset_scale.y) * size),
        high(low + dvec2(cascade_.offset_scale.z, cascade_.offset_scale.w) * size) {}

  // The texels and the distance of a world position.
  dvec3 projected(dvec3 position) const {
    const glm::dvec4 shadow = cascade_.world_to_shadow * glm::dvec4(position, 1.0);
    return {shadow.x * size.x, shadow.y * size.y, frame_.cascades.reversed_z ? 1.0 - shadow.z : shadow.z};
  }
  // The world's direction of the map's axis.
  dvec3 axis(int row) const {
    const auto& m = cascade_.world_to_shadow;
    return glm::normalize(dvec3(m[0][row], m[1][row], m[2][row]));
  }
  double distance_at(int x, int y) const {
    const auto stored =
        static_cast<double>(frame_.atlas.depth[static_cast<std::size_t>(y * frame_.atlas.width + x)]);
    return frame_.cascades.reversed_z ? 1.0 - stored : stored;
  }
  dvec2 clamped(dvec2 texels) const { return glm::clamp(texels, low + 0.5, high - 0.5); }
  bool inside(dvec2 texels) const { return clamped(texels) == texels; }
  double nearest(dvec2 texels) const {
    return distance_at(static_cast<int>(std::floor(texels.x)), static_cast<int>(std::floor(texels.y)));
  }
  // Interpolates any function of the texels bilinearly; the four of them lie in the tile.
  double bilinear(dvec2 texels, const std::function<double(double)>& of_distance) const {
    const dvec2 at = clamped(texels) - 0.5;
    const dvec2 corner = glm::min(glm::floor(at), high - 2.0);
    const dvec2 f = at - corner;
    const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
    const auto value = [&](int dx, int dy) { return of_distance(distance_at(x + dx, y + dy)); };
    return (1.0 - f.y) * ((1.0 - f.x) * value(0, 0) + f.x * value(1, 0)) +
           f.y * ((1.0 - f.x) * value(0, 1) + f.x * value(1, 1));
  }

 private:
  const scene::Frame& frame_;
  const parameters::Cascade& cascade_;

 public:
  const double tan_half;
  const double range;  // metres of the depth range
  const double texel;  // metres
  const dvec3 to_light;
  const dvec2 size, low, high;
};

inline dvec2 turned(dvec2 point, double noise) {
  const double angle = 2.0 * M_PI * noise;
  return {point.x * std::cos(angle) - point.y * std::sin(angle),
          point.x * std::sin(angle) + point.y * std::cos(angle)};
}

// ---- Godot 4: depth 0 at the near plane.

struct GodotSettings {
  int samples = 8;
  double angular_size_degrees = 0.5;  // angular size of the light
  double shadow_bias = 0.1;
  double shadow_normal_bias = 2.0;
};

inline Answer godot(const Tile& tile, const Receiver& receiver, const Shift& shift,
                    const GodotSettings& settings) {
  dvec3 vertex = receiver.position;
  vertex += tile.to_light * (settings.shadow_bias / 100.0 * tile.range);
  dvec3 bias = receiver.normal * (1.0 - std::max(0.0, glm::dot(tile.to_light, -receiver.normal))) *
               (settings.shadow_normal_bias * tile.texel);
  bias -= tile.to_light * glm::dot(tile.to_light, bias);
  const dvec3 coord = tile.projected(vertex + bias) + dvec3(shift.texels, shift.depth);
  const double noise = receiver.noise + shift.noise;

  const double range_position = coord.z * tile.range;
  double scale = range_position * std::tan(settings.angular_size_degrees * M_PI / 180.0) / tile.texel;
  const auto tap = [&](int i) {
    const double radius = std::sqrt(i + 0.5) / std::sqrt(settings.samples);
    return dvec2(coord) + turned(dvec2(std::cos(2.4 * i), std::sin(2.4 * i)) * radius, noise) * scale;
  };
  Answer answer{1.0, settings.samples};
  double count = 0.0, average = 0.0;
  for (int i = 0; i < settings.samples; ++i) {
    const double depth = tile.bilinear(tap(i), [](double distance) { return distance; });
    if (depth < coord.z) {
      average += depth;
      count += 1.0;
    }
  }
  if (count == 0.0) return answer;
  average /= count;
  scale *= (coord.z - average) / average;
  double lit = 0.0;
  for (int i = 0; i < settings.samples; ++i)
    lit += tile.bilinear(tap(i), [&](double distance) { return coord.z <= distance ? 1.0 : 0.0; });
  return {lit / settings.samples, 2 * settings.samples};
}

// ---- Filament: depth 1 at the near plane.

inline constexpr std::array<dvec2, 16> kPoisson{
    dvec2(0.511749, 0.547686),  dvec2(0.58929, 0.257224),    dvec2(0.165018, 0.57663),
    dvec2(0.407692, 0.742285),  dvec2(0.707012, 0.646523),   dvec2(0.31463, 0.466825),
    dvec2(0.801257, 0.485186),  dvec2(0.418136, 0.146517),   dvec2(0.579889, 0.0368284),
    dvec2(0.79801, 0.140114),   dvec2(-0.0413185, 0.371455), dvec2(-0.0529108, 0.627352),
    dvec2(0.0821375, 0.882071), dvec2(0.17308, 0.301207),    dvec2(-0.120452, 0.867216),
    dvec2(0.371096, 0.916454)};

struct FilamentSettings {
  int search_taps = 16;
  int filter_taps = 16;  // 0: DPCF
  double bulb_radius_metres = 0.02;
};

// The receiver's plane by the chain rule over two neighbours on it, as its screen derivatives have them. Its
// slopes are per texel.
inline dvec2 receiver_plane(const Tile& tile, const Receiver& receiver) {
  const dvec3 right = glm::normalize(glm::cross(receiver.normal, tile.axis(1)));
  const dvec3 down = glm::cross(receiver.normal, right);
  const dvec3 here = tile.projected(receiver.position);
  const dvec3 x = tile.projected(receiver.position + right) - here;
  const dvec3 y = tile.projected(receiver.position + down) - here;
  const double determinant = x.x * y.y - x.y * y.x;
  // The slopes are of reversed depth.
  return -dvec2(x.z * y.y - x.y * y.z, x.x * y.z - x.z * y.x) / determinant;
}

inline double hardened(double x) {
  x = 2.0 * x - 1.0;
  const double s = x < 0.0 ? -1.0 : x > 0.0 ? 1.0 : 0.0;
  x = 1.0 - s * x;
  x = x * x * x;
  x = s - x * s;
  return 0.5 * x + 0.5;
}

inline Answer filament(const Tile& tile, const Receiver& receiver, const Shift& shift,
                       const FilamentSettings& settings) {
  const double cosine = std::clamp(glm::dot(receiver.normal, tile.to_light), 0.0, 1.0);
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const dvec3 moved = receiver.position + receiver.normal * (sine * 0.5 * tile.texel);
  const dvec3 coord = tile.projected(moved) + dvec3(shift.texels, shift.depth);
  const dvec2 dz_duv = receiver_plane(tile, receiver);
  // The casters' offset, polygonOffsetSlope 2, is seen from a receiver on the same surface.
  const double z_rec = 1.0 - coord.z + 2.0 * std::max(std::abs(dz_duv.x), std::abs(dz_duv.y));
  const double noise = receiver.noise + shift.noise;
  const double bulb = settings.bulb_radius_metres / tile.texel;

  Answer answer{1.0, settings.search_taps};
  double count = 0.0, sum = 0.0;
  for (int i = 0; i < settings.search_taps; ++i) {
    const dvec2 duv = turned(kPoisson[static_cast<std::size_t>(i)] * bulb, noise);
    const double z_occ = 1.0 - tile.nearest(tile.clamped(dvec2(coord) + duv));
    if (z_occ - z_rec >= glm::dot(dz_duv, duv)) {
      count += 1.0;
      sum += z_occ;
    }
  }
  if (sum == 0.0) return answer;
  const double z_blocker = sum / count;
  const double ratio = (z_blocker - z_rec) / (1.0 - z_blocker);
  if (settings.filter_taps == 0) {
    const double share = count / settings.search_taps;
    const double soft = std::clamp(ratio, 0.0, 1.0);
    answer.visibility = 1.0 - (hardened(share) * (1.0 - soft) + share * soft);
    return answer;
  }
  double occluded = 0.0;
  for (int i = 0; i < settings.filter_taps; ++i) {
    const dvec2 duv = turned(kPoisson[static_cast<std::size_t>(i)] * (bulb * ratio), noise);
    const double z_bias = glm::dot(dz_duv, duv);
    occluded += tile.bilinear(dvec2(coord) + duv,
                              [&](double distance) { return 1.0 - distance - z_rec >= z_bias ? 1.0 : 0.0; });
  }
  return {1.0 - occluded / settings.filter_taps, settings.search_taps + settings.filter_taps};
}

// ---- Unreal's SMRT: depth 1 at the near plane.

struct SmrtSettings {
  int rays = 7;
  int samples_per_ray = 8;
  double ray_length_scale = 1.5;
  double texel_dither_scale = 2.0;
  double extrapolate_max_slope_metres = 0.05;
  double normal_bias = 0.5;
};

inline double fraction(double x) {
  return x - std::floor(x);
}

inline dvec2 concentric_disk(dvec2 square) {
  const dvec2 s = 2.0 * square - 1.0;
  if (s == dvec2(0.0)) return s;
  const double radius = std::max(std::abs(s.x), std::abs(s.y));
  // The square is gone through by octants, counterclockwise from +x, each of its sides an eighth of a turn
  // and back.
  double eighths = 0.0;
  if (std::abs(s.x) > std::abs(s.y)) {
    eighths = s.x > 0.0 ? s.y / radius : 4.0 - s.y / radius;
  } else {
    eighths = s.y > 0.0 ? 2.0 - s.x / radius : 6.0 + s.x / radius;
  }
  return radius * dvec2(std::cos(eighths * M_PI / 4.0), std::sin(eighths * M_PI / 4.0));
}

struct SmrtRay {
  dvec3 start;  // texels, depth
  dvec3 step;   // step over the whole ray
  double extrapolate_slope;
};

inline bool smrt_hit(const Tile& tile, const SmrtRay& ray, int steps, double offset, int& fetches) {
  const double scale = -1.0 / steps;
  const double bias = 1.0 + (1.0 - offset) * scale;
  bool has_history = false;
  double history = 0.0, history_time = 0.0, slope = 0.0, previous_reference = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double linear = scale * i + bias;
    const double time = i == steps ? 0.0 : linear * linear;
    dvec3 at = ray.start + ray.step * time;
    if (i == steps) at = dvec3(tile.clamped(dvec2(at)), at.z);
    if (!tile.inside(dvec2(at))) continue;  // Unreal goes on in a coarser level
    ++fetches;
    const double sample = 1.0 - tile.nearest(dvec2(at));
    const double reference = at.z;
    if (!has_history) {
      has_history = true;
      history = sample;
      history_time = time;
      if (sample > reference) return true;
    } else {
      const double tolerance = std::abs(reference - previous_reference) * 1.05;
      const bool behind = sample - reference > tolerance;
      double compared = sample;
      if (behind) {
        compared = slope * (time - history_time) + history;
      } else if (sample != history) {
        slope = std::clamp((sample - history) / (time - history_time), -ray.extrapolate_slope,
                           ray.extrapolate_slope);
        history = sample;
        history_time = time;
      }
      const double half = 0.5 * tolerance;
      if (std::abs(reference - compared + half) < half) return true;
    }
    previous_reference = reference;
  }
  return false;
}

inline Answer smrt(const Tile& tile, const Receiver& receiver, const Shift& shift,
                   const SmrtSettings& settings) {
  const double view_distance = 0.5 * (tile.high.x - tile.low.x) * tile.texel;
  const dvec3 origin =
      receiver.position + receiver.normal * std::max(0.0002, settings.normal_bias / 1000.0 * view_distance);
  const dvec3 coord = tile.projected(origin) + dvec3(shift.texels, shift.depth);
  const dvec2 depth_slope = receiver_plane(tile, receiver);
  const double noise = receiver.noise + shift.noise;
  const auto random = [&](int n) {
    return dvec2(fraction(noise + n * 0.754877669), fraction(fraction(29.0 * noise) + n * 0.569840296));
  };
  const double length = settings.ray_length_scale * view_distance;
  Answer answer{0.0, 0};
  double misses = 0.0;
  for (int i = 0; i < settings.rays; ++i) {
    const dvec2 disk = concentric_disk(random(i)) * tile.tan_half;
    const dvec3 direction = tile.to_light + tile.axis(0) * disk.x + tile.axis(1) * disk.y;
    const dvec3 end = tile.projected(origin + direction * length);
    const dvec3 step = end - tile.projected(origin);
    const dvec2 texels = (random(i + settings.rays) - 0.5) * (0.5 * settings.texel_dither_scale);
    SmrtRay ray{dvec3(dvec2(coord) + texels, 1.0 - coord.z), dvec3(dvec2(step), -step.z),
                settings.extrapolate_max_slope_metres / tile.range};
    ray.start.z += 2.0 * std::max(0.0, glm::dot(depth_slope, texels));
    if (!smrt_hit(tile, ray, settings.samples_per_ray, fraction(11.0 * noise), answer.fetches)) misses += 1.0;
  }
  answer.visibility = misses / settings.rays;
  return answer;
}

}  // namespace penumbra::resolve::testing_peers
