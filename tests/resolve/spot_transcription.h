// FilterPcssSpot in double, written from its description: blockers in the cone of rays to the source, the
// mean of their gaps, and the lit share of a disc as wide as that mean's penumbra. One slice is the whole
// map.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "parameters/disk.h"

namespace penumbra::testing_spot {

struct Light {
  double near_metres, far_metres, tan_half, source_radius;
};

struct Settings {
  int blocker_samples, filter_samples;
  double min_filter_texels, max_penumbra_metres;
};

// The receiver as the shader was given it: UV and stored depth, depth per UV, the rotation's cosine and sine.
struct Receiver {
  glm::dvec2 uv;
  double depth;
  glm::dvec2 gradient;
  glm::dvec2 rotation;
};

class Filter {
 public:
  // texel(x, y) is the stored depth, conventional or reversed.
  Filter(const Light& light, const Settings& settings, int texels, bool reversed_z,
         std::function<double(int, int)> texel)
      : light_(light),
        settings_(settings),
        texels_(texels),
        towards_(reversed_z ? 1.0 : -1.0),
        nearest_(reversed_z ? 1.0 : 0.0),
        texel_(std::move(texel)),
        directions_(parameters::fibonacci_directions(64)) {}

  double visibility(const Receiver& receiver) {
    place(receiver);
    const Blockers found = search();
    if (found.count == 0.0) return 1.0;
    const double penumbra = std::min({found.gap * texels_per_depth_, double(texels_), search_radius_});
    const double radius = std::max(penumbra - 0.5, smallest_);
    const bool narrow = radius <= 1.25;
    double visibility = 1.0;
    if (narrow || found.low > 0.0) {
      const double low_gap = std::min(2.0 / texels_per_depth_, 0.25 * found.gap);
      visibility = block(std::min(radius, 1.25), narrow ? 2.0 : low_gap, found.cone_height);
    }
    if (!narrow && visibility > 0.0)
      visibility = std::min(visibility, disc(radius, radius - penumbra + 1.5, found.cone_height));
    return visibility;
  }

 private:
  struct Texel {
    double gap, above_plane, radius, weight;
  };
  struct Blockers {
    double gap = 0.0, count = 0.0, cone_height = 0.0, low = 0.0;
  };

  void place(const Receiver& receiver) {
    receiver_ = receiver;
    centre_ = receiver.uv * double(texels_);
    // 1 / d_b - 1 / d_r is the stored gap times the range of 1 / d, and gives the source's half angle.
    const double range = 1.0 / light_.near_metres - 1.0 / light_.far_metres;
    const double above_far = towards_ > 0 ? receiver.depth : 1.0 - receiver.depth;
    const double metres = 1.0 / (1.0 / light_.far_metres + above_far * range);
    texels_per_depth_ = light_.source_radius * range / (2.0 * light_.tan_half) * texels_;
    smallest_ = settings_.min_filter_texels;
    const double widest = settings_.max_penumbra_metres / 2.0 * texels_ / (2.0 * light_.tan_half * metres);
    const double nearest_gap = std::max(0.0, towards_ * (nearest_ - receiver.depth));
    search_radius_ =
        std::min(std::max(std::min(nearest_gap * texels_per_depth_, widest), smallest_), double(texels_));
    tangent_ = (receiver.uv - 0.5) * (2.0 * light_.tan_half);
    cosine_ = 1.0 / std::sqrt(1.0 + glm::dot(tangent_, tangent_));
    highest_cone_ = 1e6 / (range * metres * metres);
  }

  // The image of a point of a circle, which is 1 / cosine longer away from the axis.
  glm::dvec2 stretched(const glm::dvec2& point) const {
    const double length = glm::length(tangent_);
    if (length == 0.0) return point;
    const glm::dvec2 away = tangent_ / length;
    return point + away * glm::dot(away, point) * (1.0 / cosine_ - 1.0);
  }

  double circle_radius(const glm::dvec2& offset) const {
    const double length = glm::length(tangent_);
    if (length == 0.0) return glm::length(offset);
    const glm::dvec2 away = tangent_ / length;
    const double along = glm::dot(away, offset) * cosine_, across = away.x * offset.y - away.y * offset.x;
    return std::hypot(along, across);
  }

