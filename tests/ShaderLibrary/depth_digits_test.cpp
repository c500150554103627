// Map/DepthDigits.hlsl: depths as integers, and the moments of their sums.
#include <array>
#include <cmath>
#include <cstdint>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

const CoreFunction kDepthDigits =
    function_in("Map", "DepthDigits",
                "uint4 d = DepthDigits(In(0)); for (int i = 0; i < 4; ++i) OutInt(i, int(d[i]));", 1, 4);
const CoreFunction kMomentDigits =
    function_in("Map", "DepthDigits",
                "uint4 d = MomentDigits(In(0)); for (int i = 0; i < 4; ++i) OutInt(i, int(d[i]));", 1, 4);

std::uint32_t word(float value) {
  return static_cast<std::uint32_t>(value);  // OutInt gives whole floats
}

double centred(float stored, DepthDirection direction) {
  return direction == DepthDirection::reversed ? 0.5 - stored : stored - 0.5;
}

TEST(DepthDigits, AreDepthAndSquareInStepsOfTheirLastPlace) {
  Random random(71);
  std::vector<float> depths{0.0f, 1.0f, 0.5f};
  for (int i = 0; i < kRandomCases; ++i) depths.push_back(random.between(0.0f, 1.0f));
  for (const DepthDirection direction : kDepthDirections) {
    const std::vector<float> out = run(kDepthDigits, direction, depths);
    for (std::size_t i = 0; i < depths.size(); ++i) {
      std::array<std::uint32_t, 4> digits{};
      for (std::size_t k = 0; k < 4; ++k) digits[k] = word(out[4 * i + k]);
      for (const std::uint32_t digit : digits) ASSERT_LT(digit, 4096u) << "12 bits: 2^20 of them fit in 32";
      const double z = centred(depths[i], direction);
      const double depth = std::ldexp(4096.0 * digits[0] + digits[1] - 8388608.0, -24);
      const double square = std::ldexp(4096.0 * digits[2] + digits[3], -26);
      // The depth is off by half a step, or by a whole one at 1/2, which has no digits. The float of the
      // centred depth is off by 2^-25.
      ASSERT_NEAR(depth, z, std::ldexp(z > 0.4999999 ? 1.5 : 1.0, -24)) << depths[i];
      ASSERT_NEAR(square, z * z, std::ldexp(z * z > 0.2499999 ? 3.0 : 2.5, -26)) << depths[i];
    }
  }
}

TEST(MomentDigits, AreTheStoredMomentsInSixteenBits) {
  const CoreFunction moments = function_in("Map", "DepthDigits", "Out4(0, StoredMoments(In(0)));", 1, 4);
  Random random(72);
  std::vector<float> depths{0.0f, 1.0f, 0.5f};
  for (int i = 0; i < kRandomCases; ++i) depths.push_back(random.between(0.0f, 1.0f));
  for (const DepthDirection direction : kDepthDirections) {
    const std::vector<float> digits = run(kMomentDigits, direction, depths);
    const std::vector<float> stored = run(moments, direction, depths);
    for (std::size_t i = 0; i < digits.size(); ++i) {
      ASSERT_LT(word(digits[i]), 65536u);
      ASSERT_NEAR(word(digits[i]), stored[i] * 65535.0, 0.51) << i;
    }
  }
}

// Digits are summed modulo 2^32 over the largest box that the file allows, and taken back.
TEST(DepthDigits, OfTheLargestBoxGiveItsMoments) {
  const CoreFunction back = function_in("Map", "DepthDigits", "Out2(0, MomentsOfDigits(In4(0)));", 4, 2);
  constexpr std::uint32_t kTexels = 1u << 20;
  Random random(73);
  std::vector<float> depths{1.0f, 1.0f, 0.0f, 0.0f};  // the extremes have the largest sums
  while (depths.size() < 2u * kRandomCases) depths.push_back(random.between(0.0f, 1.0f));
  const std::vector<float> digits = run(kDepthDigits, depths);
  std::vector<float> inputs;
  std::vector<std::array<double, 2>> exact;
  for (std::size_t i = 0; i < kRandomCases; ++i) {  // two depths in any shares
    const auto of_first = static_cast<std::uint32_t>(random.integer(0, int(kTexels)));
    double place[4];
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t sum =  // modulo 2^32
          word(digits[8 * i + k]) * of_first + word(digits[8 * i + 4 + k]) * (kTexels - of_first);
      const auto centred_sum = static_cast<std::int32_t>(sum - 2048u * kTexels);
      place[k] = static_cast<double>(centred_sum) / kTexels;
      inputs.push_back(static_cast<float>(centred_sum) / static_cast<float>(kTexels));
    }
    const double share = static_cast<double>(of_first) / kTexels;
    const double first = depths[2 * i] - 0.5, second = depths[2 * i + 1] - 0.5;
    exact.push_back(
        {share * first + (1 - share) * second, share * first * first + (1 - share) * second * second});
    ASSERT_NEAR(std::ldexp(4096 * place[0] + place[1] + 2048, -24), exact.back()[0], std::ldexp(1.5, -24))
        << i;
  }
  const std::vector<float> moments = run(back, inputs);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    ASSERT_NEAR(moments[2 * i], exact[i][0], std::ldexp(2.0, -24)) << i;
    ASSERT_NEAR(moments[2 * i + 1], exact[i][1], std::ldexp(1.0, -24)) << i;
    const double variance = exact[i][1] - exact[i][0] * exact[i][0];
    const double found = moments[2 * i + 1] - static_cast<double>(moments[2 * i]) * moments[2 * i];
    ASSERT_NEAR(found, variance, std::ldexp(1.0, -23)) << i << ": what smallestVariance covers";
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
