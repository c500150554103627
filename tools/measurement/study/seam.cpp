#include "study/seam.h"

#include <cmath>
#include <stdexcept>

#include "study/metrics.h"

namespace penumbra::study {
namespace {

// The mean of the changes in one block.
struct Changes {
  double sum = 0.0;
  std::size_t count = 0;
};

// The mean square of block means, each weighted by its pairs.
struct SquaredMeans {
  double sum = 0.0;
  std::size_t pairs = 0;

  void add(const Changes& changes) {
    if (changes.count < kSeamPairs) return;
    const double mean = changes.sum / static_cast<double>(changes.count);
    sum += mean * mean * static_cast<double>(changes.count);
    pairs += changes.count;
  }
  std::optional<double> root() const {
    if (pairs == 0) return std::nullopt;
    return std::sqrt(sum / static_cast<double>(pairs));
  }
};

class Blocks {
 public:
  explicit Blocks(const SeamImages& images)
      : images_(images), height_(static_cast<int>(images.t1.size()) / images.width) {}

  Seam seam() const {
    SquaredMeans across;
    SquaredMeans within;
    for (int y = 0; y < height_; y += kSeamBlock) {
      for (int x = 0; x < images_.width; x += kSeamBlock) {
        across.add(changes_across(x, y));
        within.add(changes_within(x, y));
      }
    }
    return {across.pairs, across.root(), within.root()};
  }

 private:
  bool counts(int x, int y) const {
    const std::size_t i = at(x, y);
    if (images_.cascade[i] < 0) return false;
    return images_.everywhere || (images_.t1[i] > kUmbraBelow && images_.t1[i] < kLitAbove);
  }
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(images_.width) +
           static_cast<std::size_t>(x);
  }
  double error(std::size_t i) const {
    return static_cast<double>(images_.result[i]) - static_cast<double>(images_.t1[i]);
  }

  void add_pair(int x, int y, int to_x, int to_y, Changes& changes) const {
    if (to_x >= images_.width || to_y >= height_ || !counts(x, y) || !counts(to_x, to_y)) return;
    const std::size_t a = at(x, y);
    const std::size_t b = at(to_x, to_y);
    const int further = images_.cascade[b] - images_.cascade[a];
    if (further == 0) return;
    changes.sum += further > 0 ? error(b) - error(a) : error(a) - error(b);
    ++changes.count;
  }

  Changes changes_across(int left, int top) const {
    Changes changes;
    for (int y = top; y < top + kSeamBlock && y < height_; ++y) {
      for (int x = left; x < left + kSeamBlock && x < images_.width; ++x) {
        add_pair(x, y, x + 1, y, changes);
        add_pair(x, y, x, y + 1, changes);
      }
    }
    return changes;
  }

  // Returns the changes between the two rows in the block's middle.
  Changes changes_within(int left, int top) const {
    Changes changes;
    const int y = top + kSeamBlock / 2;
    for (int x = left; x < left + kSeamBlock && x < images_.width && y + 1 < height_; ++x) {
      if (!counts(x, y) || !counts(x, y + 1)) continue;
      if (images_.cascade[at(x, y)] != images_.cascade[at(x, y + 1)]) continue;
      changes.sum += error(at(x, y + 1)) - error(at(x, y));
      ++changes.count;
    }
    return changes;
  }

  const SeamImages& images_;
  int height_;
};

}  // namespace

Seam seam_of(const SeamImages& images) {
  const std::size_t pixels = images.t1.size();
  if (images.width <= 0 || images.cascade.size() != pixels || images.result.size() != pixels ||
      pixels % static_cast<std::size_t>(images.width) != 0) {
    throw std::invalid_argument("images of different sizes");
  }
  return Blocks(images).seam();
}

}  // namespace penumbra::study
