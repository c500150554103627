// Core/Disk.hlsl: golden-angle and Poisson points, against their definitions in long double.
#include <algorithm>
#include <numbers>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

const std::vector<std::pair<std::string, std::string>> kUnlimited = {{"PENUMBRA_UNLIMITED", "1"}};

// Vulkan asks of sine and cosine no more than 2^-11 absolute; a vector that is turned by them is made unit
// length again. The software device does better, and this bound holds it to that.
constexpr long double kTrigonometricUlp = 8.0L;  // ULP of 1

// The turn modulo one, in long double, is exact to 2^-50 for the indices here.
long double golden_turn(int index) {
  const long double turns = index * (2.0L - std::numbers::phi_v<long double>);
  return turns - std::floor(turns);
}

std::vector<Exact> golden_direction(int index) {
  const long double angle = 2.0L * std::numbers::pi_v<long double> * golden_turn(index);
  return {{std::cos(angle), 1.0L}, {std::sin(angle), 1.0L}};
}

std::vector<float> repeated_indices(int count) {
  std::vector<float> inputs;
  inputs.reserve(4 * std::size_t(kRandomCases));
  for (int i = 0; i < 4 * kRandomCases; ++i) inputs.push_back(float(i % count));
  return inputs;
}

// The 24 bits kept of a turn are 2^-24 of it, 2 pi times as much in angle: 3 more ULP of 1 (2^-23).
TEST(Disk, GoldenDirectionsKeepTheirAngleAtHighIndices) {
  expect_exact(
      {"Disk", "Out2(0, GoldenDirection(InInt(0)));", 1, 2}, repeated_indices(4096),
      [](const float* in) { return golden_direction(static_cast<int>(in[0])); }, kTrigonometricUlp + 3.0L);
}

TEST(Disk, FibonacciTableHoldsTheGoldenDirections) {
  expect_exact(
      {"Disk", "Out2(0, FibonacciDirection(InInt(0)));", 1, 2}, repeated_indices(64),
      [](const float* in) { return golden_direction(static_cast<int>(in[0])); }, 0.51L);
  expect_exact(
      {"Disk", "Out2(0, FibonacciDirection(InInt(0)));", 1, 2, kUnlimited}, repeated_indices(4096),
      [](const float* in) { return golden_direction(static_cast<int>(in[0])); }, kTrigonometricUlp + 3.0L);
}

TEST(Disk, IndicesOutsideTheTablesGiveTheirEnds) {
  const std::vector<float> inputs = {-1.0f, 0.0f, 63.0f, 64.0f, 1e6f, -1e6f};
  const std::vector<float> results = run(
      {"Disk", "Out2(0, FibonacciDirection(InInt(0))); Out2(2, PoissonDisk(InInt(0), 64));", 1, 4}, inputs);
  const auto row = [&](std::size_t i) { return std::vector<float>(&results[4 * i], &results[4 * i] + 4); };
  EXPECT_EQ(row(0), row(1));
  EXPECT_EQ(row(5), row(1));
  EXPECT_EQ(row(3), row(2));
  EXPECT_EQ(row(4), row(2));
}

std::vector<float> index_and_count(int largest) {
  const std::vector<float> inputs = random_cases(21, [&](Random& random, int i) {
    const int count = i % 4 == 0 ? (i % 8 == 0 ? 1 : largest) : random.integer(1, largest);
    const int index = i % 3 == 0 ? count - 1 : random.integer(0, count - 1);
    return Case{float(index), float(count), i % 2 == 0 ? 1.0f : random.between(1.0f, 4.0f)};
  });
  return inputs;
}

long double fibonacci_radius(const float* in) {
  return std::pow((in[0] + 0.5L) / in[1], 0.5L * in[2]);
}

