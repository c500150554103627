// Core/Noise.hlsl: the noise is Jimenez's, spread evenly, and turns disks without scaling them.
#include <algorithm>
#include <array>
#include <numbers>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

std::vector<float> pixels() {
  const std::vector<float> inputs = random_cases(24, [&](Random& random) {
    return Case{float(random.integer(0, 7679)) + 0.5f, float(random.integer(0, 4319)) + 0.5f,
                float(random.integer(0, 200))};
  });
  return inputs;
}

long double fraction(long double x) {
  return x - std::floor(x);
}

// The noise with the constants as the shader holds them.
long double gradient_noise(const float* in) {
  const long double move = static_cast<long double>(5.588238f) * (static_cast<int>(in[2]) % 64);
  const long double along = (in[0] + move) * 0.06711056f + (in[1] + move) * 0.00583715f;
  return fraction(static_cast<long double>(52.9829189f) * fraction(along));
}

// Inside, the dot product reaches 600 and is good to 2 ULP of that, 2^-13; times 53 that is 0.0065 of a turn.
// It is noise, but the same noise to within a hundredth on every device.
TEST(Noise, IsJimenezsGradientNoise) {
  const std::vector<float> inputs = pixels();
  const std::vector<float> results =
      run({"Noise", "Out(0, GradientNoise(In2(0), uint(InInt(2))));", 3, 1}, inputs);
  double worst = 0.0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    ASSERT_GE(results[i], 0.0f);
    ASSERT_LT(results[i], 1.0f);
    const double apart = std::fabs(static_cast<double>(results[i] - gradient_noise(&inputs[3 * i])));
    worst = std::max(worst, std::min(apart, 1.0 - apart));  // a turn later is the same rotation
  }
  EXPECT_LE(worst, 0.0065);
}

// Any 3 x 3 neighbourhood holds a low, a middle and a high value, so that a small blur removes the noise.
TEST(Noise, EveryNeighbourhoodCoversTheTurn) {
  std::vector<float> inputs;
  const int side = 150;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) inputs.insert(inputs.end(), {float(x) + 0.5f, float(y) + 0.5f, 0.0f});
  }
  const std::vector<float> noise =
      run({"Noise", "Out(0, GradientNoise(In2(0), uint(InInt(2))));", 3, 1}, inputs);
  for (int y = 0; y + 3 <= side; ++y) {
    for (int x = 0; x + 3 <= side; ++x) {
      std::array<int, 3> thirds{};
      for (int k = 0; k < 9; ++k) {
        const float value = noise[std::size_t(y + k / 3) * side + std::size_t(x + k % 3)];
        ++thirds.at(static_cast<std::size_t>(value * 3.0f));
      }
      for (const int count : thirds) ASSERT_GE(count, 1) << x << ", " << y;
    }
  }
}

// Sine and cosine are within 8 ULP of 1 on this device, plus the rounding of the angle (2 ULP of 2 pi, 2^-21
// absolute).
TEST(Noise, RotationsAreUnitVectorsAtTheirAngle) {
  std::vector<float> inputs;
  inputs.reserve(kRandomCases);
  for (int i = 0; i < kRandomCases; ++i) inputs.push_back(float(i) / kRandomCases);
  expect_exact(
      {"Noise", "Out2(0, RotationFromNoise(In(0)));", 1, 2}, inputs,
      [](const float* in) {
        const long double angle = 2.0L * std::numbers::pi_v<long double> * in[0];
        return std::vector<Exact>{{std::cos(angle), 1.0L}, {std::sin(angle), 1.0L}};
      },
      12.0L);
}

// A shift by any part of a turn correlates the sines or cosines of both.
TEST(Noise, CascadesAreChosenIndependentlyOfTheRotation) {
  const std::vector<float> results = run(
      {"Noise",
       "Out(0, GradientNoise(In2(0), uint(InInt(2)))); Out(1, CascadeNoise(In2(0), uint(InInt(2))));", 3, 2},
      pixels());
  const std::size_t count = results.size() / 2;
  double cosines = 0.0;
  double sines = 0.0;
  double mean = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_GE(results[2 * i + 1], 0.0f);
    ASSERT_LT(results[2 * i + 1], 1.0f);
    const double apart = 2.0 * std::numbers::pi *
                         (static_cast<double>(results[2 * i + 1]) - static_cast<double>(results[2 * i]));
    cosines += std::cos(apart);
    sines += std::sin(apart);
    mean += static_cast<double>(results[2 * i + 1]);
  }
  const double n = static_cast<double>(count);
  // Independent values would give 1 / sqrt(n), a hundredth.
  EXPECT_LT(std::hypot(cosines, sines) / n, 0.04);
  EXPECT_NEAR(mean / n, 0.5, 0.02);
}

TEST(Noise, DiskRotationIsTheRotationOfTheNoise) {
  const std::vector<float> results =
      run({"Noise",
           "const float2 a = DiskRotation(In2(0), uint(InInt(2))); const float2 b = "
           "RotationFromNoise(GradientNoise(In2(0), uint(InInt(2)))); Out(0, a.x - b.x); Out(1, a.y - b.y); "
           "Out(2, dot(a, a));",
           3, 3},
          pixels());
  for (std::size_t i = 0; i < results.size() / 3; ++i) {
    ASSERT_EQ(results[3 * i], 0.0f);
    ASSERT_EQ(results[3 * i + 1], 0.0f);
    ASSERT_NEAR(results[3 * i + 2], 1.0f, 16.0f * 0x1p-23f);
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
