// Rays from a receiver to the light's disc, through what one tile of a shadow map says of the casters.
//
// The map's surface, seen from one receiver: each texel that blocks it (below) is a square at the texel's
// depth, edges included. Where two neighbours both block, an upright wall closes the step between them. At
// the edge of a texel that does not block there is no wall: light may come in from below the edge of a roof.
//
// A texel blocks if it is nearer to the light than the receiver, and above the receiver's plane at the
// texel's centre. These are the filters' own rules: without the second a surface would shadow itself. Depths
// are limited to [0, 1] and NaN lies at the far end, as the filters read them; the plane is limited to just
// behind the near end, where casters before it are drawn.
//
// Of what lies beyond its tile the map says nothing: a ray that leaves it below the surface is not known to
// reach the light.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <limits>
#include <vector>

#include "scene/frame.h"

namespace penumbra::resolve {

// Lengths in texels, places from the atlas's first texel. Heights grow towards the light: the stored depth
// with reversed depth, else its negative.
struct MapReceiver {
  glm::dvec2 place;
  double height;
  glm::dvec2 slope;  // height per texel along the receiver's plane
};

class MapRays {
 public:
  // cap_metres is the radius, across the light, beyond which no ray leaves the receiver's own: a ray goes
  // straight on from there, as the softness cap has it.
  MapRays(const scene::Frame& frame, std::size_t cascade, double cap_metres) {
    const parameters::Cascade& tile = frame.cascades.cascades.at(cascade);
    const scene::ShadowAtlas& atlas = frame.atlas;
    sign_ = frame.cascades.reversed_z ? 1.0 : -1.0;
    nearest_ = frame.cascades.reversed_z ? 1.0 : 0.0;
    origin_ = {std::lround(tile.offset_scale.x * atlas.width),
               std::lround(tile.offset_scale.y * atlas.height)};
    side_ = static_cast<int>(std::lround(tile.offset_scale.z * atlas.width));
    per_height_ = tile.depth_to_radial * side_;
    cap_ = cap_metres / tile.texel_size_metres;
    Level texels{side_, {}};
    for (int y = 0; y < side_; ++y)
      for (int x = 0; x < side_; ++x) {
        const double height = height_of(static_cast<double>(
            atlas.depth[static_cast<std::size_t>(y + origin_.y) * static_cast<std::size_t>(atlas.width) +
                        static_cast<std::size_t>(x + origin_.x)]));
        texels.heights.push_back({height, height});
      }
    levels_.push_back(std::move(texels));
    while (levels_.back().side > 1) levels_.push_back(half_size(levels_.back()));
  }

  // The receiver as a shader has it: texels of the atlas, stored depth and depth per texel.
  MapReceiver receiver(glm::dvec2 centre, double depth, glm::dvec2 gradient) const {
    return {centre - glm::dvec2(origin_), height_of(depth), sign_ * gradient};
  }

  // The height above the receiver of the highest blocking texel that any ray to the closed disc meets; 0
  // where no ray meets one.
  double highest_in_cone(const MapReceiver& receiver) const {
    double highest = 0.0;
    visit([&](const Node& node) {
      const double gap = bounds(node).highest - receiver.height;
      if (!(gap > highest) || !in_cone(node, receiver, gap)) return Visit::skip;
      if (!(bounds(node).highest > plane(node, receiver).lowest)) return Visit::skip;
      if (node.level > 0) return Visit::parts;
      highest = gap;  // here both bounds are the texel's own height and the plane's at its centre
      return Visit::skip;
    });
    return highest;
  }

  // Whether every texel blocks that a ray may be above or below until it is higher than `gap` above the
  // receiver. Such a ray begins below the surface, ends above it, and all steps in between are closed: it is
  // blocked. False where more than a few thousand blocks would have to be looked at.
  bool all_block(const MapReceiver& receiver, double gap) const {
    bool all = true;
    int visited = 0;
    visit([&](const Node& node) {
      if (!all || !in_cone(node, receiver, gap)) return Visit::skip;
      if (++visited > kMostBlocks) all = false;
      const bool block =
          bounds(node).lowest > receiver.height && bounds(node).lowest > plane(node, receiver).highest;
      if (block) return Visit::skip;
      if (node.level > 0) return Visit::parts;
      all = false;
      return Visit::skip;
    });
    return all;
  }

  // Whether one ray, to a point of the closed unit disc, is blocked. highest is the height above the receiver
  // of the tile's highest texel.
  bool ray_is_blocked(const MapReceiver& receiver, glm::dvec2 point, double highest) const {
    const glm::dvec2 step = point * per_height_;  // texels for each unit of height
    glm::ivec2 texel = glm::clamp(glm::ivec2(glm::floor(receiver.place)), 0, side_ - 1);
    bool before_blocks = false, before_under = false;
    double height = 0.0;
    while (true) {
      const std::array<double, 2> exits{exit(receiver.place.x, step.x, texel.x),
                                        exit(receiver.place.y, step.y, texel.y)};
      const int axis = exits[0] <= exits[1] ? 0 : 1;
      double leaves = exits[static_cast<std::size_t>(axis)];
      if (leaves * per_height_ > cap_) leaves = std::numeric_limits<double>::infinity();
      const double gap = at(texel) - receiver.height;
      const bool blocks = gap > 0.0 && at(texel) > plane_at(receiver, glm::dvec2(texel) + 0.5);
      const bool under = height <= gap;
      if (blocks && before_blocks && under != before_under) return true;  // the ray passes a wall
      if (blocks && under && gap <= leaves) return true;                  // the ray passes the square
      before_blocks = blocks;
      before_under = blocks && under;
      if (leaves > highest) return false;
      texel[axis] += step[axis] > 0.0 ? 1 : -1;
      if (texel[axis] < 0 || texel[axis] >= side_) return before_under;
      height = leaves;
    }
  }

