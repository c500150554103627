// Holds the C++ to tests/golden/parameters.json, which the tests of the package's C# read, too: inputs are
// exact floats, and answers are rounded to float once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

#include "parameters/settings_input.h"
#include "parameters/shader_uniforms.h"

namespace penumbra::parameters {
namespace {

using nlohmann::json;
using testing::ElementsAreArray;

std::vector<json> records(const char* section) {
  std::ifstream file(PENUMBRA_SOURCE_DIR "/tests/golden/parameters.json");
  const std::vector<json> list = json::parse(file).at(section);
  EXPECT_GE(list.size(), 28u) << section;
  return list;
}

double number(const json& value) {
  return static_cast<double>(static_cast<float>(value.get<double>()));
}

glm::dmat4 matrix(const json& row_major) {
  glm::dmat4 result;
  for (int i = 0; i < 16; ++i) result[i % 4][i / 4] = number(row_major.at(static_cast<std::size_t>(i)));
  return result;
}

SoftShadowParameters settings_of(const json& record) {
  return {.angular_diameter_degrees = number(record.at("degrees")),
          .blocker_samples = record.at("blocker_samples"),
          .filter_samples = record.at("filter_samples"),
          .blocker_clump = number(record.at("blocker_clump")),
          .min_filter_texels = number(record.at("min_filter_texels")),
          .max_penumbra_metres = number(record.at("max_penumbra_metres")),
          .max_sampling_metres = number(record.at("max_sampling_metres")),
          .search_radius_metres = number(record.at("search_radius_metres")),
          .hdrp_search_degrees = number(record.at("hdrp_search_degrees")),
          .hdrp_min_filter_degrees = number(record.at("hdrp_min_filter_degrees"))};
}

ShadowSettings biases_of(const json& record) {
  ShadowSettings settings;
  settings.depth_bias = number(record.at("depth_bias"));
  settings.normal_bias = number(record.at("normal_bias"));
  settings.soft_quality = soft_quality_named(record.at("soft_quality"));
  return settings;
}

AtlasLayout layout_of(const json& record) {
  return atlas_layout(record.at("resolution"), record.at("cascades"));
}

void expect(const json& record, const char* key, double got) {
  EXPECT_EQ(static_cast<float>(got), static_cast<float>(number(record.at(key)))) << key << " of " << record;
}

void expect(const json& record, const char* key, const glm::dvec4& got) {
  EXPECT_THAT(record.at(key).get<std::vector<float>>(), ElementsAreArray(&glm::vec4(got)[0], 4))
      << key << " of " << record;
}

TEST(GoldenValues, AnglesAndAtlases) {
  for (const json& record : records("angles")) {
    expect(record, "tan_half", tan_half_of(number(record.at("degrees"))));
    expect(record, "degrees_back", degrees_of(number(record.at("tan_half"))));
  }
  for (const json& record : records("atlases")) {
    const AtlasLayout layout = layout_of(record);
    expect(record, "width", layout.width);
    expect(record, "height", layout.height);
    expect(record, "tile_resolution", layout.tile_resolution);
    for (int i = 0; i < record.at("cascades"); ++i) {
      const glm::vec4 tile(tile_rectangle(layout, i));
      EXPECT_THAT(record.at("tiles").at(static_cast<std::size_t>(i)).get<std::vector<float>>(),
                  ElementsAreArray(&tile[0], 4));
    }
  }
}

TEST(GoldenValues, ScalesBiasesAndPackedParameters) {
  for (const json& record : records("cascades")) {
    const SoftShadowParameters given = settings_of(record);
    CascadeSet set;
    set.angular_diameter_degrees = given.angular_diameter_degrees;
    set.tile_resolution = layout_of(record).tile_resolution;
    Cascade cascade;
    cascade.world_to_shadow = matrix(record.at("world_to_shadow"));
    cascade.offset_scale = tile_rectangle(layout_of(record), 0);
    derive_scales(set, biases_of(record), cascade);
    expect(record, "uv_per_metre", cascade.uv_per_metre);
    expect(record, "depth_per_metre", cascade.depth_per_metre);
    expect(record, "depth_to_radial", cascade.depth_to_radial);
    expect(record, "radial_to_depth", cascade.radial_to_depth.value_or(0.0));
    expect(record, "depth_to_radial_hdrp", cascade.depth_to_radial_hdrp);
    expect(record, "texel_size_metres", cascade.texel_size_metres);
    expect(record, "max_penumbra_texels", cascade.max_penumbra_texels);
    expect(record, "bias_depth", cascade.depth_bias_metres);
    expect(record, "bias_normal", cascade.normal_bias_metres);
    expect(record, "hdrp_params0", hdrp_vectors(cascade, given).params0);
    expect(record, "hdrp_params1", hdrp_vectors(cascade, given).params1);
  }
  for (const json& record : records("projections")) {
    glm::dmat4 projection(1.0);
    projection[0][0] = number(record.at("m00"));
    const auto bias = bias_of_projection(projection, record.at("tile_resolution"), biases_of(record));
    expect(record, "bias_depth", bias.x);
    expect(record, "bias_normal", bias.y);
  }
  for (const json& record : records("uniforms")) {
    const ShaderUniforms packed =
        shader_uniforms(settings_of(record), layout_of(record), record.at("cascades"), record.at("frame"));
    expect(record, "atlas_texel_size", packed.atlas_texel_size);
    expect(record, "main_light_params", packed.main_light_params);
    expect(record, "hdrp_search_tan_half", packed.hdrp_tan_half.x);
    expect(record, "hdrp_min_filter_tan_half", packed.hdrp_tan_half.y);
  }
}

// The program has no such matrix: S = inverse(view) inverse(projection) N, from texture to clip coordinates
// by N.
TEST(GoldenValues, ScreenToWorldIsTheInverseOfTheCamerasMatrices) {
  using Mat4 = glm::mat<4, 4, long double>;
  for (const json& record : records("cameras")) {
    Mat4 n(1);
    n[0][0] = 2, n[3][0] = -1;
    n[1][1] = record.at("uv_starts_at_top") ? -2 : 2, n[3][1] = -n[1][1] / 2;
    if (!record.at("depth_is_zero_to_one")) n[2][2] = 2, n[3][2] = -1;
    const glm::mat4 expected(glm::inverse(Mat4(matrix(record.at("view")))) *
                             glm::inverse(Mat4(matrix(record.at("gpu_projection")))) * n);
    const glm::mat4 got(matrix(record.at("screen_to_world")));
    for (int i = 0; i < 16; ++i) EXPECT_FLOAT_EQ(got[i / 4][i % 4], expected[i / 4][i % 4]) << record;
  }
}

}  // namespace
}  // namespace penumbra::parameters
