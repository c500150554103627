// Tests a study of a landscape: what is baked of its ground, and figures by distance.
#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "scene/mesh_builder.h"
#include "study/small_study.h"

namespace penumbra::study {
namespace {

constexpr int kSquares = 64;
constexpr double kSquare = 20.0;

// A ridge 60 m high lies across level ground and is seen along it; a post near the camera is not ground.
scene::Scene ridge(double sun_elevation) {
  std::vector<double> heights;
  for (int z = 0; z <= kSquares; ++z)
    for (int x = 0; x <= kSquares; ++x)
      heights.push_back(60.0 * std::exp(-std::pow((x - 40.0) / 4.0, 2)) + 1.0);
  scene::MeshBuilder mesh;
  mesh.heights({-0.5 * kSquares * kSquare, 0.0}, kSquare, kSquares, heights);
  mesh.standing_box({-70.0, 1.0, 75.0}, {1.0, 30.0, 1.0});
  scene::Scene scene;
  scene.name = "ridge";
  mesh.move_into(scene);
  scene.ground_triangles = std::size_t{2} * kSquares * kSquares;
  scene.camera = scene::camera_looking({-90.0, 31.0, 20.0}, {-60.0, 1.0, 400.0});
  scene.camera.far_plane = 3000.0;
  scene.light_direction = scene::sunlight(sun_elevation, 90.0);
  scene.shadow_distance_metres = 100.0;
  scene.seen_distance_metres = 1000.0;
  return scene;
}

std::map<std::string, Record> recorded_landscape(const scene::Scene& scene,
                                                 const std::vector<std::string>& names) {
  SmallStudy study(scene, 0.53, 240, 136);
  study.settings.split_error = true;
  study.settings.bake = {129, 128, 0.0};
  std::map<std::string, Record> records = study.records(library_subjects(names));
  for (const auto& [name, record] : records) EXPECT_EQ(record.metrics.invalid, 0U) << name;
  return records;
}

const DistanceRecord& ring_at(const Record& record, double metres) {
  for (const DistanceRecord& ring : record.by_distance)
    if (ring.from_metres <= metres && metres < ring.to_metres) return ring;
  throw std::out_of_range("no ring");
}

TEST(LandscapeStudy, FarShadowsTakeOverFromTheCascadesByDistance) {
  const auto of = recorded_landscape(
      ridge(16.0), {"pcss-angular-24-16", "far-horizon", "far-heights-32", "pcss-angular-24-16-far-horizon"});
  const Record& cascades = of.at("pcss-angular-24-16");
  const Record& both = of.at("pcss-angular-24-16-far-horizon");
  const Record& horizon = of.at("far-horizon");
  for (const auto& [name, record] : of) {
    ASSERT_FALSE(record.by_distance.empty()) << name;
    EXPECT_EQ(record.by_distance.front().from_metres, 0.0);
    EXPECT_EQ(record.by_distance.back().to_metres, 1000.0);
    std::size_t pixels = 0;
    for (const DistanceRecord& ring : record.by_distance) pixels += ring.pixels;
    EXPECT_LE(pixels, record.metrics.pixels) << name;
    EXPECT_GT(pixels, record.metrics.pixels - 50) << name << ": all but what lies exactly on the last limit";
    ASSERT_TRUE(record.far_seam) << name;
    EXPECT_FALSE(record.metrics.split.map) << "maps do not reach so far";
  }
  // Beyond the shadow distance the cascades leave all lit, and the ridge's shadow is missing.
  EXPECT_GT(ring_at(cascades, 300.0).rmse_all.value(), 0.3);
  EXPECT_LT(ring_at(both, 300.0).rmse_all.value(), 0.12);
  EXPECT_NEAR(ring_at(both, 300.0).rmse_all.value(), ring_at(horizon, 300.0).rmse_all.value(), 1e-6);
  EXPECT_NEAR(ring_at(both, 10.0).rmse_all.value(), ring_at(cascades, 10.0).rmse_all.value(), 0.01);
  // The post is no ground, so its shadow is the cascades' alone.
  EXPECT_GT(ring_at(horizon, 70.0).rmse_all.value(), 2.0 * ring_at(both, 70.0).rmse_all.value());
  EXPECT_LT(ring_at(of.at("far-heights-32"), 300.0).rmse_all.value(), 0.2);

  EXPECT_FALSE(cascades.baked_mebibytes);
  EXPECT_DOUBLE_EQ(horizon.baked_mebibytes.value(), 2.0 * 128 * 128 * 8 / (1024.0 * 1024.0));
  EXPECT_DOUBLE_EQ(of.at("far-heights-32").baked_mebibytes.value(), 129.0 * 129 * 2 / (1024.0 * 1024.0));
}

TEST(LandscapeStudy, TheMapOfCloudsHoldsTheShadowOfTheLayer) {
  scene::Scene scene = ridge(30.0);
  scene.clouds = scene::CloudLayer{};
  scene.clouds->feature_metres = 2400.0;
  const auto of =
      recorded_landscape(scene, {"pcss-angular-24-16-far-horizon", "pcss-angular-24-16-far-horizon-clouds"});
  const double without = of.at("pcss-angular-24-16-far-horizon").metrics.rmse_all.value();
  const double with = of.at("pcss-angular-24-16-far-horizon-clouds").metrics.rmse_all.value();
  EXPECT_GT(without, 0.1);
  EXPECT_LT(with, 0.3 * without);
}

TEST(LandscapeStudy, CloudsOfScenesAreThoseOfTheManifest) {
  const auto& values = library_techniques().find("pcss-angular-24-16-far-horizon-clouds").values;
  const scene::CloudLayer clouds;
  EXPECT_EQ(values.at("cloudAltitudeMetres").front(), clouds.altitude_metres);
  EXPECT_EQ(values.at("cloudFeatureMetres").front(), clouds.feature_metres);
  EXPECT_EQ(values.at("cloudCoverage").front(), clouds.coverage);
  EXPECT_EQ(values.at("cloudDensity").front(), clouds.density);
}

}  // namespace
}  // namespace penumbra::study
