// The nearest stored depth of every power-of-two block of one cascade tile, which lets a search skip texels.
//
// Depths become heights, larger = nearer to the light: the depth itself with reversed Z, otherwise its
// negative, so that no bit is lost. Texels without a caster have height -infinity: the cleared far value, and
// everything outside [0, 1] (NaN and infinities).
#pragma once

#include <cstddef>
#include <vector>

#include "parameters/cascades.h"
#include "scene/frame.h"

namespace penumbra::reference {

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

}  // namespace penumbra::reference
