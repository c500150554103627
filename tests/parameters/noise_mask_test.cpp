// Tests the spatio-temporal blue-noise mask: its values, and its spectrum by direct sums and by white noise.
#include "parameters/noise_mask.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace penumbra::parameters {
namespace {

using ::testing::HasSubstr;

const NoiseMask& small_mask() {
  static const NoiseMask mask = generate_noise_mask(32, 8);
  return mask;
}

// The power |sum of (value - mean) e^(-i phase)|^2 over the slice, divided by what white noise has.
long double power_in_slice(const NoiseMask& mask, int slice, int u, int v) {
  const auto texels = static_cast<long double>(mask.side) * mask.side;
  const long double mean = (texels - 1) / 2;
  // The variance is that of the values 0 .. texels - 1, each once.
  const long double variance = (texels * texels - 1) / 12;
  long double real = 0;
  long double imaginary = 0;
  for (int y = 0; y < mask.side; ++y)
    for (int x = 0; x < mask.side; ++x) {
      const long double phase = 2 * std::numbers::pi_v<long double> * (u * x + v * y) / mask.side;
      real += (mask.rank(x, y, slice) - mean) * std::cos(phase);
      imaginary += (mask.rank(x, y, slice) - mean) * std::sin(phase);
    }
  return (real * real + imaginary * imaginary) / (texels * variance);
}

long double power_in_time(const NoiseMask& mask, int periods) {
  const auto texels = static_cast<long double>(mask.side) * mask.side;
  const long double variance = (texels * texels - 1) / 12;
  long double sum = 0;
  for (int y = 0; y < mask.side; ++y)
    for (int x = 0; x < mask.side; ++x) {
      long double real = 0;
      long double imaginary = 0;
      for (int z = 0; z < mask.slices; ++z) {
        const long double phase = 2 * std::numbers::pi_v<long double> * periods * z / mask.slices;
        real += mask.rank(x, y, z) * std::cos(phase);
        imaginary += mask.rank(x, y, z) * std::sin(phase);
      }
      sum += real * real + imaginary * imaginary;
    }
  return sum / (texels * mask.slices * variance);
}

TEST(NoiseMask, HasEachValueOnceInEverySlice) {
  const NoiseMask& mask = small_mask();
  for (int slice = 0; slice < mask.slices; ++slice) {
    std::vector<int> times(1024, 0);
    std::vector<int> bytes(256, 0);
    for (int y = 0; y < mask.side; ++y)
      for (int x = 0; x < mask.side; ++x) {
        ++times.at(mask.rank(x, y, slice));
        ++bytes.at(mask.byte(x, y, slice));
      }
    EXPECT_EQ(times, std::vector<int>(1024, 1));
    EXPECT_EQ(bytes, std::vector<int>(256, 4));
  }
}

// The power is that of the frequencies up to a quarter of the highest one, in every slice.
TEST(NoiseMask, HasLittlePowerAtLowFrequenciesOfASlice) {
  const NoiseMask& mask = small_mask();
  for (int slice = 0; slice < mask.slices; ++slice)
    for (int v = -4; v <= 4; ++v)
      for (int u = -4; u <= 4; ++u) {
        if ((u == 0 && v == 0) || u * u + v * v > 16) continue;
        EXPECT_LT(power_in_slice(mask, slice, u, v), 0.1L) << slice << ": " << u << ", " << v;
      }
}

TEST(NoiseMask, HasLittlePowerAtLowFrequenciesOfAPixel) {
  const NoiseMask& mask = small_mask();
  EXPECT_LT(power_in_time(mask, 1), 0.25L);
  EXPECT_GT(power_in_time(mask, 4), 1.2L);
  EXPECT_LT(power_in_time(mask, 1), power_in_time(mask, 2));
}

// Across the seam of the volume neighbours differ as much as inside: in x, in y and in time.
TEST(NoiseMask, RepeatsWithoutASeam) {
  const NoiseMask& mask = small_mask();
  const auto difference = [&](int dx, int dy, int dz, bool seam) {
    double sum = 0.0;
    int count = 0;
    for (int z = 0; z < mask.slices; ++z)
      for (int y = 0; y < mask.side; ++y)
        for (int x = 0; x < mask.side; ++x) {
          const bool wraps = x + dx >= mask.side || y + dy >= mask.side || z + dz >= mask.slices;
          if (wraps != seam) continue;
          sum += std::abs(mask.rank(x, y, z) -
                          mask.rank((x + dx) % mask.side, (y + dy) % mask.side, (z + dz) % mask.slices));
          ++count;
        }
    return sum / (count * 1024.0);
  };
  for (const auto& [dx, dy, dz] : {std::tuple{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    // Values that know nothing of each other differ by a third.
    EXPECT_GT(difference(dx, dy, dz, true), 0.36);
    EXPECT_NEAR(difference(dx, dy, dz, true), difference(dx, dy, dz, false), 0.03);
  }
}

TEST(NoiseMask, IsTheSameEachTime) {
  EXPECT_EQ(generate_noise_mask(16, 4).ranks, generate_noise_mask(16, 4).ranks);
}

TEST(NoiseMask, AsksOftenWhetherToStop) {
  int asked = 0;
  generate_noise_mask(16, 4, [&] { ++asked; });
  EXPECT_GT(asked, 10);
  EXPECT_THROW(generate_noise_mask(16, 4, [] { throw std::runtime_error("stop"); }), std::runtime_error);
}

TEST(NoiseMask, RefusesOtherSizes) {
  for (const int side : {-1, 0, 7, 257}) EXPECT_THROW(generate_noise_mask(side, 4), std::invalid_argument);
  for (const int slices : {-1, 0, 65}) EXPECT_THROW(generate_noise_mask(16, slices), std::invalid_argument);
}

TEST(NoiseSpectrum, IsThatOfTheDirectSums) {
  const NoiseMask& mask = small_mask();
  const NoiseSpectrum spectrum = spectrum_of(mask);
  ASSERT_EQ(spectrum.spatial.size(), 8U);
  ASSERT_EQ(spectrum.temporal.size(), 4U);
  for (int periods = 1; periods <= 4; ++periods)
    EXPECT_NEAR(spectrum.temporal[static_cast<std::size_t>(periods - 1)],
                static_cast<double>(power_in_time(mask, periods)), 1e-9);
  // The ring goes from 2/8 to 3/8 of the highest frequency, 16 periods in the slice.
  long double sum = 0;
  int count = 0;
  for (int slice = 0; slice < mask.slices; ++slice)
    for (int v = -6; v <= 6; ++v)
      for (int u = -6; u <= 6; ++u) {
        const int squared = u * u + v * v;
        if (squared < 16 || squared >= 36) continue;
        sum += power_in_slice(mask, slice, u, v);
        ++count;
      }
  EXPECT_NEAR(spectrum.spatial[2], static_cast<double>(sum / count), 1e-9);
}

TEST(NoiseSpectrum, OfWhiteNoiseIsOne) {
  std::mt19937 random(7);
  std::vector<double> values(std::size_t{32} * 32 * 16);
  for (double& value : values) value = static_cast<double>(random());
  const NoiseSpectrum spectrum = spectrum_of(values, 32, 16);
  for (const double power : spectrum.spatial) EXPECT_NEAR(power, 1.0, 0.3);
  for (const double power : spectrum.temporal) EXPECT_NEAR(power, 1.0, 0.1);
}

TEST(NoiseMask, IsPrintedWithItsSpectrum) {
  const NoiseMask mask = generate_noise_mask(8, 2);
  EXPECT_THAT(noise_mask_table(mask), HasSubstr("8 x 8 texels, 2 slices"));
  EXPECT_THAT(noise_mask_json(mask), HasSubstr("\"side\": 8"));
}

}  // namespace
}  // namespace penumbra::parameters
