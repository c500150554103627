// The printed text reads back: JSON to the same floats, C++ through a compiler (see CMakeLists.txt).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "parameters/emit_constants.h"
#include "parameters/emit_disks.h"
#include "parameters/random_setup.h"

namespace penumbra::parameters {
namespace {

using testing::HasSubstr;

nlohmann::json json_of(const ShadowSetup& setup) {
  return nlohmann::json::parse(constants_json(setup.fit()));
}

TEST(ConstantsJson, HasTheContractsKeys) {
  ShadowSetup setup;
  setup.shadows.cascades = 4;
  const nlohmann::json json = json_of(setup);
  EXPECT_EQ(json.at("angular_diameter_degrees"), 0.53);
  EXPECT_EQ(json.at("matrix_order"), "row-major");
  EXPECT_EQ(json.at("reversed_z"), true);
  ASSERT_EQ(json.at("cascades").size(), 4u);
  for (int i = 0; i < 4; ++i) {
    const nlohmann::json& cascade = json["cascades"][static_cast<std::size_t>(i)];
    EXPECT_EQ(cascade.at("index"), i);
    for (const char* key : {"view", "projection", "world_to_shadow"}) EXPECT_EQ(cascade.at(key).size(), 16u);
    for (const char* key : {"offset_scale", "split_sphere"}) EXPECT_EQ(cascade.at(key).size(), 4u);
    for (const char* key : {"depth_to_radial", "radial_to_depth", "depth_to_radial_hdrp", "texel_size_metres",
                            "max_penumbra_texels", "ulp"}) {
      EXPECT_TRUE(cascade.at(key).is_number()) << key;
    }
    EXPECT_TRUE(cascade.at("bias").at("depth").is_number());
    EXPECT_TRUE(cascade.at("bias").at("normal").is_number());
    EXPECT_LE(cascade.at("ulp").get<double>(), 0.5);
    EXPECT_GT(cascade.at("ulp").get<double>(), 0.0);
  }
}

TEST(ConstantsJson, NumbersReadBackToTheSameFloats) {
  SetupGenerator generator(21);
  for (int i = 0; i < 50; ++i) {
    const ShadowSetup setup = generator.next();
    const CascadeSet set = setup.fit();
    const nlohmann::json json = json_of(setup);
    for (const Cascade& cascade : set.cascades) {
      const nlohmann::json& read = json["cascades"][static_cast<std::size_t>(cascade.index)];
      EXPECT_EQ(read["depth_to_radial"].get<float>(), static_cast<float>(cascade.depth_to_radial));
      for (int r = 0; r < 4; ++r) {
        for (int c = 0; c < 4; ++c) {
          EXPECT_EQ(read["world_to_shadow"][static_cast<std::size_t>(4 * r + c)].get<float>(),
                    static_cast<float>(cascade.world_to_shadow[c][r]));
        }
      }
    }
  }
}

// The set-up can be followed by hand: the light along +z, a lens of 90 degrees both ways, one cascade.
//   k^2 = 2, near 1, far 3. The equally far point, (1 + 3) / 2 * 3 = 6, lies beyond: centre 3,
//   radius 3 sqrt 2.
TEST(ConstantsJson, GoldenSetupAgreesWithLongDoubleByHand) {
  ShadowSetup setup;
  setup.camera = {.position = {0, 0, 0}, .fov_y_degrees = 90, .aspect = 1, .near_plane = 1, .far_plane = 100};
  setup.light = {.direction = {0, 0, 2}, .angular_diameter_degrees = 2};
  setup.shadows.distance_metres = 3;
  setup.shadows.resolution = 1024;
  setup.shadows.near_plane_offset_metres = 0;
  setup.shadows.reversed_z = false;
  const nlohmann::json c = json_of(setup)["cascades"][0];
  const long double radius = 3.0L * std::sqrt(2.0L);
  const long double half = radius * 1024.0L / (1024.0L - 2.0L * 0.501);
  const long double tan_half = std::tan(std::numbers::pi_v<long double> / 180.0L);
  const auto is = [](const nlohmann::json& emitted, long double exact) {
    EXPECT_EQ(emitted.get<float>(), static_cast<float>(exact));
  };
  is(c["split_sphere"][2], 3.0L);
  is(c["split_sphere"][3], radius);
  is(c["texel_size_metres"], 2.0L * half / 1024.0L);
  is(c["uv_per_metre"], 0.5L / half);
  is(c["depth_per_metre"], 0.5L / radius);
  is(c["depth_to_radial"], tan_half * radius / half);
  is(c["radial_to_depth"], half / (tan_half * radius));
  is(c["depth_to_radial_hdrp"], 2.0L * tan_half * radius / half);
  is(c["max_penumbra_texels"], 1024.0L * tan_half * radius / half);
  is(c["bias"]["depth"], -2.5L * 2.0L * half / 1024.0L);
  is(c["projection"][0], 1.0L / half);
  is(c["projection"][10], -0.5L / radius);
  is(c["world_to_shadow"][0], 0.5L / half);  // x right
  is(c["world_to_shadow"][5], 0.5L / half);  // y up
  is(c["world_to_shadow"][10], 0.5L / radius);
  is(c["world_to_shadow"][11], -(3.0L - radius) / (2.0L * radius));  // near plane at 3 - radius
}

TEST(ConstantsJson, PointLightsInverseIsNull) {
  ShadowSetup setup;
  setup.light.angular_diameter_degrees = 0;
  const nlohmann::json cascade = json_of(setup)["cascades"][0];
  EXPECT_TRUE(cascade["radial_to_depth"].is_null());
  EXPECT_EQ(cascade["depth_to_radial"], 0.0);
}

TEST(ConstantsTable, SaysWhereTheDepthRangeComesFromAndTheError) {
  const ShadowSetup setup;
  const std::string table = constants_table(setup.fit());
  EXPECT_THAT(table, HasSubstr("depth range: split sphere's diameter plus the near-plane offset"));
  EXPECT_THAT(table, HasSubstr("largest error (ULP)"));
  EXPECT_THAT(table, HasSubstr("reversed Z"));
}

TEST(SourceText, LiteralsAreShortestAndNeverIntegers) {
  EXPECT_EQ(float_literal(1.0F), "1.0");
  EXPECT_EQ(float_literal(0.1F), "0.1");
  EXPECT_EQ(float_literal(-1e-20F), "-1e-20");
  SetupGenerator generator(22);
  for (int i = 0; i < 1000; ++i) {
    const auto value =
        static_cast<float>(generator.uniform(-1, 1) * std::pow(10.0, generator.uniform(-30, 30)));
    EXPECT_EQ(std::stof(float_literal(value)), value);
  }
}

// emitted_source_compiles builds its file against what is written here.
TEST(SourceText, WritesEveryLanguageForTheCompilers) {
  ShadowSetup setup;
  setup.shadows.cascades = 4;
  const CascadeSet set = setup.fit();
  const std::string folder = PENUMBRA_EMITTED_DIR;
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder + "/" + name, std::ios::binary) << text;
  };
  write("constants.h", constants_source(set, Language::cpp));
  write("constants.hlsl", constants_source(set, Language::hlsl));
  write("disk_tables.h", disks_source(disk_set(false), Language::cpp));
  write("constants.cs", constants_source(set, Language::csharp));
  write("expected.h", "#pragma once\n#define EXPECTED_DEPTH_TO_RADIAL " +
                          float_literal(static_cast<float>(set.cascades[3].depth_to_radial)) + "f\n");
  const std::string hlsl = constants_source(set, Language::hlsl);
  EXPECT_THAT(hlsl, HasSubstr("static const float4x4 kPenumbraWorldToShadow[4] ="));
  EXPECT_THAT(hlsl, HasSubstr("#ifndef PENUMBRA_CASCADE_CONSTANTS_INCLUDED"));
  EXPECT_THAT(constants_source(set, Language::csharp),
              HasSubstr("public static readonly float[] WorldToShadow"));
}

}  // namespace
}  // namespace penumbra::parameters
