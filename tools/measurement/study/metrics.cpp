#include "study/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace penumbra::study {
namespace {

bool is_counted(const SeamImages& images, std::size_t i) {
  if (images.cascade[i] < 0) return false;
  return images.everywhere || (images.t1[i] > kUmbraBelow && images.t1[i] < kLitAbove);
}

double error_of(const SeamImages& images, std::size_t i) {
  return static_cast<double>(images.result[i]) - static_cast<double>(images.t1[i]);
}

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

class SeamBlocks {
 public:
  explicit SeamBlocks(const SeamImages& images)
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
  bool counts(int x, int y) const { return is_counted(images_, at(x, y)); }
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(images_.width) +
           static_cast<std::size_t>(x);
  }
  double error(std::size_t i) const { return error_of(images_, i); }

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

void require_same_sizes(const SeamImages& images) {
  const std::size_t pixels = images.t1.size();
  if (images.width <= 0 || images.cascade.size() != pixels || images.result.size() != pixels ||
      pixels % static_cast<std::size_t>(images.width) != 0)
    throw std::invalid_argument("images of different sizes");
}

enum class PixelClass { umbra, penumbra, lit };

// No float equals 0.02 or 0.98, so every pixel has a class although the bounds of the definition are open.
PixelClass classify(double t1) {
  if (t1 < kUmbraBelow) return PixelClass::umbra;
  return t1 > kLitAbove ? PixelClass::lit : PixelClass::penumbra;
}

bool is_visibility(float value) {
  return value >= 0.0F && value <= 1.0F;  // false for NaN
}

// Mean and mean square of a signed error.
class ErrorSum {
 public:
  void add(double error) {
    sum_ += error;
    squares_ += error * error;
    ++count_;
  }
  std::optional<double> mean() const {
    return count_ == 0 ? std::nullopt : std::optional(sum_ / static_cast<double>(count_));
  }
  std::optional<double> rmse() const {
    return count_ == 0 ? std::nullopt : std::optional(std::sqrt(squares_ / static_cast<double>(count_)));
  }
  std::optional<ErrorShare> share() const {
    return count_ == 0 ? std::nullopt : std::optional(ErrorShare{*mean(), *rmse()});
  }

 private:
  double sum_ = 0.0;
  double squares_ = 0.0;
  std::size_t count_ = 0;
};

class Share {
 public:
  void add(bool hit) {
    hits_ += hit ? 1 : 0;
    ++count_;
  }
  std::optional<double> value() const {
    return count_ == 0 ? std::nullopt
                       : std::optional(static_cast<double>(hits_) / static_cast<double>(count_));
  }

 private:
  std::size_t hits_ = 0;
  std::size_t count_ = 0;
};

// The block of each pixel.
class Blocks {
 public:
  Blocks(std::size_t pixels, int width) : width_(width > 0 ? static_cast<std::size_t>(width) : 0) {
    if (width_ == 0) return;
    side_ = std::max<std::size_t>(width_ / kBlocksAcross, kSmallestBlock);
    across_ = (width_ + side_ - 1) / side_;
    const std::size_t height = pixels / width_;
    count_ = across_ * ((height + side_ - 1) / side_);
  }
  std::size_t count() const { return count_; }
  std::size_t of(std::size_t pixel) const {
    return width_ == 0 ? 0 : pixel / width_ / side_ * across_ + pixel % width_ / side_;
  }

 private:
  std::size_t width_;
  std::size_t side_ = 1;
  std::size_t across_ = 1;
  std::size_t count_ = 1;
};

// The sums of one figure by block.
class BlockFigure {
 public:
  explicit BlockFigure(std::size_t blocks) : sums_(blocks) {}
  void add(std::size_t block, double value) {
    sums_[block].sum += value;
    sums_[block].count += 1.0;
  }
  std::optional<Interval> interval(Figure figure, double most = 1.0) const {
    return block_interval(sums_, figure, most);
  }

 private:
  std::vector<BlockSums> sums_;
};

// Returns the nearest-rank percentile: the smallest value with at least `fraction` of all values at or below
// it.
template <typename Value>
std::optional<double> percentile(std::vector<Value>& values, double fraction) {
  if (values.empty()) return std::nullopt;
  const auto rank = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(values.size())));
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
  std::nth_element(values.begin(), nth, values.end());
  return static_cast<double>(*nth);
}

// It makes two passes over a few seeds: the one-pass formula suffers cancellation if the variance is small.
std::optional<double> sample_variance(const std::vector<double>& values) {
  if (values.size() < 2) return std::nullopt;
  double mean = 0.0;
  for (const double value : values) mean += value;
  mean /= static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return squares / static_cast<double>(values.size() - 1);
}

void check_reference(std::span<const float> reference, std::span<const std::uint8_t> valid,
                     const char* name) {
  for (std::size_t pixel = 0; pixel < reference.size(); ++pixel) {
    if (valid[pixel] != 0 && !is_visibility(reference[pixel])) {
      throw std::invalid_argument(std::string(name) + " is not a visibility at pixel " +
                                  std::to_string(pixel) + ": " + std::to_string(reference[pixel]));
    }
  }
}

