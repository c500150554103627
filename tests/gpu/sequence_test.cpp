// Passes in one submission: each sees what those before it wrote, and waits for nothing else.
#include "gpu/sequence.h"

#include <algorithm>
#include <array>

#include "gpu/gpu_test.h"

namespace penumbra::gpu {
namespace {

constexpr std::uint32_t kSize = 8;

class GpuSequence : public Gpu {
 protected:
  void SetUp() override {
    Gpu::SetUp();
    for (std::uint32_t i = 0; i < kSize * kSize; ++i)
      texels.push_back(static_cast<float>((i * 37 + 11) % 64) / 63);
  }
  ComputePass pass(const std::string& entry) {
    return {*device, {.spirv = compile_test_shader("Pyramid.hlsl", entry), .entry = entry}};
  }
  Image pyramid() {
    Image image(*device, ImageShape{.format = Format::r32f, .width = kSize, .height = kSize, .mips = 4});
    image.upload(texels);
    return image;
  }
  std::vector<float> texels;
};

TEST_F(GpuSequence, ALevelOfAPyramidIsMadeOfTheOneBelowInTheSameImage) {
  const Image image = pyramid();
  ComputePass reduce = pass("Reduce");
  Sequence sequence(*device);
  std::vector<Bindings> levels;
  for (int mip = 1; mip < 4; ++mip) {
    levels.push_back(reduce.more_bindings());
    levels.back().image("_Below", image, {.first_mip = mip - 1, .mips = 1});
    levels.back().image("_Above", image, {.first_mip = mip});
    const std::uint32_t size = kSize >> static_cast<unsigned>(mip);
    sequence.dispatch(reduce, levels.back(), {size, size, 1});
  }
  EXPECT_EQ(sequence.run().size(), 3U);
  EXPECT_EQ(image.download<float>({3, 0}),
            std::vector<float>{*std::max_element(texels.begin(), texels.end())});
  const std::vector<float> first = image.download<float>({1, 0});
  for (std::size_t y = 0; y < 4; ++y) {
    for (std::size_t x = 0; x < 4; ++x) {
      const std::size_t at = 2 * y * kSize + 2 * x;
      EXPECT_EQ(first[4 * y + x],
                std::max({texels[at], texels[at + 1], texels[at + kSize], texels[at + kSize + 1]}));
    }
  }
  EXPECT_EQ(sequence.waited(), std::vector<bool>(3, true));
  EXPECT_EQ(sequence.run().size(), 3U) << "again, from the layouts that the first run left";
}

TEST_F(GpuSequence, WaitsOnlyForWhatItReadsOrOverwrites) {
  ComputePass zeros = pass("Zeros");
  const std::vector<std::uint32_t> one{1};
  const Buffer first(*device, std::span<const std::uint32_t>(one));
  const Buffer second(*device, std::span<const std::uint32_t>(one));
  Bindings on_first = zeros.more_bindings();
  on_first.buffer("_Zeroed", first);
  Bindings on_second = zeros.more_bindings();
  on_second.buffer("_Zeroed", second);
  Sequence sequence(*device);
  sequence.dispatch(zeros, on_first, {1, 1, 1});
  sequence.dispatch(zeros, on_second, {1, 1, 1});
  sequence.dispatch(zeros, on_first, {1, 1, 1});
  sequence.run();
  EXPECT_EQ(sequence.waited(), (std::vector<bool>{false, false, true}));
  EXPECT_EQ(first.download<std::uint32_t>(), std::vector<std::uint32_t>{0});
  EXPECT_EQ(second.download<std::uint32_t>(), std::vector<std::uint32_t>{0});
}

TEST_F(GpuSequence, ReadersOfOneImageDoNotWaitForEachOther) {
  const Image image = pyramid();
  ComputePass count = pass("Count");
  const Buffer first(*device, 4);
  const Buffer second(*device, 4);
  const Buffer third(*device, 4);
  std::vector<Bindings> all;
  Sequence sequence(*device);
  for (const Buffer* counted : {&first, &second, &third}) {
    all.push_back(count.more_bindings());
    all.back().image("_Below", image, {.mips = 1});
    all.back().buffer("_Count", *counted);
    sequence.dispatch(count, all.back(), {kSize, kSize, 1});
  }
  sequence.run();
  EXPECT_EQ(sequence.waited(), (std::vector<bool>{true, false, false})) << "the first changes the layout";
  sequence.run();
  EXPECT_EQ(sequence.waited(), (std::vector<bool>{false, false, false}));
}

TEST_F(GpuSequence, ClearsEveryLevelAndLayerBetweenPasses) {
  const Image image = pyramid();
  const Image layers(*device, ImageShape{.format = Format::rg32f, .width = 2, .height = 1, .layers = 2});
  const Image depth(*device, Format::depth32, 2, 2);
  const Image depth16(*device, Format::depth16, 1, 1);
  Image numbers(*device, Format::r32ui, 1, 1);
  numbers.upload(std::vector<std::uint32_t>{7});
  ComputePass reduce = pass("Reduce");
  reduce.bindings().image("_Below", image, {.first_mip = 0, .mips = 1});
  reduce.bindings().image("_Above", image, {.first_mip = 1});
  Sequence sequence(*device);
  sequence.clear(image, 0.25F);
  sequence.dispatch(reduce, reduce.bindings(), {4, 4, 1});
  sequence.clear(layers, 3.0F);
  sequence.clear(depth, 1.0F);
  sequence.clear(depth16, 0.0F);
  sequence.clear(numbers, 0.0F);
  sequence.run();
  EXPECT_EQ(image.download<float>({0, 0}), std::vector<float>(64, 0.25F));
  EXPECT_EQ(image.download<float>({1, 0}), std::vector<float>(16, 0.25F));
  EXPECT_EQ(image.download<float>({3, 0}), std::vector<float>{0.25F});
  for (int layer = 0; layer < 2; ++layer)
    EXPECT_EQ(layers.download<float>({0, layer}), std::vector<float>(4, 3.0F));
  EXPECT_EQ(depth.download<float>(), std::vector<float>(4, 1.0F));
  EXPECT_EQ(depth16.download<std::uint16_t>(), std::vector<std::uint16_t>{0});
  EXPECT_EQ(numbers.download<std::uint32_t>(), std::vector<std::uint32_t>{0});
  EXPECT_TRUE(sequence.waited().at(1));
  EXPECT_THROW(sequence.clear(numbers, 1.0F), std::invalid_argument);
}

TEST_F(GpuSequence, RefusesWhatHasNoMeaning) {
  const Image image = pyramid();
  ComputePass reduce = pass("Reduce");
  ComputePass zeros = pass("Zeros");
  Sequence sequence(*device);
  EXPECT_THROW(sequence.dispatch(zeros, zeros.bindings(), {1, 1, 1}), std::logic_error) << "nothing bound";
  zeros.bindings().buffer("_Zeroed", Buffer(*device, 4));
  EXPECT_THROW(sequence.dispatch(reduce, zeros.bindings(), {1, 1, 1}), std::logic_error) << "another pass's";
  reduce.bindings().image("_Below", image, {.first_mip = 1, .mips = 1});
  reduce.bindings().image("_Above", image, {.first_mip = 1});
  EXPECT_THROW(reduce.dispatch({1, 1, 1}), std::logic_error) << "reads and writes the same level";
  sequence.dispatch(zeros, zeros.bindings(), {1, 1, 1});
  zeros.bindings().buffer("_Zeroed", Buffer(*device, 4));
  EXPECT_THROW(sequence.run(), std::logic_error) << "replaced after it was put into the sequence";
}

// What a subgroup has is said by the device; where it adds, its lanes see their sum.
TEST_F(GpuSequence, LanesOfASubgroupSeeTheirSum) {
  const SubgroupInfo info = device->info().subgroup;
  EXPECT_GE(info.lanes, 1);
  if (!info.arithmetic || 32 % info.lanes != 0)
    GTEST_SKIP() << "no sums over subgroups on " << device->info().name;
  ComputePass sums(*device, {.spirv = compile_test_shader("Samples.hlsl", "Sums"), .entry = "Sums"});
  const Buffer result(*device, 64 * sizeof(float));
  sums.bindings().buffer("_Result", result);
  sums.dispatch({1, 1, 1});
  const std::vector<float> values = result.download<float>();
  float expected = 0;
  for (int lane = 0; lane < info.lanes; ++lane) expected += static_cast<float>(lane);
  EXPECT_EQ(values[0], expected);
  EXPECT_EQ(values[32], static_cast<float>(info.lanes));
}

}  // namespace
}  // namespace penumbra::gpu
