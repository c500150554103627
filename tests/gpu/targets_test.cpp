// What passes draw into: many colours, integers, mip levels and layers, several samples, blending.
#include <array>
#include <cmath>
#include <cstring>

#include "gpu/gpu_test.h"
#include "input/input_error.h"

namespace penumbra::gpu {
namespace {

using Colour = std::array<float, 4>;

class GpuTargets : public Gpu {
 protected:
  static RasterShaders shaders(const std::string& fragment, std::vector<Format> colours,
                               const std::string& vertex = "Whole") {
    RasterShaders made;
    made.vertex = compile_test_shader("Targets.hlsl", vertex, hlsl::Stage::vertex);
    made.vertex_entry = vertex;
    made.fragment = compile_test_shader("Targets.hlsl", fragment, hlsl::Stage::fragment);
    made.fragment_entry = fragment;
    made.colours = std::move(colours);
    return made;
  }
  static RasterTile tile(int width, int height, Colour colour = {1, 2, 3, 4}) {
    RasterTile made{0, 0, width, height, 3, {}};
    made.push_constants.resize(sizeof(colour));
    std::memcpy(made.push_constants.data(), &colour, sizeof(colour));
    return made;
  }
};

TEST_F(GpuTargets, AreAsManyColoursAsTheShaderWrites) {
  RasterPass pass(*device, shaders("Four", std::vector<Format>(4, Format::rgba32f)));
  std::vector<Image> images;
  for (int i = 0; i < 4; ++i) images.emplace_back(*device, Format::rgba32f, 2, 2);
  pass.draw({{&images[0], &images[1], &images[2], &images[3]}}, {tile(2, 2)});
  for (int i = 0; i < 4; ++i) {
    const auto n = static_cast<float>(i + 1);
    EXPECT_EQ(images[static_cast<std::size_t>(i)].download<Colour>(),
              std::vector<Colour>(4, Colour{n, 2 * n, 3 * n, 4 * n}));
  }
  EXPECT_THROW(RasterPass(*device, shaders("Four", std::vector<Format>(99, Format::rgba32f))),
               EnvironmentError);
}

TEST_F(GpuTargets, HoldIntegers) {
  RasterPass pass(*device, shaders("Integers", {Format::rgba32ui}));
  const Image image(*device, Format::rgba32ui, 2, 2);
  pass.draw({{&image}}, {tile(2, 1)});
  using Integers = std::array<std::uint32_t, 4>;
  EXPECT_EQ(image.download<Integers>(),
            (std::vector<Integers>{{0, 0, 4'000'000'000U, 1}, {1, 0, 4'000'000'000U, 1}, {}, {}}));
}

TEST_F(GpuTargets, HoldFractionsAndHalves) {
  const auto drawn = [&](Format format, Colour colour) {
    RasterPass pass(*device, shaders("Plain", {format}));
    const Image image(*device, format, 1, 1);
    pass.draw({{&image}}, {tile(1, 1, colour)});
    return image.download<std::byte>();
  };
  const auto bytes = [](std::initializer_list<int> values) {
    std::vector<std::byte> all;
    for (const int value : values) all.push_back(static_cast<std::byte>(value));
    return all;
  };
  EXPECT_EQ(drawn(Format::rgba8, {0, 1, 2, 0.2F}), bytes({0, 255, 255, 51}));
  EXPECT_EQ(drawn(Format::r8, {1, 0, 0, 0}), bytes({255}));
  EXPECT_EQ(drawn(Format::rg16, {1, 0.2F, 0, 0}), bytes({255, 255, 0x33, 0x33}));
  EXPECT_EQ(drawn(Format::rg16f, {1, -2, 0, 0}), bytes({0, 0x3C, 0, 0xC0}));
}

TEST_F(GpuTargets, AreOneMipLevelOfOneLayer) {
  const ImageShape shape{.format = Format::rgba32f, .width = 4, .height = 2, .layers = 2, .mips = 2};
  Image image(*device, shape);
  for (int layer = 0; layer < 2; ++layer)
    for (int mip = 0; mip < 2; ++mip)
      image.upload(std::vector<Colour>(image.size_bytes(mip) / sizeof(Colour), Colour{9, 9, 9, 9}),
                   {mip, layer});
  RasterPass pass(*device, shaders("Plain", {Format::rgba32f}));
  pass.draw({{RasterTarget(&image, 1, 1)}}, {tile(2, 1)});
  EXPECT_EQ(image.download<Colour>({1, 1}), std::vector<Colour>(2, Colour{1, 2, 3, 4}));
  EXPECT_EQ(image.download<Colour>({1, 0}), std::vector<Colour>(2, Colour{9, 9, 9, 9}));
  EXPECT_EQ(image.download<Colour>({0, 1}), std::vector<Colour>(8, Colour{9, 9, 9, 9}));
  EXPECT_THROW(pass.draw({{RasterTarget(&image, 1, 1)}}, {tile(4, 2)}), std::invalid_argument);
  EXPECT_THROW(pass.draw({{RasterTarget(&image, 2, 0)}}, {tile(1, 1)}), std::invalid_argument);
}

// The diagonal covers some samples of the pixels that it crosses, and the mean of a pixel is their share.
TEST_F(GpuTargets, WithSeveralSamplesAreResolved) {
  const int samples = device->uses(Format::r32f).most_samples;
  ASSERT_GE(samples, 4);
  RasterShaders made = shaders("Plain", {Format::r32f}, "BelowDiagonal");
  made.samples = 4;
  made.resolve = true;
  RasterPass pass(*device, made);
  const Image drawn(*device, ImageShape{.format = Format::r32f, .width = 2, .height = 2, .samples = 4});
  const Image resolved(*device, Format::r32f, 2, 2);
  RasterTargets targets;
  targets.colours = {&drawn};
  targets.resolves = {&resolved};
  targets.clear_colours = {Colour{8, 0, 0, 0}};
  pass.draw(targets, {tile(2, 2, {4, 0, 0, 0})});
  const std::vector<float> means = resolved.download<float>();
  EXPECT_EQ(means[0], 4.0F) << "all samples";
  EXPECT_EQ(means[3], 8.0F) << "none";
  for (const std::size_t crossed : {1U, 2U}) {
    EXPECT_GT(means[crossed], 4.0F);
    EXPECT_LT(means[crossed], 8.0F);
    EXPECT_EQ(means[crossed], std::round(means[crossed])) << "a whole number of four samples";
  }
  EXPECT_THROW(pass.draw({{&resolved}}, {tile(2, 2)}), std::logic_error);
}

TEST_F(GpuTargets, AreShadedForEachSampleAndReadSampleBySample) {
  RasterShaders made = shaders("SampleNumber", {Format::r32f});
  made.samples = 4;
  made.shade_each_sample = true;
  RasterPass pass(*device, made);
  const Image drawn(*device, ImageShape{.format = Format::r32f, .width = 1, .height = 1, .samples = 4});
  RasterTile whole = tile(1, 1);
  whole.push_constants.clear();
  pass.draw({{&drawn}}, {whole});
  ComputePass read(*device, {.spirv = compile_test_shader("Samples.hlsl", "OfPixel"), .entry = "OfPixel"});
  const Buffer result(*device, 4 * sizeof(float));
  read.bindings().image("_Samples", drawn);
  read.bindings().buffer("_Result", result);
  read.dispatch({4, 1, 1});
  EXPECT_EQ(result.download<float>(), (std::vector<float>{0, 1, 2, 3}));
  EXPECT_THROW(read.bindings().image("_Samples", Image(*device, Format::r32f, 1, 1)), std::logic_error);
}

TEST_F(GpuTargets, BlendAndKeepWhatTheyHold) {
  const Colour before{0.25F, 0.5F, 1, 0.5F};
  const Colour colour{0.5F, 0.25F, 0.5F, 0.25F};
  const auto blended = [&](Blend blend) {
    RasterShaders made = shaders("Plain", {Format::rgba32f});
    made.blends = {blend};
    made.keep = true;
    RasterPass pass(*device, made);
    Image image(*device, Format::rgba32f, 1, 1);
    image.upload(std::vector<Colour>{before});
    pass.draw({{&image}}, {tile(1, 1, colour)});
    return image.download<Colour>().front();
  };
  EXPECT_EQ(blended(Blend::none), colour);
  EXPECT_EQ(blended(Blend::add), (Colour{0.75F, 0.75F, 1.5F, 0.75F}));
  EXPECT_EQ(blended(Blend::smallest), (Colour{0.25F, 0.25F, 0.5F, 0.25F}));
  EXPECT_EQ(blended(Blend::largest), (Colour{0.5F, 0.5F, 1, 0.5F}));
  EXPECT_EQ(blended(Blend::alpha), (Colour{0.3125F, 0.4375F, 0.875F, 0.4375F}));
}

// Both stages have a texture at binding 0 of set 0.
TEST_F(GpuTargets, BothStagesReadTexturesOfTheirOwn) {
  RasterPass pass(*device, shaders("OfTexture", {Format::rgba32f}, "FromTexture"));
  Image corners(*device, Format::rgba32f, 3, 1);
  corners.upload(std::vector<Colour>{{-1, -1, 0, 1}, {3, -1, 0, 1}, {-1, 3, 0, 1}});
  Image colours(*device, Format::rgba32f, 1, 1);
  colours.upload(std::vector<Colour>{{5, 6, 7, 8}});
  pass.bindings().image("_Vertices", corners);
  pass.bindings().image("_Colours", colours);
  const Image image(*device, Format::rgba32f, 1, 1);
  RasterTile whole = tile(1, 1);
  whole.push_constants.clear();
  pass.draw({{&image}}, {whole});
  EXPECT_EQ(image.download<Colour>().front(), (Colour{5, 6, 7, 8}));
}

TEST_F(GpuTargets, RefuseWhatNoPassHas) {
  RasterShaders made = shaders("Plain", {Format::rgba32f});
  made.resolve = true;
  EXPECT_THROW(RasterPass(*device, made), std::invalid_argument) << "one sample";
  made.resolve = false;
  made.blends = {Blend::none, Blend::add};
  EXPECT_THROW(RasterPass(*device, made), std::invalid_argument) << "two blends, one colour";
  EXPECT_THROW(RasterPass(*device, shaders("Plain", {Format::depth32})), EnvironmentError);
}

}  // namespace
}  // namespace penumbra::gpu
