// Compares the scales and parameters that Pipelines/Hdrp.hlsl derives from HDRP's shadow data with those of
// tests/golden/parameters.json: the same matrices, taken apart as HDRP uploads them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/hdrp_frame.h"
#include "parameters/cascades.h"
#include "parameters/half_angle.h"

namespace penumbra::shader_library_tests {
namespace {

struct GoldenCascade {
  nlohmann::json record;
  HdrpShadow shadow;
  glm::vec2 atlas_texels{};
};

float number(const nlohmann::json& record, const char* name) {
  return static_cast<float>(record.at(name).get<double>());
}

glm::vec4 vector(const nlohmann::json& values) {
  return {values[0].get<double>(), values[1].get<double>(), values[2].get<double>(), values[3].get<double>()};
}

// Takes a matrix to atlas UV, of the first tile, apart into a view of unit rows and a projection: HDRP's
// shader multiplies m00 of the projection by the view's first row, and halves it for the tile's UV.
HdrpShadow taken_apart(const nlohmann::json& record, const parameters::AtlasLayout& layout) {
  const nlohmann::json& m = record.at("world_to_shadow");
  const glm::dvec2 extent(double(layout.tile_resolution) / layout.width,
                          double(layout.tile_resolution) / layout.height);
  HdrpShadow shadow;
  glm::dvec3 scale{0.0};
  for (int row = 0; row < 3; ++row) {
    const std::size_t at = std::size_t(row) * 4;
    const glm::dvec4 values(m[at].get<double>(), m[at + 1].get<double>(), m[at + 2].get<double>(),
                            m[at + 3].get<double>());
    scale[row] = glm::length(glm::dvec3(values));
    shadow.view[std::size_t(row)] = glm::vec4(glm::dvec4(glm::dvec3(values) / scale[row], 0.0));
  }
  shadow.projection = glm::vec4(2.0 * scale.x / extent.x, 2.0 * scale.y / extent.y, scale.z, 0.0);
  shadow.tile_texels = glm::vec2(static_cast<float>(layout.tile_resolution));
  shadow.blocker_samples = record.at("blocker_samples").get<int>();
  shadow.filter_samples = record.at("filter_samples").get<int>();
  shadow.params0 = vector(record.at("hdrp_params0"));
  shadow.params1 = vector(record.at("hdrp_params1"));
  return shadow;
}

// The golden cascades whose scales are of a size that shadow maps have: a micrometre to a thousand kilometres
// across. Beyond, the package's C# is what is tested; shaders see what HDRP fits around a camera.
const std::vector<GoldenCascade>& golden_cascades() {
  static const std::vector<GoldenCascade> cascades = [] {
    std::ifstream file(PENUMBRA_SOURCE_DIR "/tests/golden/parameters.json");
    const nlohmann::json golden = nlohmann::json::parse(file);
    std::vector<GoldenCascade> found;
    for (const nlohmann::json& record : golden.at("cascades")) {
      const double uv = record.at("uv_per_metre"), depth = record.at("depth_per_metre");
      if (uv < 1e-6 || uv > 1e6 || depth < 1e-6 || depth > 1e6) continue;
      const parameters::AtlasLayout layout =
          parameters::atlas_layout(record.at("resolution"), record.at("cascades"));
      found.push_back({record, taken_apart(record, layout), glm::vec2(layout.width, layout.height)});
    }
    return found;
  }();
  return cascades;
}

std::vector<float> run_one(const HdrpFunction& function, HdrpVersion version, const GoldenCascade& golden) {
  HdrpFrame frame;
  frame.shadows = {golden.shadow};
  frame.atlas_texels = golden.atlas_texels;
  frame.pcss = {glm::vec4(7.0f, 9.0f, 3.0f, 2.0f), glm::vec4(0.25f, 0.75f, 0.125f, 0.375f)};
  const auto tan_half = static_cast<float>(parameters::tan_half(golden.record.at("degrees").get<double>()));
  return run(function, version, DepthDirection::reversed, frame, {tan_half});
}

// A tangent, a view row's length, a ratio and its inverse each round once.
constexpr long double kRoundings = 4.0L;

void expect_close(float got, float exact, const std::string& what) {
  EXPECT_LE(error_in_ulp(got, {exact}), kRoundings) << what << ": " << got << ", golden " << exact;
}

TEST(HdrpPacking, GoldenCascadesOfAShadowMapsSizeAreThere) {
  EXPECT_GE(golden_cascades().size(), 20u);
}

// The last output is the scale that PcssHdrp itself works with, per tile UV.
const HdrpFunction kTile{
    "const ShadowTile tile = PenumbraHdrpTile(_HDShadowDatas[0], In(0)); const ConeScales cone = "
    "ConeScalesOf(tile); const HdrpScales hdrp = HdrpScalesOf(cone, "
    "PenumbraHdrpParametersOf(_HDShadowDatas[0])); Out(0, tile.uvPerMetre); Out(1, tile.depthPerMetre); "
    "Out(2, tile.depthToRadial); Out(3, tile.radialToDepth); Out(4, hdrp.texelsPerDepth / "
    "cone.largestRadius);",
    1,
    5,
    {{"_PENUMBRA_PCSS_HDRP", "1"}}};

class EveryVersion : public ::testing::TestWithParam<HdrpVersion> {};
INSTANTIATE_TEST_SUITE_P(HdrpPacking, EveryVersion, ::testing::ValuesIn(kHdrpVersions));

TEST_P(EveryVersion, TileScalesAreTheGoldenOnes) {
  for (const GoldenCascade& golden : golden_cascades()) {
    const std::vector<float> scales = run_one(kTile, GetParam(), golden);
    const std::string name = golden.record.at("name");
    expect_close(scales[0], number(golden.record, "uv_per_metre"), name + " uv per metre");
    expect_close(scales[1], number(golden.record, "depth_per_metre"), name + " depth per metre");
    if (number(golden.record, "depth_to_radial") < 1e-20f && number(golden.record, "degrees") > 0.0f)
      continue;
    expect_close(scales[2], number(golden.record, "depth_to_radial"), name + " depth to radial");
    expect_close(scales[3], number(golden.record, "radial_to_depth"), name + " radial to depth");
    expect_close(scales[4], number(golden.record, "depth_to_radial_hdrp"), name + " HDRP's depth to radial");
  }
}

const HdrpFunction kParameters{
    "const PcssHdrpParameters p = PenumbraHdrpParametersOf(_HDShadowDatas[0]); Out(0, p.blockerSamples); "
    "Out(1, p.filterSamples); Out(2, p.blockerClump); Out(3, p.minFilterTexels); Out(4, "
    "p.maxPenumbraMetres); Out(5, p.maxSamplingMetres); Out(6, p.searchTanHalf); Out(7, p.minFilterTanHalf);",
    1, 8};

float tan_half(double degrees) {
  return static_cast<float>(std::tan(degrees * std::numbers::pi / 360.0));
}

TEST(HdrpPacking, TheLightsSettingsComeBackFromWhatHdrpPacks) {
  int with_disc = 0;
  for (const HdrpVersion version : {HdrpVersion::v17, HdrpVersion::six_cascades}) {
    for (const GoldenCascade& golden : golden_cascades()) {
      const nlohmann::json& set = golden.record;
      const std::string name = set.at("name");
      const std::vector<float> got = run_one(kParameters, version, golden);
      EXPECT_EQ(got[0], number(set, "blocker_samples")) << name;
      EXPECT_EQ(got[1], number(set, "filter_samples")) << name;
      EXPECT_EQ(got[2], std::clamp(number(set, "blocker_clump"), 1.0f, 8.0f)) << name;
      EXPECT_EQ(got[3], std::clamp(number(set, "min_filter_texels"), 0.0f, 64.0f)) << name;
      EXPECT_EQ(got[5], std::clamp(number(set, "max_sampling_metres"), 0.0f, 1e6f)) << name;
      const double light = std::clamp(set.at("degrees").get<double>(), 0.0, 30.0);
      const double search =
          std::max(light, std::clamp(set.at("hdrp_search_degrees").get<double>(), 0.0, 90.0));
      const double smallest =
          std::max(search, std::clamp(set.at("hdrp_min_filter_degrees").get<double>(), 0.0, 90.0));
      expect_close(got[6], tan_half(search), name + " search");
      expect_close(got[7], tan_half(smallest), name + " smallest filter");
      if (light < 1e-6) continue;
      ++with_disc;
      expect_close(got[4], std::clamp(number(set, "max_penumbra_metres"), 0.0f, 1e6f),
                   name + " widest penumbra");
    }
  }
  EXPECT_GE(with_disc, 40);
}

const std::vector<float> kOwnParameters{7.0f, 9.0f, 3.0f, 2.0f, 0.25f, 0.75f, 0.125f, 0.375f};

TEST(HdrpPacking, WithoutPackedSettingsThePackagesUniformsServe) {
  GoldenCascade golden = golden_cascades().front();
  EXPECT_EQ(run_one(kParameters, HdrpVersion::v14, golden), kOwnParameters);
  // HDRP leaves these values below High quality.
  golden.shadow.params0 = golden.shadow.params1 = glm::vec4(0.0f);
  EXPECT_EQ(run_one(kParameters, HdrpVersion::v17, golden), kOwnParameters);
  const std::vector<float> tile = run_one(kTile, HdrpVersion::v17, golden);
  expect_close(tile[2], number(golden.record, "depth_to_radial"),
               "the light's diameter is the package's too");
}

TEST(HdrpPacking, ALightWithoutADiscIsHardAndFinite) {
  GoldenCascade golden = golden_cascades().front();
  // HDRP divides by the tangent: the inverse and the farthest blocker are infinite.
  golden.shadow.params0.x = 0.0f;
  golden.shadow.params0.y = golden.shadow.params0.z = std::numeric_limits<float>::infinity();
  for (const std::vector<float>& got :
       {run_one(kTile, HdrpVersion::v17, golden), run_one(kParameters, HdrpVersion::v17, golden)}) {
    for (const float value : got) EXPECT_TRUE(std::isfinite(value)) << value;
  }
  EXPECT_EQ(run_one(kTile, HdrpVersion::v17, golden)[2], 0.0f);
  EXPECT_EQ(run_one(kTile, HdrpVersion::v17, golden)[3], 0.0f);
}

}  // namespace
}  // namespace penumbra::shader_library_tests
