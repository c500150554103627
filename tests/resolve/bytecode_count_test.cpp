// Compares counts of FXC's bytecode with its own listing.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "gpu/compute_pass.h"
#include "resolve/test_device.h"
#include "resolve/texel_counter.h"
#include "shaders/bytecode_module.h"
#include "shaders/counted_module.h"

namespace penumbra::resolve {
namespace {

std::string bytecode(const char* name) {
  std::ifstream file(std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests" / "shaders" / "bytecode" / name,
                     std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The program is tests/shaders/bytecode/operations.hlsl. With buffers of 0, each thread executes
// store_structured g0, xor, ld_structured g0, sqrt, mad, lt, movc, movc, lt. With values of 4, sqrt(4) * 3 +
// 1 is 7, and div follows.
std::uint64_t operations_with(float value) {
  const shaders::BytecodeModule made = shaders::bytecode_module(bytecode("operations.dxbc"), "Main");
  const spirv::Module counting = shaders::counted_module(made.untouched, "Main", shaders::VulkanVersion::v1_1,
                                                         shaders::translation_steps(made.untouched));
  gpu::ComputePass pass(test_device(), {.spirv = counting, .entry = "Main"});
  std::vector<float> pairs;  // the first of each pair is the kind, 0
  for (int i = 0; i < 8; ++i) pairs.insert(pairs.end(), {0.0F, value});
  const gpu::Buffer in(test_device(), std::span<const float>(pairs));
  const gpu::Buffer out(test_device(), std::span<const float>(std::vector<float>(8, -1.0F)));
  const TexelCounter counter(test_device());
  pass.bindings().buffer("_In", in);
  pass.bindings().buffer("_Out", out);
  pass.bindings().buffer(shaders::texel_counts_name, counter.buffer());
  pass.dispatch({1, 1, 1});
  const float expected = value == 0.0F ? 1.0F : 1.0F / 7.0F;
  for (const float one : out.download<float>()) EXPECT_FLOAT_EQ(one, expected);
  const TexelCounts counts = counter.counts();
  EXPECT_EQ(counts.invocations, 8);
  EXPECT_EQ(counts.fetches[0], 0) << "of textures";
  return counts.operations[0];
}

TEST(BytecodeCount, OperationsAreThoseOfTheListing) {
  if (!shaders::translates_bytecode()) GTEST_SKIP() << "built without vkd3d-shader (libvkd3d-dev)";
  EXPECT_EQ(operations_with(0.0F), 8 * 9);
  EXPECT_EQ(operations_with(4.0F), 8 * 10);
}

}  // namespace
}  // namespace penumbra::resolve
