#include "gpu/raster_pass.h"

#include <array>
#include <cstring>

#include "gpu/gpu_test.h"
#include "input/input_error.h"

namespace penumbra::gpu {
namespace {

using Corner = std::array<float, 4>;  // clip space
using Colour = std::array<float, 4>;

// Two triangles that cover the whole of clip space at one depth.
std::vector<Corner> sheet(float depth) {
  return {{-1, -1, depth, 1}, {1, -1, depth, 1}, {-1, 1, depth, 1},
          {1, -1, depth, 1},  {1, 1, depth, 1},  {-1, 1, depth, 1}};
}

RasterTile tile_at(int x, int y, int size, std::size_t corners, Colour colour = {1, 2, 3, 4}) {
  RasterTile tile{x, y, size, size, static_cast<std::uint32_t>(corners), {}};
  tile.push_constants.resize(sizeof(colour));
  std::memcpy(tile.push_constants.data(), &colour, sizeof(colour));
  return tile;
}

class GpuRaster : public Gpu {
 protected:
  RasterShaders shaders(std::optional<Format> depth, bool colours) const {
    RasterShaders made;
    made.vertex = compile_test_shader("Triangle.hlsl", "Vertex", hlsl::Stage::vertex);
    made.vertex_entry = "Vertex";
    if (colours) {
      made.fragment = compile_test_shader("Triangle.hlsl", "Fragment", hlsl::Stage::fragment);
      made.fragment_entry = "Fragment";
      made.colours = {Format::rgba32f, Format::r32f};
    }
    made.depth = depth;
    return made;
  }
  RasterPass pass_of(const RasterShaders& made, const std::vector<Corner>& corners) {
    RasterPass pass(*device, made);
    const Buffer buffer(*device, std::span<const Corner>(corners));
    pass.bindings().buffer("_Corners", buffer);
    return pass;
  }
};

// Clip (-1, -1) is the first texel of row 0: the picture is not upside down.
//   row 0   A A .      A triangle over the corner, edges clear of texel centres.
//   row 1   A . .
//   row 2   . . .
TEST_F(GpuRaster, PutsClipYMinusOneInRowZero) {
  const std::vector<Corner> corner{{-1, -1, 0.5F, 1}, {0.6F, -1, 0.5F, 1}, {-1, 0.6F, 0.5F, 1}};
  RasterPass pass = pass_of(shaders(std::nullopt, true), corner);
  const Image colour(*device, Format::rgba32f, 3, 3);
  const Image depth_seen(*device, Format::r32f, 3, 3);
  EXPECT_GT(pass.draw({{&colour, &depth_seen}}, {tile_at(0, 0, 3, 3)}), 0.0);
  const Colour in{1, 2, 3, 4};
  const Colour out{0, 0, 0, 0};
  EXPECT_EQ(colour.download<Colour>(), (std::vector<Colour>{in, in, out, in, out, out, out, out, out}));
  EXPECT_EQ(depth_seen.download<float>(), (std::vector<float>{0.5F, 0.5F, 0, 0.5F, 0, 0, 0, 0, 0}));
}

TEST_F(GpuRaster, DrawsBothFaces) {
  std::vector<Corner> corners = sheet(0.5F);
  std::swap(corners[0], corners[1]);  // the first triangle faces away
  RasterPass pass = pass_of(shaders(Format::depth32, false), corners);
  const Image depth(*device, Format::depth32, 4, 4);
  pass.draw({{}, &depth, 1.0F}, {tile_at(0, 0, 4, 6)});
  EXPECT_EQ(depth.download<float>(), std::vector<float>(16, 0.5F));
}

// The tests tell which of the depths 1/4, 1/2 and 3/4 passes over a target that holds 1/2.
TEST_F(GpuRaster, EveryDepthTestKeepsWhatItsNameSays) {
  const std::vector<std::pair<DepthTest, std::array<bool, 3>>> passing{
      {DepthTest::less, {true, false, false}},      {DepthTest::greater, {false, false, true}},
      {DepthTest::less_equal, {true, true, false}}, {DepthTest::greater_equal, {false, true, true}},
      {DepthTest::equal, {false, true, false}},     {DepthTest::always, {true, true, true}}};
  for (const auto& [test, passes] : passing) {
    for (std::size_t i = 0; i < passes.size(); ++i) {
      RasterShaders made = shaders(Format::depth32, true);
      made.depth_test = test;
      RasterPass pass = pass_of(made, sheet(0.25F * static_cast<float>(i + 1)));
      const Image colour(*device, Format::rgba32f, 1, 1);
      const Image other(*device, Format::r32f, 1, 1);
      const Image depth(*device, Format::depth32, 1, 1);
      pass.draw({{&colour, &other}, &depth, 0.5F}, {tile_at(0, 0, 1, 6)});
      const Colour expected = passes[i] ? Colour{1, 2, 3, 4} : Colour{0, 0, 0, 0};
      EXPECT_EQ(colour.download<Colour>().front(), expected) << static_cast<int>(test) << ", " << i;
    }
  }
}

TEST_F(GpuRaster, KeepsTheNearerSurfaceInEitherDirection) {
  std::vector<Corner> corners = sheet(0.25F);
  for (const float other : {0.75F, 0.5F}) {
    for (const Corner& corner : sheet(other)) corners.push_back(corner);
  }
  const Image depth(*device, Format::depth32, 2, 2);
  RasterShaders conventional = shaders(Format::depth32, false);
  conventional.depth_test = DepthTest::less;
  pass_of(conventional, corners).draw({{}, &depth, 1.0F}, {tile_at(0, 0, 2, corners.size())});
  EXPECT_EQ(depth.download<float>(), std::vector<float>(4, 0.25F));
  RasterShaders reversed = conventional;
  reversed.depth_test = DepthTest::greater;
  pass_of(reversed, corners).draw({{}, &depth, 0.0F}, {tile_at(0, 0, 2, corners.size())});
  EXPECT_EQ(depth.download<float>(), std::vector<float>(4, 0.75F));
}

// The sheet has twice the tile's size in clip space, so that only the scissor keeps it in.
TEST_F(GpuRaster, DrawsNothingOutsideItsTile) {
  std::vector<Corner> corners = sheet(0.5F);
  for (Corner& corner : corners) {
    corner[0] *= 2.0F;
    corner[1] *= 2.0F;
  }
  RasterPass pass = pass_of(shaders(Format::depth32, false), corners);
  const Image depth(*device, Format::depth32, 6, 6);
  pass.draw({{}, &depth, 1.0F}, {tile_at(1, 2, 3, corners.size())});
  const std::vector<float> drawn = depth.download<float>();
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 6; ++x) {
      const bool inside = x >= 1 && x < 4 && y >= 2 && y < 5;
      EXPECT_EQ(drawn[static_cast<std::size_t>(6 * y + x)], inside ? 0.5F : 1.0F) << x << ", " << y;
    }
  }
}