void check(const MeasuredImages& images) {
  const std::size_t size = images.t1.size();
  const auto fits = [size](const auto& image) { return image.size() == size; };
  if (images.results.empty()) throw std::invalid_argument("no result image to measure");
  if (images.width < 0 || (images.width > 0 && size % static_cast<std::size_t>(images.width) != 0)) {
    throw std::invalid_argument("the images to measure are not of that width");
  }
  const bool fetches_fit = images.fetches.size() <= 1 || images.fetches.size() == images.results.size();
  if (!fits(images.valid) || !std::all_of(images.results.begin(), images.results.end(), fits) ||
      !std::all_of(images.fetches.begin(), images.fetches.end(), fits) || !fetches_fit ||
      !(images.masked_out.empty() || fits(images.masked_out)) || !(images.t2.empty() || fits(images.t2)) ||
      !(images.t3.empty() || fits(images.t3))) {
    throw std::invalid_argument("the images to measure differ in size or number");
  }
  check_reference(images.t1, images.valid, "T1");
  check_reference(images.t2, images.valid, "T2");
}

class Measurement {
 public:
  explicit Measurement(const MeasuredImages& images)
      : images_(images), blocks_(images.t1.size(), images.width) {}

  Metrics run() {
    for (std::size_t pixel = 0; pixel < images_.t1.size(); ++pixel) {
      if (images_.valid[pixel] == 0) continue;
      ++metrics_.pixels;
      const PixelClass kind = classify(images_.t1[pixel]);
      if (kind == PixelClass::penumbra) ++metrics_.penumbra_pixels;
      add_results(pixel, kind);
      if (kind == PixelClass::penumbra) add_reference_shares(pixel);
    }
    finish_errors();
    find_intervals();
    count_fetches();
    measure_mask();
    return metrics_;
  }

 private:
  void add_results(std::size_t pixel, PixelClass kind) {
    const std::size_t block = blocks_.of(pixel);
    seeds_.clear();
    for (const std::span<const float> result : images_.results) {
      const float value = result[pixel];
      if (!is_visibility(value)) {
        ++metrics_.invalid;
        continue;
      }
      const double error = static_cast<double>(value) - static_cast<double>(images_.t1[pixel]);
      all_.add(error);
      max_error_ = std::max(max_error_.value_or(0.0), std::abs(error));
      squares_by_block_.add(block, error * error);
      if (kind == PixelClass::umbra) add_leak(block, static_cast<double>(value) > kLeakAbove);
      if (kind == PixelClass::lit) add_false_shadow(block, static_cast<double>(value) < kFalseShadowBelow);
      if (kind != PixelClass::penumbra) continue;
      penumbra_.add(error);
      penumbra_squares_by_block_.add(block, error * error);
      absolute_.push_back(std::abs(error));
      seeds_.push_back(static_cast<double>(value));
    }
    if (const auto variance = sample_variance(seeds_)) variance_.add(*variance);
  }

  void add_leak(std::size_t block, bool leak) {
    leaks_.add(leak);
    leaks_by_block_.add(block, leak ? 1.0 : 0.0);
  }

  void add_false_shadow(std::size_t block, bool false_shadow) {
    false_shadows_.add(false_shadow);
    false_shadows_by_block_.add(block, false_shadow ? 1.0 : 0.0);
  }

  void add_reference_shares(std::size_t pixel) {
    const bool have_t2 = !images_.t2.empty();
    if (have_t2) map_.add(static_cast<double>(images_.t2[pixel]) - static_cast<double>(images_.t1[pixel]));
    if (images_.t3.empty()) return;
    const float t3 = images_.t3[pixel];
    if (!is_visibility(t3)) {
      ++metrics_.invalid;
      return;
    }
    if (have_t2) algorithm_.add(static_cast<double>(t3) - static_cast<double>(images_.t2[pixel]));
    for (const double value : seeds_) sampling_.add(value - static_cast<double>(t3));
  }

  void finish_errors() {
    metrics_.seeds = images_.results.size();
    metrics_.rmse_penumbra = penumbra_.rmse();
    metrics_.rmse_all = all_.rmse();
    metrics_.bias = penumbra_.mean();
    metrics_.variance = variance_.mean();
    metrics_.p99 = percentile(absolute_, 0.99);
    metrics_.max_error = max_error_;
    metrics_.leak_rate = leaks_.value();
    metrics_.false_shadow_rate = false_shadows_.value();
    metrics_.preprocess_fetches_per_pixel = images_.preprocess_fetches_per_pixel;
    metrics_.split = {map_.share(), algorithm_.share(), sampling_.share()};
  }

  void find_intervals() {
    MetricIntervals& intervals = metrics_.intervals;
    intervals.rmse_penumbra = penumbra_squares_by_block_.interval(Figure::root_of_mean);
    intervals.rmse_all = squares_by_block_.interval(Figure::root_of_mean);
    intervals.leak_rate = leaks_by_block_.interval(Figure::mean);
    intervals.false_shadow_rate = false_shadows_by_block_.interval(Figure::mean);
  }

