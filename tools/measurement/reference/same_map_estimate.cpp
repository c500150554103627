#include "reference/same_map_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "input/input_error.h"
#include "parameters/matrix_row.h"
#include "platform/hashed_fields.h"
#include "reference/disc_coverage.h"
#include "reference/lit_receiver.h"

namespace penumbra::reference {
namespace {

// The nearest stored depth of every power-of-two block of one cascade tile, which lets a search skip texels.
//
// Depths become heights, larger = nearer to the light: the depth itself with reversed Z, otherwise its
// negative, so that no bit is lost. Texels without a caster have height -infinity: the cleared far value, and
// everything outside [0, 1] (NaN and infinities).
class DepthHierarchy {
 public:
  // The tile's rectangle in the atlas comes from cascade.offset_scale, rounded to whole texels and clipped to
  // the atlas. The hierarchy copies what it needs.
  DepthHierarchy(const scene::ShadowAtlas& atlas, const parameters::Cascade& cascade, bool reversed_z);

  int first_column() const { return first_column_; }  // the tile's first column in the atlas
  int first_row() const { return first_row_; }
  int width() const { return levels_.front().width; }
  int height() const { return levels_.front().height; }
  int level_count() const { return static_cast<int>(levels_.size()); }

  // Returns the largest height of the block of 2^level x 2^level texels at column, row of that level.
  float nearest(int level, int column, int row) const {
    const Level& at = levels_[static_cast<std::size_t>(level)];
    return at.heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(at.width) +
                      static_cast<std::size_t>(column)];
  }
  bool inside(int level, int column, int row) const {
    const Level& at = levels_[static_cast<std::size_t>(level)];
    return column < at.width && row < at.height;
  }

 private:
  struct Level {
    int width = 0;
    int height = 0;
    std::vector<float> heights;
  };

  static Level half_size(const Level& finer);

  int first_column_ = 0;
  int first_row_ = 0;
  std::vector<Level> levels_;
};

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

constexpr float no_caster = -std::numeric_limits<float>::infinity();

float height_of(float depth, bool reversed_z) {
  if (!(depth >= 0.0F && depth <= 1.0F)) return no_caster;
  if (reversed_z) return depth == 0.0F ? no_caster : depth;
  return depth == 1.0F ? no_caster : -depth;
}

int whole_texel(double uv, int size) {
  return std::clamp(static_cast<int>(std::lround(uv * size)), 0, size);
}

double quantum(scene::DepthFormat format) {
  switch (format) {
    case scene::DepthFormat::d16:
      return 1.0 / 65535.0;
    case scene::DepthFormat::d24:
      return 1.0 / 16777215.0;
    case scene::DepthFormat::d32:
      break;
  }
  return 0x1p-24;
}

DepthHierarchy::DepthHierarchy(const scene::ShadowAtlas& atlas, const parameters::Cascade& cascade,
                               bool reversed_z) {
  const glm::dvec4& tile = cascade.offset_scale;
  first_column_ = whole_texel(tile.x, atlas.width);
  first_row_ = whole_texel(tile.y, atlas.height);
  Level texels;
  texels.width = whole_texel(tile.x + tile.z, atlas.width) - first_column_;
  texels.height = whole_texel(tile.y + tile.w, atlas.height) - first_row_;
  if (texels.width <= 0 || texels.height <= 0)
    throw InputError("", "a cascade's tile lies outside the atlas");
  for (int row = first_row_; row < first_row_ + texels.height; ++row) {
    const float* line =
        atlas.depth.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(atlas.width);
    for (int column = first_column_; column < first_column_ + texels.width; ++column) {
      texels.heights.push_back(height_of(line[column], reversed_z));
    }
  }
  levels_.push_back(std::move(texels));
  while (levels_.back().width > 1 || levels_.back().height > 1) levels_.push_back(half_size(levels_.back()));
}

DepthHierarchy::Level DepthHierarchy::half_size(const Level& finer) {
  Level coarser{(finer.width + 1) / 2, (finer.height + 1) / 2, {}};
  coarser.heights.assign(static_cast<std::size_t>(coarser.width) * static_cast<std::size_t>(coarser.height),
                         no_caster);
  for (int row = 0; row < finer.height; ++row) {
    for (int column = 0; column < finer.width; ++column) {
      float& block =
          coarser.heights[static_cast<std::size_t>(row / 2) * static_cast<std::size_t>(coarser.width) +
                          static_cast<std::size_t>(column / 2)];
      block = std::max(block,
                       finer.heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(finer.width) +
                                     static_cast<std::size_t>(column)]);
    }
  }
  return coarser;
}