// pow is exp2(y log2 x) with 3 ULP in either factor (Vulkan); log2 x reaches 13 for 4096 points and y 2, so
// the exponent is off by up to 26 x 3 ULP relative to a result of 1.
TEST(Disk, FibonacciRadiusFollowsItsPower) {
  expect_exact(
      {"Disk", "Out(0, FibonacciRadius(InInt(0), InInt(1), In(2)));", 3, 1}, index_and_count(4096),
      [](const float* in) { return std::vector<Exact>{{fibonacci_radius(in)}}; }, 80.0L);
}

// Every octave has as many points, so the logarithm of the radius is even. pow is as above, with a base up to
// 2^13.
TEST(Disk, GeometricRadiusFillsEveryOctaveAlike) {
  const std::vector<float> inputs = random_cases(32, [&](Random& random) {
    const int count = random.integer(1, 4096);
    return Case{float(random.integer(0, count - 1)), float(count), random.between(0.01f, 1.0f),
                std::pow(10.0f, random.between(0.0f, 3.5f))};
  });
  expect_exact(
      {"Disk", "Out(0, GeometricRadius(InInt(0), InInt(1), In(2), In(3)));", 4, 1}, inputs,
      [](const float* in) {
        const long double step = (in[0] + 0.5L) / in[1];
        const long double logarithm =
            (1.0L - step) * std::log2(in[2] + 0.0L) + step * std::log2(in[3] + 0.0L);
        return std::vector<Exact>{{std::exp2(logarithm)}};
      },
      80.0L);
}

TEST(Disk, PointsAreDirectionTimesRadius) {
  expect_exact(
      {"Disk",
       "const float2 f = FibonacciDisk(InInt(0), InInt(1), In(2)); const float2 v = VogelDisk(InInt(0), "
       "InInt(1)); Out2(0, f.xy); Out2(2, v.xy);",
       3, 4},
      index_and_count(64),
      [](const float* in) {
        const std::vector<Exact> direction = golden_direction(static_cast<int>(in[0]));
        const long double clumped = fibonacci_radius(in);
        const long double even = std::sqrt((in[0] + 0.5L) / in[1]);
        return std::vector<Exact>{{direction[0].value * clumped, clumped},
                                  {direction[1].value * clumped, clumped},
                                  {direction[0].value * even, even},
                                  {direction[1].value * even, even}};
      },
      80.0L);
}

TEST(Disk, SpiralPointsLieInsideTheDisk) {
  for (const auto& defines : {std::vector<std::pair<std::string, std::string>>{}, kUnlimited}) {
    for (const float radius :
         run({"Disk", "Out(0, FibonacciRadius(InInt(0), InInt(1), In(2)));", 3, 1, defines},
             index_and_count(defines.empty() ? 64 : 4096))) {
      ASSERT_GT(radius, 0.0f);
      ASSERT_LT(radius, 1.0f);
    }
  }
}

TEST(Disk, PoissonSetsAreDistinctPointsOfTheDisk) {
  std::vector<float> inputs;
  for (const int count : {25, 32, 64, 100, 128}) {
    for (int i = 0; i < count; ++i) inputs.insert(inputs.end(), {float(i), float(count)});
  }
  const std::vector<float> results = run({"Disk", "Out2(0, PoissonDisk(InInt(0), InInt(1)));", 2, 2}, inputs);
  std::vector<std::pair<float, float>> points;
  for (std::size_t i = 0; i < results.size() / 2; ++i) {
    const std::pair<float, float> point(results[2 * i], results[2 * i + 1]);
    EXPECT_LE(std::hypot(point.first, point.second), 1.0f + 1e-6f) << "point " << i;
    EXPECT_EQ(std::count(points.begin(), points.end(), point), 0) << "point " << i;
    points.push_back(point);
  }
  EXPECT_EQ(points.size(), 25u + 32u + 64u + 100u + 128u);
}