  // The height of the tile's highest texel.
  double highest_above(const MapReceiver& receiver) const {
    return levels_.back().heights.front().highest - receiver.height;
  }

 private:
  static constexpr int kMostBlocks = 4000;

  struct Heights {
    double lowest;
    double highest;
  };
  struct Level {
    int side;
    std::vector<Heights> heights;
  };
  struct Node {
    int level;
    int x;
    int y;
  };
  enum class Visit { skip, parts };

  double height_of(double depth) const {
    const double farthest = sign_ > 0.0 ? 0.0 : 1.0;
    return sign_ * (std::isnan(depth) ? farthest : std::clamp(depth, 0.0, 1.0));
  }

  static Level half_size(const Level& finer) {
    Level coarser{(finer.side + 1) / 2, {}};
    coarser.heights.assign(
        static_cast<std::size_t>(coarser.side) * static_cast<std::size_t>(coarser.side),
        {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()});
    for (int y = 0; y < finer.side; ++y)
      for (int x = 0; x < finer.side; ++x) {
        const Heights& part = finer.heights[static_cast<std::size_t>(y * finer.side + x)];
        Heights& whole = coarser.heights[static_cast<std::size_t>(y / 2 * coarser.side + x / 2)];
        whole = {std::min(whole.lowest, part.lowest), std::max(whole.highest, part.highest)};
      }
    return coarser;
  }

  const Heights& bounds(const Node& node) const {
    const Level& level = levels_[static_cast<std::size_t>(node.level)];
    return level.heights[static_cast<std::size_t>(node.y * level.side + node.x)];
  }
  double at(glm::ivec2 texel) const { return bounds({0, texel.x, texel.y}).highest; }

  // Whether any point of the block's square is in the light's cone, as wide as it is at `gap` above the
  // receiver.
  bool in_cone(const Node& node, const MapReceiver& receiver, double gap) const {
    const double size = 1 << node.level;
    const double x =
        std::max({node.x * size - receiver.place.x, receiver.place.x - (node.x + 1) * size, 0.0});
    const double y =
        std::max({node.y * size - receiver.place.y, receiver.place.y - (node.y + 1) * size, 0.0});
    const double radius = std::min(gap * per_height_, cap_);
    return x * x + y * y <= radius * radius;
  }

  double limited(double plane) const { return std::clamp(plane, nearest_ - 1.0, nearest_ - 0x1p-24); }
  double plane_at(const MapReceiver& receiver, glm::dvec2 place) const {
    const glm::dvec2 away = place - receiver.place;
    return limited(receiver.height + receiver.slope.x * away.x + receiver.slope.y * away.y);
  }
  // The heights of the receiver's plane at the centres of the block's texels.
  Heights plane(const Node& node, const MapReceiver& receiver) const {
    const double size = 1 << node.level;
    const glm::dvec2 away = (glm::dvec2(node.x, node.y) + 0.5) * size - receiver.place;
    const double middle = receiver.height + receiver.slope.x * away.x + receiver.slope.y * away.y;
    const double rise = (std::abs(receiver.slope.x) + std::abs(receiver.slope.y)) * 0.5 * (size - 1.0);
    return {limited(middle - rise), limited(middle + rise)};
  }

  // The height at which a ray leaves the texel along one axis.
  static double exit(double place, double step, int texel) {
    if (step == 0.0) return std::numeric_limits<double>::infinity();
    return std::max(((step > 0.0 ? texel + 1 : texel) - place) / step, 0.0);
  }

  template <typename Visitor>
  void visit(const Visitor& visitor) const {
    std::array<Node, 64> waiting;  // there are at most three others on each level
    std::size_t count = 0;
    waiting[count++] = {static_cast<int>(levels_.size()) - 1, 0, 0};
    while (count > 0) {
      const Node node = waiting[--count];
      if (visitor(node) == Visit::skip) continue;
      const int side = levels_[static_cast<std::size_t>(node.level - 1)].side;
      for (int part = 0; part < 4; ++part) {
        const Node finer{node.level - 1, 2 * node.x + (part & 1), 2 * node.y + (part >> 1)};
        if (finer.x < side && finer.y < side) waiting[count++] = finer;
      }
    }
  }

  double sign_;
  double nearest_;
  glm::ivec2 origin_{0};
  int side_;
  double cap_;         // radius at which the cone ends, texels
  double per_height_;  // radius of the light's cone, texels, for each unit of height
  std::vector<Level> levels_;
};

}  // namespace penumbra::resolve
