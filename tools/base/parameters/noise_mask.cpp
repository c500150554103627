#include "parameters/noise_mask.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace penumbra::parameters {

namespace {

constexpr double kDeviation = 1.9;  // deviation of both Gaussians: texels, slices
constexpr double kUnit = 1 << 20;   // energy of a point at its own place
// A Gaussian so far away is less than half a unit.
constexpr int kReach = 10;
constexpr std::int32_t kNone = std::numeric_limits<std::int32_t>::max();
constexpr int kPointsBetween = 64;
constexpr int kRings = 8;

// SplitMix64 (Steele, Lea and Flood 2014).
std::uint64_t mixed(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15ULL;
  std::uint64_t z = state;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

std::int32_t gaussian(int squared_distance) {
  return static_cast<std::int32_t>(
      std::lround(kUnit * std::exp(-squared_distance / (2.0 * kDeviation * kDeviation))));
}

// The step is along one axis, around its end.
std::size_t moved(std::size_t from, int steps, std::size_t size) {
  const auto whole = static_cast<int>(size);
  return static_cast<std::size_t>(((static_cast<int>(from) + steps) % whole + whole) % whole);
}

// Points in the volume, and at every voxel the energy of all of them. The extremes of every row are kept, and
// are computed anew in rows that a point changed.
class Volume {
 public:
  Volume(int side, int slices)
      : side_(static_cast<std::size_t>(side)),
        slices_(static_cast<std::size_t>(slices)),
        energy_(voxels(), 0),
        empty_(voxels(), 1),
        rows_(side_ * slices_) {
    for (int y = -kReach; y <= kReach; ++y)
      for (int x = -kReach; x <= kReach; ++x) kernel_.push_back(gaussian(x * x + y * y));
  }

  std::size_t voxels() const { return side_ * side_ * slices_; }
  bool is_empty(std::size_t voxel) const { return empty_[voxel] != 0; }

  void put(std::size_t voxel) {
    empty_[voxel] = 0;
    spread(voxel, 1);
  }
  void take(std::size_t voxel) {
    empty_[voxel] = 1;
    spread(voxel, -1);
  }

  // Returns the empty voxel with the least energy; the first of several.
  std::size_t largest_void() {
    refresh();
    const auto row = std::min_element(rows_.begin(), rows_.end(),
                                      [](const Row& a, const Row& b) { return a.least < b.least; });
    std::size_t i = first_of(row);
    while (empty_[i] == 0 || energy_[i] != row->least) ++i;
    return i;
  }
  // Returns the point with the most energy; the first of several.
  std::size_t tightest_cluster() {
    refresh();
    const auto row = std::max_element(rows_.begin(), rows_.end(),
                                      [](const Row& a, const Row& b) { return a.most < b.most; });
    std::size_t i = first_of(row);
    while (empty_[i] != 0 || energy_[i] != row->most) ++i;
    return i;
  }

 private:
  struct Row {
    std::int32_t least = 0;  // energy of the row's empty voxels; kNone if it has none
    std::int32_t most = 0;   // energy of the row's points; -1 if it has none
    bool is_known = false;
  };

  std::size_t at(std::size_t x, std::size_t y, std::size_t z) const { return (z * side_ + y) * side_ + x; }
  std::size_t first_of(std::vector<Row>::const_iterator row) const {
    return static_cast<std::size_t>(row - rows_.begin()) * side_;
  }

  void refresh() {
    for (auto row = rows_.begin(); row != rows_.end(); ++row) {
      if (row->is_known) continue;
      *row = {kNone, -1, true};
      const std::size_t first = first_of(row);
      for (std::size_t i = first; i < first + side_; ++i) {
        if (empty_[i] != 0) row->least = std::min(row->least, energy_[i]);
        if (empty_[i] == 0) row->most = std::max(row->most, energy_[i]);
      }
    }
  }

  // A kernel that wraps around more than once adds up.
  void spread(std::size_t voxel, std::int32_t sign) {
    const std::size_t x = voxel % side_;
    const std::size_t y = voxel / side_ % side_;
    const std::size_t z = voxel / side_ / side_;
    auto weight = kernel_.begin();
    for (int dy = -kReach; dy <= kReach; ++dy) {
      const std::size_t row = moved(y, dy, side_);
      rows_[z * side_ + row].is_known = false;
      for (int dx = -kReach; dx <= kReach; ++dx) energy_[at(moved(x, dx, side_), row, z)] += sign * *weight++;
    }
    for (int dz = -kReach; dz <= kReach; ++dz) {
      if (dz == 0) continue;
      const std::size_t slice = moved(z, dz, slices_);
      rows_[slice * side_ + y].is_known = false;
      energy_[at(x, y, slice)] += sign * gaussian(dz * dz);
    }
  }

  std::size_t side_;
  std::size_t slices_;
  std::vector<std::int32_t> kernel_;
  std::vector<std::int32_t> energy_;
  std::vector<std::uint8_t> empty_;
  std::vector<Row> rows_;
};

// Makes Ulichney's initial pattern: a tenth of the voxels at random, then the tightest cluster moved into the
// largest void until that is its old place.
std::vector<std::size_t> initial_points(Volume& volume, const std::function<void()>& between) {
  std::vector<std::size_t> points;
  std::uint64_t state = 1;
  while (points.size() < std::max<std::size_t>(volume.voxels() / 10, 1)) {
    const auto voxel = static_cast<std::size_t>(mixed(state) % volume.voxels());
    if (!volume.is_empty(voxel)) continue;
    volume.put(voxel);
    points.push_back(voxel);
  }
  // Ties may move points in a circle.
  for (std::size_t moves = 0; moves < volume.voxels(); ++moves) {
    if (between && moves % kPointsBetween == 0) between();
    const std::size_t cluster = volume.tightest_cluster();
    volume.take(cluster);
    const std::size_t empty = volume.largest_void();
    volume.put(empty);
    if (empty == cluster) break;
    std::replace(points.begin(), points.end(), cluster, empty);
  }
  return points;
}

// Returns the place of every voxel in the order in which points fill the volume. Where more than half of it
// is filled, Ulichney looks for the tightest cluster of empty voxels. That is the largest void: both energies
// add up to that of a full volume.
std::vector<std::uint32_t> places(int side, int slices, const std::function<void()>& between) {
  Volume volume(side, slices);
  const std::vector<std::size_t> initial = initial_points(volume, between);
  std::vector<std::uint32_t> place(volume.voxels(), 0);
  Volume shrinking = volume;
  for (std::size_t left = initial.size(); left > 0; --left) {
    if (between && left % kPointsBetween == 0) between();
    const std::size_t cluster = shrinking.tightest_cluster();
    shrinking.take(cluster);
    place[cluster] = static_cast<std::uint32_t>(left - 1);
  }
  for (std::size_t filled = initial.size(); filled < volume.voxels(); ++filled) {
    if (between && filled % kPointsBetween == 0) between();
    const std::size_t empty = volume.largest_void();
    volume.put(empty);
    place[empty] = static_cast<std::uint32_t>(filled);
  }
  return place;
}

using Complex = std::complex<double>;

std::vector<Complex> transformed(const std::vector<Complex>& values) {
  const std::size_t size = values.size();
  std::vector<Complex> result(size);
  for (std::size_t k = 0; k < size; ++k)
    for (std::size_t i = 0; i < size; ++i)
      result[k] += values[i] * std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(k * i % size) /
                                                   static_cast<double>(size));
  return result;
}

std::vector<Complex> transformed_slice(const std::vector<double>& values, std::size_t first,
                                       std::size_t side) {
  std::vector<Complex> result(side * side);
  for (std::size_t y = 0; y < side; ++y) {
    const auto row = values.begin() + static_cast<std::ptrdiff_t>(first + y * side);
    const std::vector<Complex> line =
        transformed(std::vector<Complex>(row, row + static_cast<std::ptrdiff_t>(side)));
    std::copy(line.begin(), line.end(), result.begin() + static_cast<std::ptrdiff_t>(y * side));
  }
  for (std::size_t x = 0; x < side; ++x) {
    std::vector<Complex> column(side);
    for (std::size_t y = 0; y < side; ++y) column[y] = result[y * side + x];
    column = transformed(column);
    for (std::size_t y = 0; y < side; ++y) result[y * side + x] = column[y];
  }
  return result;
}

double variance_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return squares / count;
}