TEST_F(GpuRaster, EachTileReadsItsOwnPushConstants) {
  RasterPass pass = pass_of(shaders(Format::depth16, true), sheet(0.2F));  // depth is 13107 / 65535
  const Image colour(*device, Format::rgba32f, 2, 1);
  const Image second(*device, Format::r32f, 2, 1);
  const Image depth(*device, Format::depth16, 2, 1);
  const Colour left{1, 0, 0, 0};
  const Colour right{0, 5, 0, 0};
  pass.draw({{&colour, &second}, &depth, 1.0F}, {tile_at(0, 0, 1, 6, left), tile_at(1, 0, 1, 6, right)});
  EXPECT_EQ(colour.download<Colour>(), (std::vector<Colour>{left, right}));
  EXPECT_EQ(depth.download<std::uint16_t>(), (std::vector<std::uint16_t>{13107, 13107}));
}

TEST_F(GpuRaster, ClampsToTheDepthRangeWhenAskedAndClipsOtherwise) {
  const Image depth(*device, Format::depth32, 2, 2);
  RasterShaders made = shaders(Format::depth32, false);
  made.depth_test = DepthTest::less;
  pass_of(made, sheet(-0.5F)).draw({{}, &depth, 1.0F}, {tile_at(0, 0, 2, 6)});
  EXPECT_EQ(depth.download<float>(), std::vector<float>(4, 1.0F)) << "clipped";
  made.depth_clamp = true;
  pass_of(made, sheet(-0.5F)).draw({{}, &depth, 1.0F}, {tile_at(0, 0, 2, 6)});
  EXPECT_EQ(depth.download<float>(), std::vector<float>(4, 0.0F)) << "clamped";
}

class GpuStencil : public GpuRaster {
 protected:
  // Begins with depth 1/2 and this stencil.
  void begin(std::uint8_t stencil) {
    RasterShaders made = shaders(Format::depth32s8, false);
    made.stencil.emplace().reference = stencil;
    made.stencil->front.pass = StencilOperation::replace;
    pass_of(made, sheet(0.5F)).draw({{}, &*image_, 1.0F}, {tile_at(0, 0, 2, 6)});
  }
  // Draws a sheet at that depth, which is seen where it is nearer.
  void draw(const StencilState& state, float depth, bool turned = false) {
    std::vector<Corner> corners = sheet(depth);
    if (turned)
      for (std::size_t at = 0; at < corners.size(); at += 3) std::swap(corners[at], corners[at + 1]);
    RasterShaders made = shaders(Format::depth32s8, false);
    made.depth_write = false;
    made.keep = true;
    made.stencil = state;
    pass_of(made, corners).draw({{}, &*image_, 1.0F}, {tile_at(0, 0, 2, 6)});
  }
  // Whether a stencil test of that reference leaves every texel, or none.
  bool passes(StencilTest test, std::uint8_t reference, std::uint8_t read_mask = 255) {
    RasterShaders made = shaders(Format::depth32s8, true);
    made.depth_test = DepthTest::always;
    made.depth_write = false;
    made.keep_depth = true;
    made.stencil.emplace().reference = reference;
    made.stencil->read_mask = read_mask;
    made.stencil->front.test = test;
    const Image colour(*device, Format::rgba32f, 2, 2), other(*device, Format::r32f, 2, 2);
    pass_of(made, sheet(0.75F)).draw({{&colour, &other}, &*image_, 0.0F}, {tile_at(0, 0, 2, 6)});
    const std::vector<float> drawn = other.download<float>();
    EXPECT_EQ(drawn, std::vector<float>(4, drawn.front()));
    EXPECT_EQ(image_->download<float>(), std::vector<float>(4, 0.5F)) << "the depth is kept";
    return drawn.front() != 0.0F;
  }
  std::uint8_t stencil_after(std::uint8_t before, const StencilState& state, float depth,
                             bool turned = false) {
    begin(before);
    draw(state, depth, turned);
    for (int value = 0; value < 256; ++value)
      if (passes(StencilTest::equal, static_cast<std::uint8_t>(value)))
        return static_cast<std::uint8_t>(value);
    ADD_FAILURE() << "no value";
    return 0;
  }

