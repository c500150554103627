// The checked-in golden vectors are what the program writes today, and are fit to compare floats with.
#include "parameters/golden_vectors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "parameters/golden_cameras.h"

namespace penumbra::parameters {
namespace {

constexpr int kCount = 64;
constexpr std::uint32_t kSeed = 1;

std::string checked_in() {
  std::ostringstream text;
  text << std::ifstream(PENUMBRA_SOURCE_DIR "/tests/golden/parameters.json", std::ios::binary).rdbuf();
  return text.str();
}

TEST(GoldenVectors, TheCheckedInFileIsWhatTheProgramWrites) {
  EXPECT_TRUE(checked_in() == golden_vectors_json(kCount, kSeed))
      << "write it again: penumbra constants --golden 64 --seed 1 -o tests/golden/parameters.json";
}

TEST(GoldenVectors, TheSeedDecidesTheBytes) {
  EXPECT_EQ(golden_vectors_json(5, 7), golden_vectors_json(5, 7));
  EXPECT_NE(golden_vectors_json(5, 7), golden_vectors_json(5, 8));
}

TEST(GoldenVectors, TheCountIsOfRandomOnesInEveryKind) {
  const auto few = nlohmann::json::parse(golden_vectors_json(3, 1));
  const auto more = nlohmann::json::parse(golden_vectors_json(10, 1));
  for (const char* kind : {"angles", "cascades", "projections", "uniforms", "cameras"}) {
    EXPECT_EQ(more.at(kind).size() - few.at(kind).size(), 7u) << kind;
  }
  EXPECT_EQ(few.at("projections").size(), 3u);
}

void expect_finite_floats(const nlohmann::json& value, const std::string& path) {
  if (value.is_structured()) {
    for (const auto& [key, part] : value.items())
      expect_finite_floats(part, std::string(path).append("/").append(key));
    return;
  }
  EXPECT_FALSE(value.is_null()) << path;
  if (!value.is_number_float()) return;
  EXPECT_TRUE(std::isfinite(static_cast<float>(value.get<double>()))) << path;
}

TEST(GoldenVectors, EveryNumberIsAFiniteFloat) {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    expect_finite_floats(nlohmann::json::parse(golden_vectors_json(kCount, seed)), "");
  }
}

// An input that is not a float would be another one to whoever reads it back.
void expect_float(double value, const std::string& where) {
  EXPECT_EQ(value, static_cast<double>(static_cast<float>(value))) << where;
}

void expect_floats(const glm::dmat4& matrix, const std::string& where) {
  for (int entry = 0; entry < 16; ++entry) expect_float(matrix[entry / 4][entry % 4], where);
}

void expect_floats(const SoftShadowParameters& parameters, const std::string& where) {
  expect_float(parameters.angular_diameter_degrees, where);
  expect_float(parameters.blocker_clump, where);
  expect_float(parameters.min_filter_texels, where);
  expect_float(parameters.max_penumbra_metres, where);
  expect_float(parameters.max_sampling_metres, where);
  expect_float(parameters.search_radius_metres, where);
  expect_float(parameters.hdrp_search_degrees, where);
  expect_float(parameters.hdrp_min_filter_degrees, where);
}

TEST(GoldenVectors, EveryInputIsAFloatExactly) {
  SetupGenerator generator(4);
  for (const GoldenCamera& camera : golden_cameras(kCount, generator)) {
    expect_floats(camera.view, camera.name);
    expect_floats(camera.gpu_projection, camera.name);
  }
  for (const GoldenCascade& cascade : golden_cascades(kCount, generator)) {
    expect_floats(cascade.world_to_shadow, cascade.name);
    expect_floats(cascade.parameters, cascade.name);
    expect_float(cascade.depth_bias, cascade.name);
    expect_float(cascade.normal_bias, cascade.name);
  }
  for (const SoftShadowParameters& settings : golden_settings(kCount, generator)) {
    expect_floats(settings, "settings");
  }
}

}  // namespace
}  // namespace penumbra::parameters
