#include "lighting/lit_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "input/input_error.h"
#include "lighting/hand_made.h"
#include "lighting/tone_curve.h"
#include "reference/scratch_folder.h"

namespace penumbra::lighting {
namespace {

const glm::dvec3 kToSun = glm::normalize(glm::dvec3(0.4, 1.0, 0.3));

scene::Scene table() {
  scene::Scene scene = hand_made::looking_down(10.0, kToSun);
  scene.materials[0].base_colour = {0.5F, 0.4F, 0.3F};
  hand_made::add_square(scene, {0, 0, 0}, {3, 0, 0}, {0, 0, 3});
  scene.materials.push_back({.name = "leaf", .base_colour = {0.1F, 0.4F, 0.1F}, .translucency = 0.5F});
  hand_made::add_square(scene, {1, 1, 0}, {1, 0, 0}, {0, 0.3, 0.6}, 1);
  return scene;
}

class LitFrames : public testing::Test {
 protected:
  LitFrame lit(const scene::Frame& frame, int supersampling) const {
    LitSettings settings;
    settings.supersampling = supersampling;
    settings.sky_rays = 64;
    settings.sun_rays = 64;
    settings.cache = folder_.path();
    return LitFrame(scene_, frame, settings, [](auto&&...) {});
  }

  const scene::Scene scene_ = table();
  const reference::ScratchFolder folder_;
};

TEST_F(LitFrames, ShadowsDarkenReceiversAndNothingElse) {
  const scene::Frame frame = hand_made::frame_of(scene_, 32, 32);
  const LitFrame picture = lit(frame, 1);
  const std::vector<glm::vec3> bright = picture.picture(std::vector<float>(1024, 1.0F));
  const std::vector<glm::vec3> half = picture.picture(std::vector<float>(1024, 0.5F));
  const std::vector<glm::vec3> dark = picture.picture(std::vector<float>(1024, 0.0F));
  int darkened = 0;
  for (std::size_t i = 0; i < bright.size(); ++i) {
    if (frame.receivers.triangle[i] == scene::no_triangle) {
      EXPECT_EQ(bright[i], dark[i]);
      continue;
    }
    EXPECT_GT(bright[i].r, half[i].r);
    EXPECT_GT(half[i].r, dark[i].r);
    EXPECT_GT(dark[i].r, 0.0F) << "the sky is there";
    ++darkened;
  }
  EXPECT_GT(darkened, 200);
}

TEST_F(LitFrames, SupersamplingIsTheMeanOfTheSamplesInLinearLight) {
  const scene::Frame frame = hand_made::frame_of(scene_, 24, 24);
  std::vector<float> visibility(576);
  for (std::size_t i = 0; i < visibility.size(); ++i) visibility[i] = float(i % 7) / 6.0F;
  // The sky's rays are fewer per sample than per pixel: twice as many make them as many.
  LitSettings settings;
  settings.cache = folder_.path();
  settings.sun_rays = 64;
  settings.sky_rays = 16;
  settings.supersampling = 1;
  const std::vector<glm::vec3> samples =
      LitFrame(scene_, frame, settings, [](auto&&...) {}).picture(visibility);
  settings.sky_rays = 64;
  settings.supersampling = 2;
  const LitFrame halved(scene_, frame, settings, [](auto&&...) {});
  ASSERT_EQ(halved.width(), 12);
  const std::vector<glm::vec3> mean = halved.picture(visibility);
  for (std::size_t y = 0; y < 12; ++y) {
    for (std::size_t x = 0; x < 12; ++x) {
      float sum = 0.0F;
      for (const std::size_t k : {2 * y * 24 + 2 * x, 2 * y * 24 + 2 * x + 1, (2 * y + 1) * 24 + 2 * x,
                                  (2 * y + 1) * 24 + 2 * x + 1}) {
        sum += srgb_decoded(samples[k].g);
      }
      ASSERT_NEAR(mean[y * 12 + x].g, srgb_encoded(sum / 4.0F), 2e-5F) << x << ", " << y;
    }
  }
}

TEST_F(LitFrames, AreTheSameTwiceAndFiniteForAnyAnswer) {
  const scene::Frame frame = hand_made::frame_of(scene_, 16, 16);
  std::vector<float> visibility(256, 0.7F);
  visibility[100] = std::nanf("");
  visibility[101] = HUGE_VALF;
  visibility[102] = -3.0F;
  const std::vector<glm::vec3> first = lit(frame, 1).picture(visibility);
  EXPECT_EQ(first, lit(frame, 1).picture(visibility));
  for (const glm::vec3& colour : first) {
    for (int channel = 0; channel < 3; ++channel)
      ASSERT_TRUE(colour[channel] >= 0.0F && colour[channel] <= 1.0F);
  }
}

TEST_F(LitFrames, ExposureOfOneStopDoublesTheLight) {
  const scene::Frame frame = hand_made::frame_of(scene_, 8, 8);
  LitSettings settings;
  settings.cache = folder_.path();
  settings.supersampling = 1;
  settings.sun_rays = 64;
  const std::vector<float> open(64, 1.0F);
  settings.exposure_stops = -1.0;
  const glm::vec3 darker = LitFrame(scene_, frame, settings, [](auto&&...) {}).picture(open)[27];
  settings.exposure_stops = 0.0;
  const glm::vec3 brighter = LitFrame(scene_, frame, settings, [](auto&&...) {}).picture(open)[27];
  ASSERT_GT(srgb_decoded(darker.b), 0.22F) << "where the tone curve is straight";
  ASSERT_LT(srgb_decoded(brighter.b), 0.53F) << "where the tone curve is straight";
  EXPECT_NEAR(srgb_decoded(brighter.b), 2.0F * srgb_decoded(darker.b), 1e-4F);
}

TEST_F(LitFrames, WhatDoesNotFitIsRefused) {
  const scene::Frame frame = hand_made::frame_of(scene_, 9, 9);
  EXPECT_THROW(lit(frame, 2), InputError);
  EXPECT_THROW(lit(frame, 0), InputError);
  EXPECT_THROW(lit(frame, 1).picture(std::vector<float>(80)), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::lighting