TEST(Disk, UnlimitedPoissonIsVogels) {
  expect_exact(
      {"Disk", "Out2(0, PoissonDisk(InInt(0), InInt(1)));", 3, 2, kUnlimited}, index_and_count(4096),
      [](const float* in) {
        const std::vector<Exact> direction = golden_direction(static_cast<int>(in[0]));
        const long double even = std::sqrt((in[0] + 0.5L) / in[1]);
        return std::vector<Exact>{{direction[0].value * even, even}, {direction[1].value * even, even}};
      },
      kTrigonometricUlp + 8.0L);
}

TEST(Disk, CountsAreBoundedToWhatThereIs) {
  std::vector<float> inputs;
  inputs.reserve(std::size_t(kRandomCases) + 2);
  for (int i = -kRandomCases / 2; i < kRandomCases / 2; ++i) inputs.push_back(float(i));
  inputs.insert(inputs.end(), {2e9f, -2e9f});
  expect_exact(
      {"Disk", "OutInt(0, BoundedSampleCount(InInt(0))); OutInt(1, PoissonSetSize(InInt(0)));", 1, 2}, inputs,
      [](const float* in) {
        long double set = 128.0L;
        for (const float size : {100.0f, 64.0f, 32.0f, 25.0f}) set = in[0] <= size ? size : set;
        return std::vector<Exact>{{std::clamp(in[0], 1.0f, 128.0f)}, {set}};
      },
      0.0L);
  expect_exact(
      {"Disk", "OutInt(0, BoundedSampleCount(InInt(0))); OutInt(1, PoissonSetSize(InInt(0)));", 1, 2,
       kUnlimited},
      inputs,
      [](const float* in) {
        const float bounded = std::clamp(in[0], 1.0f, 4096.0f);
        return std::vector<Exact>{{bounded}, {bounded}};
      },
      0.0L);
}

// The result has two products and a sum, at the size of the products.
TEST(Disk, RotationTurnsAndKeepsTheLength) {
  const std::vector<float> inputs = random_cases(22, [&](Random& random) {
    const float angle = random.between(0.0f, 6.2831f);
    return Case{random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f), std::cos(angle), std::sin(angle)};
  });
  expect_exact(
      {"Disk", "Out2(0, RotateDisk(In2(0), In2(2)));", 4, 2}, inputs,
      [](const float* in) {
        const long double xx = static_cast<long double>(in[0]) * in[2],
                          yy = static_cast<long double>(in[1]) * in[3];
        const long double xy = static_cast<long double>(in[0]) * in[3],
                          yx = static_cast<long double>(in[1]) * in[2];
        return std::vector<Exact>{{xx - yy, std::fabs(xx) + std::fabs(yy)},
                                  {xy + yx, std::fabs(xy) + std::fabs(yx)}};
      },
      1.5L);
}

// rsqrt: 2 ULP (Vulkan), its argument 2 more halved, one product.
TEST(Disk, AnythingBecomesAUnitRotation) {
  Random random(23);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    const bool ordinary = i % 2 == 0;
    inputs.push_back(ordinary ? random.between(-1.5f, 1.5f) : random.any_bits());
    inputs.push_back(ordinary ? random.between(-1.5f, 1.5f) : random.any_bits());
  }
  const std::vector<float> results = run({"Disk", "Out2(0, UnitRotation(In2(0)));", 2, 2}, inputs);
  for (std::size_t i = 0; i < inputs.size() / 2; ++i) {
    const long double x = results[2 * i], y = results[2 * i + 1];
    ASSERT_NEAR(static_cast<double>(x * x + y * y), 1.0, 8.0 * 0x1p-23) << words(&inputs[2 * i], 2);
    const long double length =
        std::hypot(static_cast<long double>(inputs[2 * i]), static_cast<long double>(inputs[2 * i + 1]));
    if (i % 2 == 0 && length > 0.01L) {
      ASSERT_NEAR(static_cast<double>(x), static_cast<double>(inputs[2 * i] / length), 4.0 * 0x1p-23);
    }
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
