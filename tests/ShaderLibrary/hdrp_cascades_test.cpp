// Compares Pipelines/Hdrp.hlsl on HDRP's shadow data of a fitted sun with the fit's own matrices: the
// cascade, the place in the atlas and the depth of a camera-relative position, the border between cascades,
// and what is outside.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <limits>
#include <optional>

#include "ShaderLibrary/hdrp_frame.h"
#include "ShaderLibrary/inputs.h"
#include "parameters/cascades.h"

namespace penumbra::shader_library_tests {
namespace {

constexpr float kDepthBias = 1.0f / 65536.0f;

struct Fitted {
  parameters::CascadeSet set;
  glm::dvec3 eye{0.0};
  HdrpFrame frame;
};

HdrpShadow shadow_of(const parameters::Cascade& cascade, const Fitted& fitted) {
  HdrpShadow shadow;
  for (int row = 0; row < 3; ++row) {
    const glm::dvec3 axis(cascade.view[0][row], cascade.view[1][row], cascade.view[2][row]);
    shadow.view[std::size_t(row)] =
        glm::vec4(glm::vec3(axis), cascade.view[3][row] + glm::dot(axis, fitted.eye));
  }
  const glm::dmat4& p = cascade.projection;
  shadow.projection = glm::vec4(p[0][0], p[1][1], p[2][2], p[3][2]);
  if (fitted.set.reversed_z) shadow.projection = {p[0][0], p[1][1], -p[2][2], 1.0 - p[3][2]};
  shadow.atlas_offset = glm::vec2(cascade.offset_scale.x, cascade.offset_scale.y);
  shadow.tile_texels = glm::vec2(static_cast<float>(fitted.set.tile_resolution));
  shadow.world_texel_size = static_cast<float>(cascade.texel_size_metres);
  return shadow;
}

// HDRP's buffers hold other lights' shadows before the sun's.
Fitted fit(int cascades, DepthDirection direction) {
  parameters::Camera camera;
  camera.position = {1200.0, 35.0, -4700.0};
  parameters::ShadowSettings settings;
  settings.cascades = cascades;
  settings.distance_metres = 80.0;
  settings.reversed_z = direction == DepthDirection::reversed;
  Fitted fitted{.set = parameters::fit_cascades(camera, {}, settings), .eye = camera.position, .frame = {}};
  fitted.frame.first_shadow = 2;
  fitted.frame.shadows.resize(2);
  for (const parameters::Cascade& cascade : fitted.set.cascades) {
    fitted.frame.shadows.push_back(shadow_of(cascade, fitted));
    const glm::dvec4& sphere = cascade.split_sphere;
    fitted.frame.spheres.emplace_back(glm::vec3(glm::dvec3(sphere) - fitted.eye), sphere.w * sphere.w);
  }
  fitted.frame.atlas_texels = glm::vec2(fitted.set.atlas_width, fitted.set.atlas_height);
  fitted.frame.forward = glm::vec3(fitted.set.light_direction);
  return fitted;
}

// The positions lie before the camera, from its near plane to beyond the last sphere, relative to it.
std::vector<float> positions(int count) {
  Random random(5);
  std::vector<float> values;
  for (int i = 0; i < count; ++i) {
    values.push_back(random.between(-60.0f, 60.0f));
    values.push_back(random.between(-30.0f, 30.0f));
    values.push_back(random.between(0.0f, 120.0f));
  }
  return values;
}

const HdrpFunction kPrepared{
    "const PenumbraHdrpLight light = PreparePenumbraHdrpLight(In3(0), float3(0, 0, 0), float2(0, 0)); Out(0, "
    "light.covered ? 1 : 0); Out3(1, light.receiver.shadowCoord.xyz); Out2(4, light.tile.offsetScale.xy); "
    "Out(6, light.strength);",
    3, 7};

// The first sphere that holds the position, or nothing. There is no answer within rounding of a sphere.
std::optional<int> cascade_of(const Fitted& fitted, const glm::dvec3& position, bool& near_a_sphere) {
  near_a_sphere = false;
  for (const parameters::Cascade& cascade : fitted.set.cascades) {
    const double ratio = glm::distance(position, glm::dvec3(cascade.split_sphere)) / cascade.split_sphere.w;
    near_a_sphere = near_a_sphere || std::fabs(ratio - 1.0) < 1e-5;
    if (ratio < 1.0) return cascade.index;
  }
  return std::nullopt;
}

void expect_places(const Fitted& fitted, HdrpVersion version, DepthDirection direction) {
  const std::vector<float> at = positions(4096);
  const std::vector<float> got = run(kPrepared, version, direction, fitted.frame, at);
  const double toward = direction == DepthDirection::reversed ? 1.0 : -1.0;
  std::vector<int> seen(fitted.set.cascades.size() + 1);
  for (std::size_t i = 0; i < at.size() / 3; ++i) {
    const glm::dvec3 position = fitted.eye + glm::dvec3(at[i * 3], at[i * 3 + 1], at[i * 3 + 2]);
    bool near_a_sphere = false;
    const std::optional<int> index = cascade_of(fitted, position, near_a_sphere);
    if (near_a_sphere) continue;
    const float* light = &got[i * 7];
    ++seen[index ? std::size_t(*index) : fitted.set.cascades.size()];
    ASSERT_EQ(light[0] != 0.0f, index.has_value()) << i;
    if (!index) continue;
    const parameters::Cascade& cascade = fitted.set.cascades[std::size_t(*index)];
    EXPECT_EQ(light[4], static_cast<float>(cascade.offset_scale.x)) << i;
    EXPECT_EQ(light[5], static_cast<float>(cascade.offset_scale.y)) << i;
    const glm::dvec4 exact = cascade.world_to_shadow * glm::dvec4(position, 1.0);
    EXPECT_NEAR(light[1], exact.x, 1e-6) << i;
    EXPECT_NEAR(light[2], exact.y, 1e-6) << i;
    EXPECT_NEAR(light[3], exact.z + toward * kDepthBias, 2e-6) << i;
    EXPECT_EQ(light[6], 1.0f) << i;
  }
  for (std::size_t kind = 0; kind < seen.size(); ++kind) EXPECT_GE(seen[kind], 3) << kind;
}

TEST(HdrpCascades, CameraRelativePositionsLandWhereTheFitPutsThem) {
  for (const HdrpVersion version : kHdrpVersions) {
    for (const DepthDirection direction : kDepthDirections) {
      for (const int cascades : {1, 2, 3, 4}) expect_places(fit(cascades, direction), version, direction);
    }
  }
}

TEST(HdrpCascades, PositionsThatAreNoNumbersAreOutside) {
  const float infinity = std::numeric_limits<float>::infinity();
  const Fitted fitted = fit(4, DepthDirection::reversed);
  const std::vector<float> got = run(kPrepared, HdrpVersion::v14, DepthDirection::reversed, fitted.frame,
                                     {NAN, 0.0f, 5.0f, infinity, 0.0f, 5.0f, 0.0f, -infinity, NAN});
  for (const int i : {0, 1, 2}) EXPECT_EQ(got[std::size_t(i) * 7], 0.0f) << i;
}

TEST(HdrpCascades, WithoutAShadowedSunNothingIsCovered) {
  for (const bool no_light : {true, false}) {
    Fitted fitted = fit(4, DepthDirection::reversed);
    // The sun's shadows come first, where a read out of bounds would find them.
    fitted.frame.shadows.erase(fitted.frame.shadows.begin(), fitted.frame.shadows.begin() + 2);
    (no_light ? fitted.frame.shadow_index : fitted.frame.first_shadow) = -1;
    const std::vector<float> got =
        run(kPrepared, HdrpVersion::v14, DepthDirection::reversed, fitted.frame, {0.0f, 0.0f, 5.0f});
    EXPECT_EQ(got[0], 0.0f);
  }
}

// HDRP did not draw this cascade in this frame: its squared radius is minus infinity.
TEST(HdrpCascades, ASphereOfNoSizeHoldsNothing) {
  Fitted fitted = fit(2, DepthDirection::reversed);
  fitted.frame.spheres[0].w = -std::numeric_limits<float>::infinity();
  const std::vector<float> got =
      run(kPrepared, HdrpVersion::v14, DepthDirection::reversed, fitted.frame, {0.0f, 0.0f, 2.0f});
  EXPECT_EQ(got[0], 1.0f);
  EXPECT_EQ(got[4], 0.5f);
}

// One sphere of radius 4 lies around (0, 0, 10), with a border of a quarter of its squared radius; the camera
// looks from the origin.
HdrpFrame bordered(std::size_t cascades) {
  HdrpFrame frame;
  for (std::size_t i = 0; i < cascades; ++i) {
    HdrpShadow shadow;
    shadow.view = {glm::vec4(1, 0, 0, 0), glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, 1, 0)};
    shadow.projection = glm::vec4(0.1f);
    shadow.atlas_offset = glm::vec2(0.5f * static_cast<float>(i), 0.0f);
    shadow.tile_texels = glm::vec2(512.0f);
    frame.shadows.push_back(shadow);
    frame.spheres.emplace_back(0.0f, 0.0f, 10.0f, 16.0f * static_cast<float>(i + 1));
    frame.borders.push_back(0.25f);
  }
  frame.atlas_texels = glm::vec2(1024.0f, 512.0f);
  return frame;
}

TEST(HdrpCascades, TheLastCascadeFadesOutAcrossItsBorderAwayFromTheCamera) {
  HdrpFrame frame = bordered(1);
  frame.dimmer = 0.5f;
  const float middle = std::sqrt(16.0f * 0.875f);  // half into the border
  const std::vector<float> got = run(kPrepared, HdrpVersion::v14, DepthDirection::reversed, frame,
                                     {0.0f, 0.0f, 10.0f + 3.0f, 0.0f, 0.0f, 10.0f + middle, 0.0f, 0.0f,
                                      10.0f + 3.9999f, 0.0f, 0.0f, 10.0f - middle});
  for (const std::size_t i : {0u, 1u, 2u, 3u}) EXPECT_EQ(got[i * 7], 1.0f) << "no cascade follows the last";
  EXPECT_EQ(got[6], 0.5f) << "before the border";
  EXPECT_NEAR(got[13], 0.25f, 1e-5f) << "half into it";
  EXPECT_NEAR(got[20], 0.0f, 1e-3f) << "at its end";
  EXPECT_EQ(got[27], 0.5f) << "on the camera's side";
}

TEST(HdrpCascades, NoiseGivesTheNextCascadeItsShareOfTheBorder) {
  const HdrpFunction chosen{
      "const PenumbraHdrpLight light = PreparePenumbraHdrpLight(float3(0, 0, In(0)), float3(0, 0, 0), "
      "In2(1)); Out(0, light.tile.offsetScale.x > 0.25 ? 1 : 0); Out(1, light.strength);",
      3, 2};
  for (const float share : {0.0f, 0.25f, 0.5f, 0.75f}) {
    std::vector<float> inputs;
    for (int pixel = 0; pixel < 4096; ++pixel) {
      inputs.push_back(10.0f + std::sqrt(16.0f * (0.75f + 0.25f * share)));
      inputs.push_back(static_cast<float>(pixel % 64));
      inputs.push_back(std::floor(static_cast<float>(pixel) / 64.0f));
    }
    const std::vector<float> got =
        run(chosen, HdrpVersion::v14, DepthDirection::reversed, bordered(2), inputs);
    float next = 0.0f;
    for (std::size_t i = 0; i < got.size(); i += 2) {
      next += got[i];
      EXPECT_EQ(got[i + 1], 1.0f);
    }
    EXPECT_NEAR(next / 4096.0f, share, 0.02f);
  }
}

TEST(HdrpCascades, TheNormalBiasMovesTheReceiverTowardTheLightWhicheverWayTheNormalFaces) {
  HdrpFrame frame = bordered(1);
  frame.shadows[0].normal_bias = 0.5f;
  frame.shadows[0].world_texel_size = 0.25f;
  frame.shadows[0].cache_translation = {1.0f, 0.0f, 0.0f};
  frame.forward = {0.0f, -1.0f, 0.0f};
  const HdrpFunction place{
      "const PenumbraHdrpLight light = PreparePenumbraHdrpLight(float3(0, 0, 10), float3(0, In(0), 0), "
      "float2(0, 0)); Out2(0, light.receiver.shadowCoord.xy);",
      1, 2};
  const std::vector<float> got =
      run(place, HdrpVersion::v14, DepthDirection::reversed, frame, {0.0f, 1.0f, -1.0f});
  const float u_per_metre = 0.5f * 0.1f * 0.5f, v_per_metre = 0.5f * 0.1f;
  EXPECT_NEAR(got[0], 0.25f + u_per_metre * 1.0f, 1e-6f) << "moved by the cache's delta";
  EXPECT_NEAR(got[1], 0.5f, 1e-6f) << "no normal, no bias";
  EXPECT_NEAR(got[3], 0.5f + v_per_metre * 0.125f, 1e-6f);
  EXPECT_NEAR(got[5], 0.5f + v_per_metre * 0.125f, 1e-6f);
}

}  // namespace
}  // namespace penumbra::shader_library_tests
