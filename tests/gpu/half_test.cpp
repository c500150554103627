// Arithmetic in half: 16 bits wide where the device has them and the shader is compiled so, else 32.
#include <array>
#include <cmath>

#include "gpu/gpu_test.h"

namespace penumbra::gpu {
namespace {

using Pair = std::array<float, 2>;

// Rounds to the nearest number of 11 significant bits, ties to even; the number has a size that half has.
float rounded_to_half(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  const double scaled = std::ldexp(mantissa, 11);
  return static_cast<float>(std::ldexp(std::nearbyint(scaled), exponent - 11));
}

const std::vector<Pair> numbers{{1.0009765625F, 0.0F}, {3.3F, 0.0625F}, {0.1F, 100.0F}, {31.03F, -900.0F}};

std::vector<float> computed(const Device& device, bool half_is_16_bits) {
  shaders::CompileRequest request;
  request.file = PENUMBRA_SOURCE_DIR "/tests/gpu/shaders/Half.hlsl";
  request.half_is_16_bits = half_is_16_bits;
  const shaders::CompileResult compiled = shaders::compile(request);
  for (const hlsl::Diagnostic& diagnostic : compiled.diagnostics) ADD_FAILURE() << hlsl::format(diagnostic);
  ComputePass pass(device, {.spirv = compiled.spirv});
  const Buffer given(device, std::span<const Pair>(numbers));
  const Buffer result(device, numbers.size() * sizeof(float));
  pass.bindings().buffer("_Numbers", given);
  pass.bindings().buffer("_Result", result);
  pass.dispatch({static_cast<std::uint32_t>(numbers.size()), 1, 1});
  return result.download<float>();
}

TEST_F(Gpu, HalfIsFloatUnlessItIsAskedFor) {
  std::vector<float> expected;
  for (const auto& [x, y] : numbers) expected.push_back(x * x + y);
  EXPECT_EQ(computed(*device, false), expected);
}

TEST_F(Gpu, HalfRoundsTo11BitsWhereTheDeviceHasIt) {
  if (!device->info().half_arithmetic) GTEST_SKIP() << device->info().name << " has no 16-bit arithmetic";
  std::vector<float> expected;
  for (const auto& [x, y] : numbers) {
    const double half_x = rounded_to_half(x), half_y = rounded_to_half(y);
    expected.push_back(rounded_to_half(rounded_to_half(half_x * half_x) + half_y));
  }
  EXPECT_EQ(computed(*device, true), expected);
}

}  // namespace
}  // namespace penumbra::gpu