TileSearch::TileSearch(const scene::ShadowAtlas& atlas, const parameters::CascadeSet& cascades,
                       std::size_t cascade)
    : depths_(atlas, cascades.cascades[cascade], cascades.reversed_z),
      world_to_shadow_(cascades.cascades[cascade].world_to_shadow),
      height_sign_(cascades.reversed_z ? 1.0 : -1.0) {
  const glm::dvec3 across = parameters::matrix_row(world_to_shadow_, 0);
  const glm::dvec3 along = parameters::matrix_row(world_to_shadow_, 1);
  const glm::dvec3 depth = height_sign_ * parameters::matrix_row(world_to_shadow_, 2);
  const glm::dvec3 lengths(glm::length(across), glm::length(along), glm::length(depth));
  if (!(lengths.x > 0.0 && lengths.y > 0.0 && lengths.z > 0.0)) {
    throw InputError("", "a cascade's world_to_shadow matrix is singular");
  }
  right_ = across / lengths.x;
  up_ = along / lengths.y;
  to_light_ = depth / lengths.z;
  metres_per_uv_ = 1.0 / glm::dvec2(lengths);
  metres_per_depth_ = 1.0 / lengths.z;
  const glm::dvec2 texel_uv = 1.0 / glm::dvec2(atlas.width, atlas.height);
  corner_uv_ = glm::dvec2(depths_.first_column(), depths_.first_row()) * texel_uv;
  texel_metres_ = texel_uv * metres_per_uv_;
  quantum_metres_ = quantum(atlas.format) * metres_per_depth_;
}

TileSearch::Seen TileSearch::seen_from_light(const LitReceiver& receiver) const {
  const glm::dvec4 shadow = world_to_shadow_ * glm::dvec4(receiver.position, 1.0);
  const double facing = glm::dot(receiver.normal, to_light_);
  return {(glm::dvec2(shadow) - corner_uv_) * metres_per_uv_, height_sign_ * shadow.z,
          -glm::dvec2(glm::dot(receiver.normal, right_), glm::dot(receiver.normal, up_)) / facing};
}

DiscRectangle TileSearch::metres_from(const Seen& seen, const Block& block) const {
  const int size = 1 << block.level;
  return {block.column * size * texel_metres_.x - seen.place.x,
          (block.column + 1) * size * texel_metres_.x - seen.place.x,
          block.row * size * texel_metres_.y - seen.place.y,
          (block.row + 1) * size * texel_metres_.y - seen.place.y};
}

// A block can matter only if its nearest texel is above the receiver, and the light's cone, as wide as it is
// at that height, reaches the block.
bool TileSearch::may_block(const Block& block, const DiscRectangle& area, const Seen& seen,
                           double tan_half) const {
  const double largest_gap = gap(depths_.nearest(block.level, block.column, block.row), seen);
  if (!(largest_gap > quantum_metres_)) return false;
  const double aside = std::max({area.left, -area.right, 0.0});
  const double away = std::max({area.bottom, -area.top, 0.0});
  const double reach = tan_half * largest_gap;
  return aside * aside + away * away <= reach * reach;
}

bool TileSearch::texel_blocks(const DiscRectangle& area, const Seen& seen, double texel_gap) const {
  const glm::dvec2 centre(0.5 * (area.left + area.right), 0.5 * (area.bottom + area.top));
  return texel_gap > quantum_metres_ && texel_gap > glm::dot(seen.slope, centre) + quantum_metres_;
}

DiscPoints::Set TileSearch::covered(const LitReceiver& receiver, double tan_half,
                                    const DiscPoints& points) const {
  const Seen seen = seen_from_light(receiver);
  DiscPoints::Set covered{};
  std::array<Block, 64> stack;  // at most three siblings wait on each of the up to 16 levels
  std::size_t waiting = 0;
  stack[waiting++] = {depths_.level_count() - 1, 0, 0};
  while (waiting > 0) {
    const Block block = stack[--waiting];
    const DiscRectangle area = metres_from(seen, block);
    if (!may_block(block, area, seen, tan_half)) continue;
    if (block.level == 0) {
      const double texel_gap = gap(depths_.nearest(0, block.column, block.row), seen);
      if (!texel_blocks(area, seen, texel_gap)) continue;
      const double to_disc = 1.0 / (tan_half * texel_gap);
      points.cover({area.left * to_disc, area.right * to_disc, area.bottom * to_disc, area.top * to_disc},
                   covered);
      continue;
    }
    if (block.level == 3 && DiscPoints::all(covered)) break;
    for (int child = 0; child < 4; ++child) {
      const Block quarter{block.level - 1, 2 * block.column + (child & 1), 2 * block.row + (child >> 1)};
      if (depths_.inside(quarter.level, quarter.column, quarter.row)) stack[waiting++] = quarter;
    }
  }
  return covered;
}

