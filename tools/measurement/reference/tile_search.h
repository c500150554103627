// The search of one cascade tile for one receiver: it finds the points of the light's disc that the tile's
// texels cover.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "parameters/cascades.h"
#include "reference/depth_hierarchy.h"
#include "reference/disc_coverage.h"
#include "reference/lit_receiver.h"
#include "scene/frame.h"

namespace penumbra::reference {

class TileSearch {
 public:
  TileSearch(const scene::ShadowAtlas& atlas, const parameters::CascadeSet& cascades, std::size_t cascade);

  // Returns the disc points that the tile's texels cover. The receiver is in world space; tan_half > 0.
  DiscPoints::Set covered(const LitReceiver& receiver, double tan_half, const DiscPoints& points) const;

  // Returns the same for a point light: whether the texel over the receiver blocks.
  bool blocked(const LitReceiver& receiver) const;

 private:
  // The receiver in the tile's own frame: its place in metres across the light, from the tile's corner, and
  // its height in stored depth. The plane's gap changes by `slope` per metre across.
  struct Seen {
    glm::dvec2 place;
    double height;
    glm::dvec2 slope;
  };
  struct Block {
    int level;
    int column;
    int row;
  };

  Seen seen_from_light(const LitReceiver& receiver) const;
  double gap(float height, const Seen& seen) const { return (height - seen.height) * metres_per_depth_; }
  DiscRectangle metres_from(const Seen& seen, const Block& block) const;
  bool may_block(const Block& block, const DiscRectangle& area, const Seen& seen, double tan_half) const;
  bool texel_blocks(const DiscRectangle& area, const Seen& seen, double texel_gap) const;

  DepthHierarchy depths_;
  glm::dmat4 world_to_shadow_;
  glm::dvec3 right_;
  glm::dvec3 up_;
  glm::dvec3 to_light_;
  glm::dvec2 metres_per_uv_;
  glm::dvec2 corner_uv_;
  glm::dvec2 texel_metres_;
  double height_sign_;
  double metres_per_depth_;
  double quantum_metres_;
};

}  // namespace penumbra::reference