  void count_fetches() {
    BlockFigure by_block(blocks_.count());
    ErrorSum everywhere;
    ErrorSum in_penumbra;
    std::vector<std::uint32_t> counts;
    for (const std::span<const std::uint32_t> image : images_.fetches) {
      for (std::size_t pixel = 0; pixel < image.size(); ++pixel) {
        if (images_.valid[pixel] == 0) continue;
        everywhere.add(image[pixel]);
        by_block.add(blocks_.of(pixel), image[pixel]);
        if (classify(images_.t1[pixel]) == PixelClass::penumbra) in_penumbra.add(image[pixel]);
        counts.push_back(image[pixel]);
      }
    }
    metrics_.fetches_mean = everywhere.mean();
    metrics_.intervals.fetches_mean =
        by_block.interval(Figure::mean, std::numeric_limits<double>::infinity());
    metrics_.fetches_penumbra_mean = in_penumbra.mean();
    metrics_.fetches_p95 = percentile(counts, 0.95);
  }

  void measure_mask() {
    if (images_.masked_out.empty()) return;
    Share saved;
    Share missed;
    for (std::size_t pixel = 0; pixel < images_.masked_out.size(); ++pixel) {
      if (images_.valid[pixel] == 0) continue;
      const bool left_out = images_.masked_out[pixel] != 0;
      saved.add(left_out);
      if (classify(images_.t1[pixel]) == PixelClass::penumbra) missed.add(left_out);
    }
    if (saved.value()) metrics_.mask = MaskShares{*saved.value(), missed.value()};
  }

  const MeasuredImages& images_;
  Blocks blocks_;
  Metrics metrics_;
  ErrorSum all_, penumbra_, variance_, map_, algorithm_, sampling_;
  Share leaks_, false_shadows_;
  BlockFigure squares_by_block_{blocks_.count()};
  BlockFigure penumbra_squares_by_block_{blocks_.count()};
  BlockFigure leaks_by_block_{blocks_.count()};
  BlockFigure false_shadows_by_block_{blocks_.count()};
  std::optional<double> max_error_;
  std::vector<double> absolute_;
  std::vector<double> seeds_;  // this pixel's usable results
};

}  // namespace

Metrics measure(const MeasuredImages& images) {
  check(images);
  return Measurement(images).run();
}

std::optional<double> shimmer_of(const std::vector<std::vector<float>>& frames, int width,
                                 std::span<const float> t1, std::span<const std::uint8_t> valid) {
  if (width <= 0 || t1.size() != valid.size() || t1.size() % static_cast<std::size_t>(width) != 0) {
    throw std::invalid_argument("a reference that does not fit the picture's width");
  }
  for (const std::vector<float>& frame : frames) {
    if (frame.size() != t1.size()) throw std::invalid_argument("the frames of a pan differ in size");
  }
  double squares = 0.0;
  std::size_t changes = 0;
  for (std::size_t pixel = 0; pixel < t1.size(); ++pixel) {
    const auto t = static_cast<double>(t1[pixel]);
    const bool counts = valid[pixel] != 0 && t > kUmbraBelow && t < kLitAbove;
    const bool stays = pixel % static_cast<std::size_t>(width) + 1 >= frames.size();
    if (!counts || !stays) continue;
    for (std::size_t k = 1; k < frames.size(); ++k) {
      const double change =
          static_cast<double>(frames[k][pixel - k]) - static_cast<double>(frames[k - 1][pixel - k + 1]);
      squares += change * change;
      ++changes;
    }
  }
  if (changes == 0) return std::nullopt;
  return std::sqrt(squares / static_cast<double>(changes));
}

Seam seam_of(const SeamImages& images) {
  require_same_sizes(images);
  return SeamBlocks(images).seam();
}

GroupStep group_step_of(const SeamImages& images) {
  require_same_sizes(images);
  const auto width = static_cast<std::size_t>(images.width);
  struct Squares {
    double sum = 0.0;
    std::size_t count = 0;
    std::optional<double> root() const {
      if (count == 0) return std::nullopt;
      return std::sqrt(sum / static_cast<double>(count));
    }
  } across, inside;
  const auto add = [&](std::size_t a, std::size_t b, std::size_t place) {
    if (!is_counted(images, a) || !is_counted(images, b) || images.cascade[a] != images.cascade[b]) return;
    const double step = error_of(images, b) - error_of(images, a);
    Squares& squares = place % kGroupPixels == 0 ? across : inside;
    squares.sum += step * step;
    ++squares.count;
  };
  for (std::size_t i = 0; i < images.t1.size(); ++i) {
    const std::size_t x = i % width, y = i / width;
    if (x > 0) add(i - 1, i, x);
    if (y > 0) add(i - width, i, y);
  }
  return {across.count, across.root(), inside.root()};
}

}  // namespace penumbra::study
