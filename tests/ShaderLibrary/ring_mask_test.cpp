// Core/RingMask.hlsl against areas of rings and circles in long double.
#include <algorithm>
#include <bit>
#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

using Real = long double;

// The inputs are the mask as two 16-bit halves, penumbra, radius, taps and exponent.
const std::string kVisibility =
    "RingMask mask = EmptyRingMask(); mask.words[0] = uint(In(0)) | (uint(In(1)) << 16); const float rings = "
    "RingsInside(In(2) / In(3), InInt(4), InInt(5)); Out(0, rings); Out(1, RingVisibility(mask, rings, "
    "InInt(5))); Out(2, RingTapRadius(InInt(4) - 1, InInt(4), InInt(5)));";

struct Disc {
  Real radius;
  int taps, exponent;

  // Rings of equal area end at the square roots of k / N, rings of equal width at k / N.
  Real border(Real ring) const { return radius * (exponent == 1 ? std::sqrt(ring / taps) : ring / taps); }
};

Real area(Real radius) {
  return std::acos(Real(-1)) * radius * radius;
}

// The lit share of a circle; one inside of the innermost ring counts as that ring.
Real lit_share(std::uint32_t mask, Real penumbra, const Disc& disc) {
  const Real circle = std::clamp(penumbra, disc.border(1), disc.radius);
  Real blocked = 0;
  for (int ring = 0; ring < disc.taps; ++ring)
    if ((mask >> ring & 1u) != 0 && disc.border(ring) < circle)
      blocked += area(std::min(disc.border(ring + 1), circle)) - area(disc.border(ring));
  return 1 - blocked / area(circle);
}

TEST(RingMask, IsTheLitAreaOfTheRingsInsideOfThePenumbra) {
  Random random(73);
  std::vector<float> inputs;
  std::vector<std::uint32_t> masks;
  for (int i = 0; i < 10 * kRandomCases; ++i) {
    const int taps = i % 2 == 0 ? 32 : random.integer(1, 32);
    std::uint32_t mask = std::bit_cast<std::uint32_t>(random.any_bits());
    if (i % 7 == 0) mask = 0;
    if (i % 7 == 1) mask = 0xFFFFFFFFu;
    if (i % 7 == 2) mask = 1u << (i % 32);
    const float radius = random.between(1.0f, 100.0f);
    masks.push_back(mask);
    inputs.insert(inputs.end(), {static_cast<float>(mask & 0xFFFFu), static_cast<float>(mask >> 16),
                                 radius * random.between(0.0f, 1.3f), radius, static_cast<float>(taps),
                                 static_cast<float>(1 + i / 2 % 2)});
  }
  const std::vector<float> out = run({"RingMask", kVisibility, 6, 3}, inputs);
  for (std::size_t i = 0; i < masks.size(); ++i) {
    const float* in = &inputs[6 * i];
    const Disc disc{in[3], static_cast<int>(in[4]), static_cast<int>(in[5])};
    const float rings = out[3 * i], seen = out[3 * i + 1];
    ASSERT_NEAR(seen, static_cast<double>(lit_share(masks[i], in[2], disc)), 4e-6) << i;
    ASSERT_GE(rings, 1.0f);
    ASSERT_LE(rings, in[4]);
    const std::uint32_t all = disc.taps == 32 ? 0xFFFFFFFFu : (1u << disc.taps) - 1u;
    if (masks[i] == 0) {
      ASSERT_EQ(seen, 1.0f);
    }
    if ((masks[i] & all) == all) {
      ASSERT_EQ(seen, 0.0f) << i;
    }
    // The tap of the outermost ring lies where half of the ring's area is inside, or half of its width.
    const Real inner = disc.border(disc.taps - 1) / disc.radius;
    const Real middle = disc.exponent == 1 ? std::sqrt((inner * inner + 1) / 2) : (inner + 1) / 2;
    ASSERT_NEAR(out[3 * i + 2], static_cast<double>(middle), 1e-6) << i;
  }
}

// The inputs are sixteen random bits, which half of the word they are, the word's first ring, and the
// exponent.
TEST(RingMask, AddsTheAreasOfBitsByCounts) {
  const std::vector<float> inputs = random_cases(74, [&](Random& random, int i) {
    return Case{static_cast<float>(random.integer(0, 65535)), static_cast<float>(random.integer(0, 1)),
                static_cast<float>(32 * random.integer(0, 31)), static_cast<float>(1 + i % 2)};
  });
  const std::vector<float> out =
      run({"RingMask",
           "Out(0, float(AreaOfBits(uint(In(0)) << (In(1) > 0.5 ? 16u : 0u), InInt(2), InInt(3))));", 4, 1},
          inputs);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const float* in = &inputs[4 * i];
    float area = 0.0f;
    for (int bit = 0; bit < 16; ++bit) {
      const float ring = in[2] + 16.0f * in[1] + static_cast<float>(bit);
      if ((static_cast<unsigned>(in[0]) >> bit & 1u) != 0) area += in[3] == 1.0f ? 1.0f : 2.0f * ring + 1.0f;
    }
    ASSERT_EQ(out[i], area) << i;
  }
}

TEST(RingMask, BoundsItsCounts) {
  std::vector<float> inputs;
  for (int i = -40; i <= 80; ++i) inputs.push_back(static_cast<float>(i));
  const std::vector<float> out =
      run({"RingMask",
           "OutInt(0, BoundedRingCount(InInt(0))); OutInt(1, BoundedRingExponent(InInt(0))); Out(2, "
           "float(RingBit(InInt(0)) >> 16)); Out(3, float(RingBit(InInt(0)) & 0xFFFFu));",
           1, 4},
          inputs);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const int count = static_cast<int>(inputs[i]);
    ASSERT_EQ(out[4 * i], static_cast<float>(std::clamp(count, 1, 32)));
    ASSERT_EQ(out[4 * i + 1], static_cast<float>(std::clamp(count, 1, 2)));
    const std::uint32_t bit = 1u << (static_cast<unsigned>(count) & 31u);
    ASSERT_EQ(out[4 * i + 2], static_cast<float>(bit >> 16)) << count;
    ASSERT_EQ(out[4 * i + 3], static_cast<float>(bit & 0xFFFFu)) << count;
  }
}

TEST(RingMask, SelectsTheInnermostBits) {
  std::vector<float> counts;
  for (int i = -40; i <= 80; ++i) counts.push_back(static_cast<float>(i));
  const std::vector<float> out = run(
      {"RingMask",
       "const uint b = InnermostRings(InInt(0)); Out(0, float(b & 0xFFFFu)); Out(1, float(b >> 16));", 1, 2},
      counts);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const int bits = std::clamp(static_cast<int>(counts[i]), 0, 32);
    const auto expected = static_cast<std::uint32_t>((std::uint64_t(1) << bits) - 1);
    EXPECT_EQ(out[2 * i], static_cast<float>(expected & 0xFFFFu)) << counts[i];
    EXPECT_EQ(out[2 * i + 1], static_cast<float>(expected >> 16)) << counts[i];
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
