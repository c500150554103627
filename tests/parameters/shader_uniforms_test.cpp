// Tests uniforms from settings: tangents by hand, HDRP's vectors from the projection instead of the shadow
// matrix.
#include "parameters/shader_uniforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "parameters/random_setup.h"

namespace penumbra::parameters {
namespace {

double tan_half(double degrees) {
  return std::tan(degrees * std::numbers::pi / 360.0);
}

TEST(TanHalf, IsTheSchoolbooks) {
  EXPECT_DOUBLE_EQ(tan_half_of(30.0), 2.0 - std::sqrt(3.0));
  EXPECT_EQ(tan_half_of(0.0), 0.0);
  EXPECT_EQ(tan_half_of(-1.0), 0.0);
  EXPECT_EQ(tan_half_of(std::nan("")), 0.0);
  EXPECT_EQ(tan_half_of(90.0), tan_half_of(30.0));
  EXPECT_DOUBLE_EQ(degrees_of(2.0 - std::sqrt(3.0)), 30.0);
  EXPECT_DOUBLE_EQ(degrees_of(1.0), 90.0);
}

TEST(ShaderUniforms, StandWhereTheShaderReadsThem) {
  const SoftShadowParameters parameters{.angular_diameter_degrees = 2,
                                        .blocker_samples = 11,
                                        .filter_samples = 12,
                                        .blocker_clump = 1.5,
                                        .min_filter_texels = 1.75,
                                        .max_penumbra_metres = 21,
                                        .max_sampling_metres = 22,
                                        .search_radius_metres = 23,
                                        .hdrp_search_degrees = 5,
                                        .hdrp_min_filter_degrees = 7};
  const ShaderUniforms packed = shader_uniforms(parameters, atlas_layout(2048, 2), 2, 73);
  EXPECT_EQ(packed.atlas_texel_size, glm::dvec4(1.0 / 2048, 1.0 / 1024, 2048, 1024));
  EXPECT_EQ(packed.main_light_params.x, 2);
  EXPECT_DOUBLE_EQ(packed.main_light_params.y, tan_half(2));
  EXPECT_EQ(packed.main_light_params.z, 73 - 64);
  EXPECT_DOUBLE_EQ(packed.hdrp_tan_half.x, tan_half(5));
  EXPECT_DOUBLE_EQ(packed.hdrp_tan_half.y, tan_half(7));
}

TEST(ShaderUniforms, AConeIsNeverNarrowerThanTheOneInside) {
  SoftShadowParameters parameters;
  parameters.angular_diameter_degrees = 20;
  const ShaderUniforms packed = shader_uniforms(parameters, atlas_layout(2048, 1), 1, 0);
  EXPECT_EQ(packed.hdrp_tan_half.x, packed.main_light_params.y);
  EXPECT_EQ(packed.hdrp_tan_half.y, packed.main_light_params.y);
}

TEST(ShaderUniforms, NotANumberCountsAsTheLowEnd) {
  const double nan = std::nan("");
  const SoftShadowParameters parameters{.angular_diameter_degrees = nan,
                                        .blocker_clump = nan,
                                        .min_filter_texels = nan,
                                        .max_penumbra_metres = nan,
                                        .max_sampling_metres = nan,
                                        .search_radius_metres = nan,
                                        .hdrp_search_degrees = nan,
                                        .hdrp_min_filter_degrees = nan};
  const ShaderUniforms packed = shader_uniforms(parameters, atlas_layout(2048, 1), 1, -1);
  EXPECT_EQ(packed.main_light_params, glm::dvec4(1, 0, 63, 0));
  EXPECT_EQ(packed.hdrp_tan_half, glm::dvec2(0));
}

TEST(HdrpVectors, FollowFromTheDeviceProjection) {
  SetupGenerator generator(41);
  for (int i = 0; i < 100; ++i) {
    ShadowSetup setup = generator.next();
    setup.shadows.clip_depth = ClipDepth::zero_to_one;
    SoftShadowParameters parameters;
    parameters.angular_diameter_degrees = setup.light.angular_diameter_degrees;
    for (const Cascade& cascade : setup.fit().cascades) {
      const double scale = std::abs(cascade.projection[0][0] / cascade.projection[2][2]);
      const double light = tan_half(parameters.angular_diameter_degrees);
      const double search = std::max(light, tan_half(12));
      const HdrpVectors vectors = hdrp_vectors(cascade, parameters);
      EXPECT_NEAR(vectors.params0.x / (light * scale), 1.0, 1e-12);
      EXPECT_NEAR(vectors.params0.y * (light * scale), 1.0, 1e-12);
      EXPECT_NEAR(vectors.params0.z * (2.0 * light), parameters.max_penumbra_metres, 1e-9);
      EXPECT_NEAR(vectors.params1.y * (search * scale), 1.0, 1e-12);
      EXPECT_NEAR(vectors.params1.z * (search * scale), 1.0, 1e-12);
    }
  }
}

TEST(HdrpVectors, OfAPointLightReachOverTheDepthRange) {
  ShadowSetup setup;
  setup.shadows.depth_range_metres = 80;
  SoftShadowParameters parameters;
  parameters.angular_diameter_degrees = 0;
  const HdrpVectors vectors = hdrp_vectors(setup.fit().cascades.front(), parameters);
  EXPECT_EQ(vectors.params0.x, 0.0);
  EXPECT_EQ(vectors.params0.y, 0.0);
  EXPECT_DOUBLE_EQ(vectors.params0.z, 80.0);
}

TEST(BiasOfProjection, AgreesWithTheShadowMatrix) {
  SetupGenerator generator(42);
  for (int i = 0; i < 100; ++i) {
    const ShadowSetup setup = generator.next();
    const CascadeSet set = setup.fit();
    for (const Cascade& cascade : set.cascades) {
      const glm::dvec2 bias = bias_of_projection(cascade.projection, set.tile_resolution, setup.shadows);
      EXPECT_NEAR(bias.x / cascade.depth_bias_metres, 1.0, 1e-12);
      EXPECT_NEAR(bias.y / cascade.normal_bias_metres, 1.0, 1e-12);
    }
  }
}

}  // namespace
}  // namespace penumbra::parameters
