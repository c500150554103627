// Core/CascadeSelection.hlsl: the first sphere that holds the point, and never a cascade there is not.
#include <cstddef>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

constexpr const char* kSelect =
    "CascadeSpheres s; s.centre0 = In3(4); s.centre1 = In3(7); s.centre2 = In3(10); s.centre3 = In3(13); "
    "s.squaredRadii = In4(16); OutInt(0, SelectCascade(In3(1), s, InInt(0)));";

// The inputs are a count, a position, four centres and four squared radii: nested spheres in front of a
// camera up to 100 km from the origin, and positions anywhere about them.
std::vector<float> random_spheres(Random& random) {
  const float origin = random.integer(0, 3) == 0 ? random.between(-1e5f, 1e5f) : 0.0f;
  const float reach = random.between(5.0f, 200.0f);
  std::vector<float> words;
  words.push_back(float(random.integer(1, 4)));
  for (int axis = 0; axis < 3; ++axis) words.push_back(origin + random.between(-reach, reach));
  for (int sphere = 1; sphere <= 4; ++sphere) {
    for (int axis = 0; axis < 3; ++axis) {
      words.push_back(origin + (axis == 2 ? 0.4f * reach * float(sphere) / 4.0f : 0.0f));
    }
  }
  for (int sphere = 1; sphere <= 4; ++sphere) {
    const float radius = reach * float(sphere) / 4.0f;
    words.push_back(radius * radius);
  }
  return words;
}

long double squared_distance(const float* p, const float* centre) {
  long double sum = 0.0L;
  for (int axis = 0; axis < 3; ++axis) {
    const long double d = static_cast<long double>(p[axis]) - centre[axis];
    sum += d * d;
  }
  return sum;
}

// Whether the point lies near any sphere's surface, relative to its squared radius.
bool near_a_surface(const float* in) {
  for (int sphere = 0; sphere < 4; ++sphere) {
    const long double radius = in[16 + sphere];
    // The squared distance has three differences, products and sums: 6 roundings.
    if (std::fabs(squared_distance(in + 1, in + 4 + std::ptrdiff_t{3} * sphere) - radius) <
        6.0L * 0x1p-24L * radius)
      return true;
  }
  return false;
}

TEST(CascadeSelection, PicksTheFirstSphereAroundThePoint) {
  Random random(8);
  std::vector<float> inputs;
  int kept = 0;
  while (kept < kRandomCases) {
    const std::vector<float> spheres = random_spheres(random);
    if (near_a_surface(spheres.data())) continue;  // either answer is right there
    inputs.insert(inputs.end(), spheres.begin(), spheres.end());
    ++kept;
  }
  expect_exact(
      {"CascadeSelection", kSelect, 20, 1}, inputs,
      [](const float* in) {
        const int count = static_cast<int>(in[0]);
        int cascade = 0;
        while (cascade < count && squared_distance(in + 1, in + 4 + std::ptrdiff_t{3} * cascade) >=
                                      static_cast<long double>(in[16 + cascade])) {
          ++cascade;
        }
        return std::vector<Exact>{{static_cast<long double>(cascade)}};
      },
      0.0L);
}

TEST(CascadeSelection, StaysWithinTheCountForAnyNumbers) {
  Random random(9);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    inputs.push_back(float(random.integer(1, 4)));
    for (int k = 1; k < 20; ++k) inputs.push_back(random.any_bits());
    if (i % 2 == 0) inputs[inputs.size() - 19] = std::numeric_limits<float>::quiet_NaN();
  }
  const std::vector<float> results = run({"CascadeSelection", kSelect, 20, 1}, inputs);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const float count = inputs[20 * i];
    ASSERT_GE(results[i], 0.0f);
    ASSERT_LE(results[i], count);
    if (i % 2 == 0) {
      ASSERT_EQ(results[i], count) << "no sphere holds a position that is not a number";
    }
  }
}

constexpr const char* kWeight =
    "CascadeSpheres s; s.centre0 = In3(4); s.centre1 = In3(7); s.centre2 = In3(10); s.centre3 = In3(13); "
    "s.squaredRadii = In4(16); const float3 p = In3(1); Out(0, NextCascadeWeight(p, s, SelectCascade(p, s, "
    "InInt(0)), InInt(0), In(20)));";

TEST(NextCascadeWeight, GrowsThroughTheBorderOfTheOwnSphere) {
  Random random(10);
  std::vector<float> inputs;
  int kept = 0;
  int inside = 0;
  while (kept < kRandomCases) {
    const std::vector<float> spheres = random_spheres(random);
    if (near_a_surface(spheres.data())) continue;
    inputs.insert(inputs.end(), spheres.begin(), spheres.end());
    inputs.push_back(random.between(0.01f, 1.0f));
    ++kept;
  }
  expect_exact(
      {"CascadeSelection", kWeight, 21, 1}, inputs,
      [&](const float* in) {
        const int count = static_cast<int>(in[0]);
        const auto share = [&](int cascade) {
          return squared_distance(in + 1, in + 4 + std::ptrdiff_t{3} * cascade) / in[16 + cascade];
        };
        int cascade = 0;
        while (cascade < count && share(cascade) >= 1.0L) ++cascade;
        const long double begin = (1.0L - in[20]) * (1.0L - in[20]);
        // Roundings of the shares, up to 1, are divided by the border's width.
        const long double scale = 1.0L / (1.0L - begin);
        if (cascade + 1 >= count || share(cascade + 1) >= 1.0L) return std::vector<Exact>{{0.0L, scale}};
        const long double weight = std::clamp((share(cascade) - begin) / (1.0L - begin), 0.0L, 1.0L);
        inside += weight > 0.0L && weight < 1.0L ? 1 : 0;
        return std::vector<Exact>{{weight, scale}};
      },
      12.0L);
  EXPECT_GT(inside, kRandomCases / 20) << "positions in a border";
}

TEST(NextCascadeWeight, IsAShareForAnyNumbersAndZeroWithoutABorder) {
  Random random(11);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    inputs.push_back(float(random.integer(1, 4)));
    for (int k = 1; k < 21; ++k) inputs.push_back(random.any_bits());
    if (i % 2 == 0) inputs.back() = i % 4 == 0 ? 0.0f : std::numeric_limits<float>::quiet_NaN();
  }
  const std::vector<float> results = run({"CascadeSelection", kWeight, 21, 1}, inputs);
  for (std::size_t i = 0; i < results.size(); ++i) {
    ASSERT_GE(results[i], 0.0f) << words(&inputs[21 * i], 21);
    ASSERT_LE(results[i], i % 2 == 0 ? 0.0f : 1.0f) << words(&inputs[21 * i], 21);
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
