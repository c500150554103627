#include "gpu/compute_pass.h"

#include <array>

#include "gpu/gpu_test.h"

namespace penumbra::gpu {
namespace {

using Texel = std::array<float, 4>;

class GpuCompute : public Gpu {
 protected:
  void SetUp() override {
    Gpu::SetUp();
    spirv = compile_test_shader("AddUniform.hlsl");
  }
  static Image blank(const Device& on) {
    Image image(on, Format::rgba32f, 2, 1);
    image.upload(std::vector<Texel>(2, Texel{}));
    return image;
  }

  std::vector<std::uint32_t> spirv;
};

TEST_F(GpuCompute, RepeatsAndTakesNewUniformsAndImagesWithoutANewPass) {
  Image first = blank(*device);
  Image second = blank(*device);
  ComputePass pass(*device, {.spirv = spirv});
  pass.bindings().image("_Image", first);
  pass.bindings().uniform("Step", Texel{1, 2, 3, 4});
  EXPECT_EQ(pass.dispatch({2, 1, 1}, 3).size(), 3U);
  EXPECT_EQ(first.download<Texel>(), std::vector<Texel>(2, Texel{3, 6, 9, 12}));

  pass.bindings().uniform("Step", Texel{10, 0, 0, 0});
  pass.dispatch({1, 1, 1});
  EXPECT_EQ(first.download<Texel>(), (std::vector<Texel>{{13, 6, 9, 12}, {3, 6, 9, 12}}));

  pass.bindings().image("_Image", second);
  pass.dispatch({2, 1, 1});
  EXPECT_EQ(second.download<Texel>(), std::vector<Texel>(2, Texel{10, 0, 0, 0}));
  EXPECT_EQ(first.download<Texel>()[0], (Texel{13, 6, 9, 12}));
}

TEST_F(GpuCompute, KeepsWhatIsBoundAlive) {
  ComputePass pass(*device, {.spirv = spirv});
  pass.bindings().image("_Image", blank(*device));
  pass.bindings().uniform("Step", Texel{});
  EXPECT_GT(pass.dispatch({2, 1, 1}).front(), 0.0);
}

TEST_F(GpuCompute, OutlivesItsDevice) {
  const Image image = blank(*device);
  ComputePass pass(*device, {.spirv = spirv});
  pass.bindings().image("_Image", image);
  pass.bindings().uniform("Step", Texel{1, 2, 3, 4});
  device.reset();
  pass.dispatch({2, 1, 1});
  EXPECT_EQ(image.download<Texel>(), std::vector<Texel>(2, Texel{1, 2, 3, 4}));
}

std::string complaint(ComputePass& pass) {
  try {
    pass.dispatch({1, 1, 1});
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return "no complaint";
}

TEST_F(GpuCompute, NamesWhatIsNotBoundOrBoundWrongly) {
  ComputePass pass(*device, {.spirv = spirv});
  const Image image = blank(*device);
  pass.bindings().image("_Image", image);
  EXPECT_THAT(complaint(pass), testing::HasSubstr("nothing is bound to 'Step'"));
  EXPECT_THROW(pass.bindings().uniform("Step", 1.0F), std::logic_error) << "4 bytes of 16";
  EXPECT_THROW(pass.bindings().image("Step", image), std::logic_error);
  EXPECT_THROW(pass.bindings().buffer("_Image", Buffer(*device, 4)), std::logic_error);
  EXPECT_THROW(pass.bindings().buffer("_Other", Buffer(*device, 4)), std::logic_error);
  EXPECT_TRUE(pass.bindings().has("_Image"));
  EXPECT_FALSE(pass.bindings().has("_Other"));
}

TEST_F(GpuCompute, RefusesEmptyAndMisplacedWork) {
  ComputePass pass(*device, {.spirv = spirv});
  const Image image = blank(*device);
  pass.bindings().image("_Image", image);
  pass.bindings().uniform("Step", Texel{});
  EXPECT_THROW(pass.dispatch({0, 1, 1}), std::invalid_argument);
  EXPECT_THROW(pass.dispatch({1, 1, 0xFFFF'FFFF}), std::invalid_argument);
  EXPECT_THROW(ComputePass(*device, {}), std::invalid_argument);
  pass.dispatch({1, 1, 1});
  const Image depth(*device, Format::depth32, 1, 1);
  EXPECT_THROW(pass.bindings().image("_Image", depth), std::logic_error);
  const Device other;
  EXPECT_THROW(pass.bindings().image("_Image", blank(other)), std::logic_error);
}

}  // namespace
}  // namespace penumbra::gpu