std::string row_of(const char* name, const std::vector<double>& powers) {
  std::string text = fmt::format("{:<22}", name);
  for (const double power : powers) text += fmt::format(" {:>6.3f}", power);
  return text + "\n";
}

std::string json_of(const NoiseSpectrum& spectrum) {
  const auto list = [](const std::vector<double>& powers) {
    std::string text;
    for (const double power : powers) text += fmt::format("{}{:.6f}", text.empty() ? "" : ", ", power);
    return text;
  };
  return fmt::format("{{\"spatial\": [{}], \"temporal\": [{}]}}", list(spectrum.spatial),
                     list(spectrum.temporal));
}

}  // namespace

NoiseMask generate_noise_mask(int side, int slices, const std::function<void()>& between) {
  if (side < 8 || side > 256 || slices < 1 || slices > 64)
    throw std::invalid_argument("a noise mask has 8 to 256 texels each way and 1 to 64 slices");
  const std::vector<std::uint32_t> place = places(side, slices, between);
  NoiseMask mask{side, slices, std::vector<std::uint16_t>(place.size())};
  const auto texels = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  std::vector<std::size_t> order(texels);
  for (std::size_t first = 0; first < place.size(); first += texels) {
    std::iota(order.begin(), order.end(), first);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place[a] < place[b]; });
    for (std::size_t rank = 0; rank < texels; ++rank)
      mask.ranks[order[rank]] = static_cast<std::uint16_t>(rank);
  }
  return mask;
}