  void SetUp() override {
    GpuRaster::SetUp();
    image_.emplace(*device, Format::depth32s8, 2, 2);
  }
  void TearDown() override {
    image_.reset();
    GpuRaster::TearDown();
  }
  std::optional<Image> image_;
};

// There are front faces before the depth and behind it, back faces, and fragments that fail the stencil test.
TEST_F(GpuStencil, EachFaceAndOutcomeHasItsOperation) {
  StencilState state;
  state.reference = 9;
  state.front = {StencilTest::always, StencilOperation::keep, StencilOperation::decrement_wrap,
                 StencilOperation::increment_wrap};
  state.back = {StencilTest::less, StencilOperation::invert, StencilOperation::increment,
                StencilOperation::zero};
  EXPECT_EQ(stencil_after(20, state, 0.25F), 21);
  EXPECT_EQ(stencil_after(255, state, 0.25F), 0);
  EXPECT_EQ(stencil_after(20, state, 0.75F), 19);
  EXPECT_EQ(stencil_after(0, state, 0.75F), 255);
  EXPECT_EQ(stencil_after(20, state, 0.25F, true), 0);
  EXPECT_EQ(stencil_after(20, state, 0.75F, true), 21);
  EXPECT_EQ(stencil_after(255, state, 0.75F, true), 255);
  EXPECT_EQ(stencil_after(9, state, 0.25F, true), 246) << "9 is not less than 9";
  state.write_mask = 0x0F;
  EXPECT_EQ(stencil_after(0xA5, state, 0.25F, true), 0xA0);
}

TEST_F(GpuStencil, EveryTestComparesTheReferenceWithTheStencil) {
  const std::vector<std::pair<StencilTest, std::array<bool, 3>>> passing{
      {StencilTest::never, {false, false, false}},       {StencilTest::less, {true, false, false}},
      {StencilTest::equal, {false, true, false}},        {StencilTest::less_equal, {true, true, false}},
      {StencilTest::greater, {false, false, true}},      {StencilTest::not_equal, {true, false, true}},
      {StencilTest::greater_equal, {false, true, true}}, {StencilTest::always, {true, true, true}}};
  begin(7);
  for (const auto& [test, expected] : passing)
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_EQ(passes(test, static_cast<std::uint8_t>(6 + i)), expected[i])
          << static_cast<int>(test) << ", " << 6 + i;
  EXPECT_TRUE(passes(StencilTest::equal, 0x17, 0x0F));
}

TEST_F(GpuStencil, IsClearedWithTheDepth) {
  begin(7);
  RasterShaders made = shaders(Format::depth32s8, false);
  pass_of(made, sheet(0.5F)).draw({{}, &*image_, 1.0F}, {tile_at(0, 0, 2, 6)});
  EXPECT_TRUE(passes(StencilTest::equal, 0));
  made = shaders(Format::depth32, false);
  made.stencil.emplace();
  EXPECT_THROW(RasterPass(*device, made), std::invalid_argument) << "no stencil there";
}

TEST_F(GpuRaster, RefusesTargetsAndTilesThatDoNotFit) {
  RasterPass pass = pass_of(shaders(Format::depth32, false), sheet(0.5F));
  const Image depth(*device, Format::depth32, 4, 4);
  const Image other(*device, Format::depth16, 4, 4);
  EXPECT_THROW(pass.draw({{}, &other, 1.0F}, {tile_at(0, 0, 4, 6)}), std::logic_error);
  EXPECT_THROW(pass.draw({{}, nullptr, 1.0F}, {tile_at(0, 0, 4, 6)}), std::logic_error);
  EXPECT_THROW(pass.draw({{}, &depth, 1.0F}, {tile_at(1, 0, 4, 6)}), std::invalid_argument);
  EXPECT_THROW(pass.draw({{}, &depth, 1.0F}, {tile_at(-1, 0, 2, 6)}), std::invalid_argument);
  EXPECT_THROW(RasterPass(*device, shaders(std::nullopt, false)), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::gpu
