// Core/PowersOfTwo.hlsl: exact for every exponent, and at, just below and just above every power.
#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

TEST(PowersOfTwo, ArePowersOfEveryExponent) {
  std::vector<float> inputs;
  while (inputs.size() < std::size_t(kRandomCases))
    for (int exponent = -126; exponent <= 127; ++exponent) inputs.push_back(float(exponent));
  expect_exact(
      {"PowersOfTwo", "Out(0, PowerOfTwo(int(In(0))));", 1, 1}, inputs,
      [](const float* in) { return std::vector<Exact>{{std::ldexp(1.0L, int(in[0]))}}; }, 0.0L);
}

TEST(PowersOfTwo, CeilLog2IsTheSmallestExponentThatReachesTheValue) {
  std::vector<float> inputs;
  for (int exponent = 0; exponent <= 127; ++exponent) {
    const float power = std::ldexp(1.0f, exponent);
    if (exponent > 0) inputs.push_back(std::nextafter(power, 0.0f));
    inputs.push_back(power);
    if (exponent < 127) inputs.push_back(std::nextafter(power, 2.0f * power));
  }
  Random random(5);
  while (inputs.size() < std::size_t(kRandomCases))
    inputs.push_back(std::ldexp(random.between(1.0f, 2.0f), int(random.between(0.0f, 127.0f))));
  expect_exact(
      {"PowersOfTwo", "Out(0, float(CeilLog2(In(0))));", 1, 1}, inputs,
      [](const float* in) {
        int exponent = 0;
        while (std::ldexp(1.0L, exponent) < static_cast<long double>(in[0])) ++exponent;
        return std::vector<Exact>{{static_cast<long double>(exponent)}};
      },
      0.0L);
}

}  // namespace
}  // namespace penumbra::shader_library_tests