NoiseSpectrum spectrum_of(const std::vector<double>& values, int side, int slices) {
  const auto width = static_cast<std::size_t>(side);
  const std::size_t texels = width * width;
  const double white = variance_of(values);
  NoiseSpectrum spectrum;
  std::vector<double> sums(kRings, 0.0);
  std::vector<double> counts(kRings, 0.0);
  for (std::size_t first = 0; first < values.size(); first += texels) {
    const std::vector<Complex> slice = transformed_slice(values, first, width);
    for (std::size_t i = 1; i < texels; ++i) {
      const auto along = [&](std::size_t k) { return static_cast<double>(std::min(k, width - k)); };
      const double frequency =
          std::hypot(along(i % width), along(i / width)) / (0.5 * static_cast<double>(width));
      const auto ring = static_cast<std::size_t>(frequency * kRings);
      if (ring >= sums.size()) continue;  // the corners, beyond the highest along an axis
      sums[ring] += std::norm(slice[i]) / (static_cast<double>(texels) * white);
      counts[ring] += 1.0;
    }
  }
  for (std::size_t ring = 0; ring < sums.size(); ++ring)
    spectrum.spatial.push_back(sums[ring] / counts[ring]);

  const auto frames = static_cast<std::size_t>(slices);
  spectrum.temporal.assign(frames / 2, 0.0);
  for (std::size_t texel = 0; texel < texels; ++texel) {
    std::vector<Complex> pixel(frames);
    for (std::size_t z = 0; z < frames; ++z) pixel[z] = values[z * texels + texel];
    pixel = transformed(pixel);
    for (std::size_t k = 1; k <= frames / 2; ++k)
      spectrum.temporal[k - 1] +=
          std::norm(pixel[k]) / (static_cast<double>(frames) * white * static_cast<double>(texels));
  }
  return spectrum;
}

NoiseSpectrum spectrum_of(const NoiseMask& mask) {
  return spectrum_of(std::vector<double>(mask.ranks.begin(), mask.ranks.end()), mask.side, mask.slices);
}

NoiseSpectrum gradient_noise_spectrum(int side, int slices) {
  std::vector<double> values;
  const auto fraction = [](float value) { return value - std::floor(value); };
  for (int frame = 0; frame < slices; ++frame)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const float moved = 5.588238F * static_cast<float>(frame & 63);
        const float sum = (static_cast<float>(x) + 0.5F + moved) * 0.06711056F +
                          (static_cast<float>(y) + 0.5F + moved) * 0.00583715F;
        values.push_back(fraction(52.9829189F * fraction(sum)));
      }
  return spectrum_of(values, side, slices);
}

std::string noise_mask_table(const NoiseMask& mask) {
  const NoiseSpectrum of_mask = spectrum_of(mask);
  const NoiseSpectrum of_gradient = gradient_noise_spectrum(mask.side, mask.slices);
  return fmt::format(
             "{} x {} texels, {} slices. Mean power of frequencies, white noise: 1.\n\n"
             "In a slice, in rings of 1/8 of the highest frequency along an axis:\n",
             mask.side, mask.side, mask.slices) +
         row_of("mask", of_mask.spatial) + row_of("gradient noise", of_gradient.spatial) +
         "\nAt a pixel over the slices, by periods:\n" + row_of("mask", of_mask.temporal) +
         row_of("gradient noise", of_gradient.temporal);
}

std::string noise_mask_json(const NoiseMask& mask) {
  std::string ranks;
  for (const std::uint16_t rank : mask.ranks) ranks += fmt::format("{}{}", ranks.empty() ? "" : ",", rank);
  return fmt::format(
      "{{\n  \"side\": {},\n  \"slices\": {},\n  \"spectrum\": {},\n  \"gradient_noise_spectrum\": {},\n"
      "  \"ranks\": [{}]\n}}\n",
      mask.side, mask.slices, json_of(spectrum_of(mask)),
      json_of(gradient_noise_spectrum(mask.side, mask.slices)), ranks);
}

}  // namespace penumbra::parameters
