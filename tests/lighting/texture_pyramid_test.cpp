#include "lighting/texture_pyramid.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "input/input_error.h"
#include "lighting/tone_curve.h"

namespace penumbra::lighting {
namespace {

scene::Texture texture(int width, int height, const std::vector<int>& greys) {
  scene::Texture result{width, height, {}};
  for (const int grey : greys) {
    for (const int sample : {grey, grey, grey, 255}) result.rgba.push_back(static_cast<std::uint8_t>(sample));
  }
  return result;
}

TEST(TexturePyramid, ReadsATexelAtItsCentreInLinearLight) {
  const TexturePyramid pyramid(texture(2, 2, {0, 50, 100, 255}), TexelMeaning::srgb_colour);
  EXPECT_FLOAT_EQ(pyramid.read({0.25F, 0.25F}, 0.0F).r, 0.0F);
  EXPECT_FLOAT_EQ(pyramid.read({0.75F, 0.25F}, 0.0F).r, srgb_decoded(50.0F / 255.0F));
  EXPECT_FLOAT_EQ(pyramid.read({0.25F, 0.75F}, 0.0F).g, srgb_decoded(100.0F / 255.0F));
  EXPECT_FLOAT_EQ(pyramid.read({-0.25F, 1.75F}, 0.0F).b, 1.0F) << "coordinates repeat";
}

TEST(TexturePyramid, AFootprintOfTheWholeTextureReadsItsMean) {
  const TexturePyramid pyramid(texture(4, 2, {0, 255, 0, 255, 255, 0, 255, 0}), TexelMeaning::srgb_colour);
  EXPECT_NEAR(pyramid.mean().r, 0.5F, 1e-6F);
  EXPECT_NEAR(pyramid.read({0.1F, 0.6F}, 4.0F).r, 0.5F, 1e-6F);
  EXPECT_NEAR(pyramid.read({0.125F, 0.25F}, 0.0F).r, 0.0F, 1e-6F);
}

TEST(TexturePyramid, VectorsAreFromMinusOneToOne) {
  const TexturePyramid pyramid(texture(1, 1, {255}), TexelMeaning::vector);
  EXPECT_FLOAT_EQ(pyramid.read({0.5F, 0.5F}, 0.0F).x, 1.0F);
  EXPECT_FLOAT_EQ(TexturePyramid(texture(1, 1, {0}), TexelMeaning::vector).mean().y, -1.0F);
}

TEST(TexturePyramid, TexelsThatAreMissingAreRefused) {
  scene::Texture broken = texture(2, 1, {0, 0});
  broken.rgba.pop_back();
  EXPECT_THROW(TexturePyramid(broken, TexelMeaning::vector), InputError);
  EXPECT_THROW(TexturePyramid(scene::Texture{}, TexelMeaning::vector), InputError);
}

}  // namespace
}  // namespace penumbra::lighting