  // The 2 x 2 texels around the corner nearest to a place.
  std::array<Texel, 4> quad(const glm::dvec2& at) const {
    const auto corner_of = [&](double x) { return std::clamp(std::floor(x + 0.5), 1.0, texels_ - 1.0); };
    const glm::dvec2 corner(corner_of(at.x), corner_of(at.y));
    const glm::dvec2 share = glm::clamp(at - corner + 0.5, 0.0, 1.0);
    std::array<Texel, 4> result{};
    for (int i = 0; i < 4; ++i) {
      const int x = i % 2, y = i / 2;
      const glm::dvec2 centre = corner + glm::dvec2(x - 0.5, y - 0.5);
      const glm::dvec2 offset = centre - centre_;
      const double depth = texel_(int(corner.x) + x - 1, int(corner.y) + y - 1);
      double plane = receiver_.depth + glm::dot(receiver_.gradient, offset) / texels_;
      const double step = std::ldexp(1.0, -24);
      plane = towards_ > 0 ? std::clamp(plane, 0.0, 1.0 - step) : std::clamp(plane, step, 1.0);
      result[std::size_t(i)] = {towards_ * (depth - receiver_.depth), towards_ * (depth - plane),
                                circle_radius(offset),
                                (x == 0 ? 1.0 - share.x : share.x) * (y == 0 ? 1.0 - share.y : share.y)};
    }
    return result;
  }

  // width is that of the cone looked in, over the light's.
  bool blocks(const Texel& texel, double slack, double highest, double width = 1.0) const {
    const double cone = std::max(texel.radius - slack, 0.0) / (texels_per_depth_ * width);
    return texel.above_plane > 0.0 && texel.gap > std::min(cone, highest);
  }

  glm::dvec2 turned(int i) const {
    const glm::dvec2 d(directions_[std::size_t(i)]);
    const glm::dvec2& r = receiver_.rotation;
    return {d.x * r.x - d.y * r.y, d.x * r.y + d.y * r.x};
  }

  Blockers search() const {
    const double slack = std::max(smallest_, 0.75);
    double inside = 0.0, inside_count = 0.0, nearby = 0.0, nearby_count = 0.0;
    Blockers found;
    for (int i = 0; i < settings_.blocker_samples; ++i) {
      const double outermost = std::max(search_radius_, 1e-3);
      const double innermost = std::min(0.75, outermost);
      const double reach = innermost * std::pow(outermost / innermost, (i + 0.5) / settings_.blocker_samples);
      for (const Texel& texel : quad(centre_ + stretched(turned(i) * (i == 0 ? 0.0 : reach)))) {
        if (blocks(texel, slack, highest_cone_)) {
          inside += texel.gap;
          inside_count += 1.0;
          found.low += texel.gap < 2.0 / texels_per_depth_ ? 1.0 : 0.0;
        }
        if (blocks(texel, slack, highest_cone_, 5.0)) {
          nearby += texel.gap;
          nearby_count += 1.0;
        }
      }
    }
    found.count = inside_count > 0.0 ? inside_count : nearby_count;
    if (found.count > 0.0) found.gap = (inside_count > 0.0 ? inside : nearby) / found.count;
    found.cone_height = inside_count > 0.0 ? std::min(highest_cone_, 0.15 * found.gap) : highest_cone_;
    return found;
  }

  static double lit_share(double lit, double blocked) {
    if (!(blocked > 0.0)) return 1.0;
    return lit > 0.0 ? lit / (lit + blocked) : 0.0;
  }

  // The lit share of the 4 x 4 texels around the receiver.
  double block(double radius, double largest_gap, double cone_height) const {
    const double outermost = std::max(radius + 0.4, 0.75);
    const glm::dvec2 corner = glm::floor(centre_ + 0.5);
    double lit = 0.0, blocked = 0.0;
    for (int i = 0; i < 4; ++i) {
      for (const Texel& texel : quad(corner + glm::dvec2(i % 2 == 0 ? -1.0 : 1.0, i < 2 ? -1.0 : 1.0))) {
        if (texel.gap >= largest_gap) continue;
        const double weight = std::max(1.0 - texel.radius / outermost, 0.0);
        (blocks(texel, 1.65, cone_height) ? blocked : lit) += weight;
      }
    }
    return lit_share(lit, blocked);
  }

  double disc(double radius, double slack, double cone_height) const {
    double lit = 0.0, blocked = 0.0;
    for (int i = 0; i < settings_.filter_samples; ++i) {
      const double reach = radius * std::sqrt((i + 0.5) / settings_.filter_samples);
      for (const Texel& texel : quad(centre_ + stretched(turned(i) * reach)))
        (blocks(texel, slack, cone_height) ? blocked : lit) += texel.weight;
    }
    return lit_share(lit, blocked);
  }

  Light light_;
  Settings settings_;
  int texels_;
  double towards_;  // +1 where stored depth grows towards the light
  double nearest_;
  std::function<double(int, int)> texel_;
  parameters::DiskPoints directions_;
  Receiver receiver_{};
  glm::dvec2 centre_{0.0}, tangent_{0.0};
  double cosine_ = 1.0, texels_per_depth_ = 0.0, smallest_ = 0.0, search_radius_ = 0.0, highest_cone_ = 0.0;
};

}  // namespace penumbra::testing_spot