bool TileSearch::blocked(const LitReceiver& receiver) const {
  const Seen seen = seen_from_light(receiver);
  const glm::dvec2 texel = glm::floor(seen.place / texel_metres_);
  if (!(texel.x >= 0.0 && texel.y >= 0.0 && texel.x < depths_.width() && texel.y < depths_.height())) {
    return false;
  }
  const Block block{0, static_cast<int>(texel.x), static_cast<int>(texel.y)};
  return texel_blocks(metres_from(seen, block), seen, gap(depths_.nearest(0, block.column, block.row), seen));
}

constexpr int same_map_version = 1;  // increased whenever a change affects any result

void check(const MapView& view) {
  const scene::ShadowAtlas& atlas = view.atlas;
  if (atlas.width <= 0 || atlas.height <= 0 ||
      atlas.depth.size() != static_cast<std::size_t>(atlas.width) * static_cast<std::size_t>(atlas.height)) {
    throw InputError("", "the shadow atlas does not hold width x height texels");
  }
  if (view.cascades.cascades.empty()) throw InputError("", "there is no cascade");
}

std::string key_of(const MapView& view) {
  return platform::hash_of(std::string_view("T2"), same_map_version, view.atlas, view.cascades,
                           view.receivers, view.origin);
}

class SameMap {
 public:
  SameMap(const MapView& view, const DiscLight& light) : view_(view), light_(light) {
    for (std::size_t cascade = 0; cascade < view.cascades.cascades.size(); ++cascade) {
      tiles_.emplace_back(view.atlas, view.cascades, cascade);
    }
  }

  HalfCounts lit_points(std::size_t pixel) const {
    constexpr auto half = static_cast<std::uint16_t>(DiscPoints::count / 2);
    LitReceiver receiver = lit_receiver(view_.receivers, pixel, light_).value();
    const glm::dvec3 surface = view_.origin + glm::dvec3(view_.receivers.position_relative[pixel]);
    const int cascade = select_cascade(view_.cascades, surface);
    if (cascade < 0) return {half, half};
    const TileSearch& tile = tiles_[static_cast<std::size_t>(cascade)];
    receiver.position += view_.origin;
    if (light_.tan_half > 0.0) {
      return DiscPoints::uncovered(tile.covered(receiver, light_.tan_half, points_));
    }
    return tile.blocked(receiver) ? HalfCounts{0, 0} : HalfCounts{half, half};
  }

 private:
  const MapView& view_;
  DiscLight light_;
  std::vector<TileSearch> tiles_;
  DiscPoints points_;
};

}  // namespace

int select_cascade(const parameters::CascadeSet& cascades, const glm::dvec3& position_ws) {
  if (cascades.cascades.size() == 1) return 0;
  for (std::size_t index = 0; index < cascades.cascades.size(); ++index) {
    const glm::dvec4& sphere = cascades.cascades[index].split_sphere;
    const glm::dvec3 from_centre = position_ws - glm::dvec3(sphere);
    if (glm::dot(from_centre, from_centre) < sphere.w * sphere.w) return static_cast<int>(index);
  }
  return -1;
}

VisibilityImage same_map_estimate(const MapView& view, const RunOptions& run, const ReferenceCache* cache) {
  check(view);
  const DiscLight light = disc_light({view.cascades.light_direction, view.cascades.angular_diameter_degrees});
  RowJob job;
  job.size = {view.receivers.width, view.receivers.height};
  job.valid = valid_receivers(view.receivers, light);
  job.samples = DiscPoints::count;
  job.rays_per_pixel = light.tan_half > 0.0 ? DiscPoints::count : 1;
  job.key = key_of(view);
  if (std::optional<VisibilityImage> kept = kept_image(job, cache)) return *std::move(kept);
  const SameMap map(view, light);
  job.count = [&](std::size_t pixel) { return map.lit_points(pixel); };
  return run_rows(job, run, cache);
}

}  // namespace penumbra::reference
