// Mip levels, layers, slices and samples of images: what is written into one of them is read there, and
// nowhere else.
#include <array>

#include "gpu/gpu_test.h"
#include "input/input_error.h"

namespace penumbra::gpu {
namespace {

using Texel = std::array<float, 4>;

std::vector<Texel> filled(const Image& image, int mip, float value) {
  return std::vector<Texel>(image.size_bytes(mip) / sizeof(Texel), Texel{value, 0, 0, 1});
}

TEST(MipCounts, EndAtOneTexel) {
  EXPECT_EQ(mip_count(1, 1), 1);
  EXPECT_EQ(mip_count(5, 3), 3);
  EXPECT_EQ(mip_count(4, 4, 64), 7);
  EXPECT_EQ(mip_size(5, 1), 2);
  EXPECT_EQ(mip_size(5, 9), 1);
}

class GpuImageParts : public Gpu {
 protected:
  std::vector<float> read(const std::string& entry, const std::string& texture, const Image& image,
                          const std::vector<Texel>& points, SamplerKind kind = SamplerKind::linear_clamp,
                          ImageRange range = {}) {
    ComputePass pass(*device, {.spirv = compile_test_shader("ReadParts.hlsl", entry), .entry = entry});
    const Buffer where(*device, std::span<const Texel>(points));
    const Buffer result(*device, points.size() * sizeof(Texel));
    pass.bindings().image(texture, image, range);
    pass.bindings().sampler("_Sampler", Sampler(*device, kind));
    pass.bindings().buffer("_Points", where);
    pass.bindings().buffer("_Result", result);
    pass.dispatch({std::uint32_t(points.size()), 1, 1});
    std::vector<float> reds;
    for (const Texel& texel : result.download<Texel>()) reds.push_back(texel[0]);
    return reds;
  }
};

TEST_F(GpuImageParts, MipLevelsAreReadOneByOneAndBlended) {
  Image image(*device, ImageShape{.format = Format::rgba32f, .width = 5, .height = 3, .mips = 3});
  for (int mip = 0; mip < 3; ++mip)
    image.upload(filled(image, mip, 10.0F * static_cast<float>(mip)), {mip, 0});
  EXPECT_EQ(image.size_bytes(1), 2U * sizeof(Texel));
  EXPECT_EQ(image.download<Texel>({2, 0}), filled(image, 2, 20));
  const std::vector<Texel> levels{
      {0.5F, 0.5F, 0, 0}, {0.5F, 0.5F, 0, 1}, {0.5F, 0.5F, 0, 2}, {0.5F, 0.5F, 0, 0.5F}};
  EXPECT_THAT(read("OfMips", "_Mips", image, levels, SamplerKind::trilinear_clamp),
              testing::ElementsAre(0, 10, 20, testing::FloatNear(5, 0.1F)));
  EXPECT_THAT(read("OfMips", "_Mips", image, {{0.5F, 0.5F, 0, 0.7F}}), testing::ElementsAre(10))
      << "the nearest level";
  EXPECT_THAT(read("OfMips", "_Mips", image, levels, SamplerKind::linear_clamp, {.first_mip = 1, .mips = 2}),
              testing::ElementsAre(10, 20, 20, testing::AnyOf(10, 20)))
      << "levels are counted from the first of the range";
}

TEST_F(GpuImageParts, LayersAreReadOneByOne) {
  Image image(*device,
              ImageShape{.format = Format::rgba32f, .width = 2, .height = 2, .layers = 3, .mips = 2});
  for (int layer = 0; layer < 3; ++layer)
    for (int mip = 0; mip < 2; ++mip)
      image.upload(filled(image, mip, static_cast<float>(10 * layer + mip)), {mip, layer});
  EXPECT_THAT(
      read("OfLayers", "_Layers", image, {{0.5F, 0.5F, 0, 0}, {0.5F, 0.5F, 2, 0}, {0.5F, 0.5F, 1, 1}}),
      testing::ElementsAre(0, 20, 11));
  EXPECT_EQ(image.download<Texel>({1, 2}), filled(image, 1, 21));
  EXPECT_THAT(read("OfMips", "_Mips", image, {{0.5F, 0.5F, 0, 0}}, SamplerKind::linear_clamp,
                   {.first_layer = 2, .layers = 1}),
              testing::ElementsAre(20))
      << "one layer is a plain texture";
}

TEST_F(GpuImageParts, SlicesAreReadAndFiltered) {
  Image image(*device, ImageShape{.format = Format::rgba32f, .width = 1, .height = 1, .depth = 4});
  image.upload(std::vector<Texel>{{0}, {10}, {20}, {30}});
  EXPECT_THAT(read("OfSlices", "_Slices", image, {{0.5F, 0.5F, 0.125F, 0}, {0.5F, 0.5F, 0.75F, 0}}),
              testing::ElementsAre(0, testing::FloatNear(25, 0.1F)));
}

TEST_F(GpuImageParts, RefusesShapesAndPartsThatAreNone) {
  const auto make = [&](const ImageShape& shape) { return Image(*device, shape); };
  EXPECT_THROW(make({.width = 4, .height = 4, .depth = 2, .layers = 2}), std::invalid_argument);
  EXPECT_THROW(make({.width = 4, .height = 4, .mips = 4}), std::invalid_argument);
  EXPECT_THROW(make({.width = 4, .height = 4, .samples = 3}), std::invalid_argument);
  EXPECT_THROW(make({.width = 4, .height = 4, .mips = 2, .samples = 4}), std::invalid_argument);
  EXPECT_THROW(make({.width = 4, .height = 4, .samples = 64}), EnvironmentError);
  EXPECT_THROW(make({.width = 4, .height = 4, .layers = 1 << 20}), EnvironmentError);

  Image image(*device,
              ImageShape{.format = Format::rgba32f, .width = 4, .height = 4, .layers = 2, .mips = 2});
  EXPECT_THROW(image.download<Texel>({2, 0}), std::invalid_argument);
  EXPECT_THROW(image.download<Texel>({0, 2}), std::invalid_argument);
  ComputePass pass(*device, {.spirv = compile_test_shader("ReadParts.hlsl", "OfMips"), .entry = "OfMips"});
  EXPECT_THROW(pass.bindings().image("_Mips", image), std::logic_error) << "layers, and no array";
  EXPECT_THROW(pass.bindings().image("_Mips", image, {.first_mip = 2}), std::invalid_argument);
  EXPECT_THROW(pass.bindings().image("_Mips", image, {.first_layer = 1, .layers = 2}), std::invalid_argument);
  const Image slices(*device, ImageShape{.format = Format::rgba32f, .width = 4, .height = 4, .depth = 2});
  EXPECT_THROW(pass.bindings().image("_Mips", slices), std::logic_error);
  const Image samples(*device, ImageShape{.format = Format::rgba32f, .width = 4, .height = 4, .samples = 4});
  EXPECT_THROW(pass.bindings().image("_Mips", samples), std::logic_error);
  EXPECT_THROW(samples.download<Texel>(), std::logic_error);
}

}  // namespace
}  // namespace penumbra::gpu
