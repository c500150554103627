#include <gmock/gmock.h>

#include <set>
#include <tuple>

#include "as_identifier.h"
#include "has_substrs.h"
#include "scene/content_hash.h"
#include "scene/import_fixture.h"
#include "scene/mesh_properties.h"

namespace penumbra::scene {
namespace {

using testing::HasSubstr;

class PackageModels : public testing::TestWithParam<PackageModel> {};

TEST_P(PackageModels, IsAsTallAsItSaysAndStandsOnTheGround) {
  const Scene scene = package_model(GetParam().name, {.ground = false});
  EXPECT_GT(scene.mesh.triangle_count(), 3000U);
  EXPECT_NEAR(scene.bounds().minimum.y, 0.0, 1e-5);
  EXPECT_NEAR(scene.bounds().maximum.y, GetParam().height_metres, 1e-5);
  for (const glm::vec3& normal : scene.mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Debian, PackageModels, testing::ValuesIn(package_models()),
                         [](const auto& test) { return as_identifier(test.param.name); });

TEST(HorseModel, RearsInsteadOfLyingOnItsSide) {
  const Scene scene = package_model("glmark2/horse", {.ground = false});
  const parameters::Bounds box = scene.bounds();
  const glm::dvec3 extent = box.maximum - box.minimum;
  EXPECT_GT(extent.y, extent.x);
  EXPECT_GT(extent.y, extent.z);
  // Head, neck and forelegs are above; only hind legs and tail are below.
  const std::vector<glm::vec3>& places = scene.mesh.positions;
  const auto low = std::count_if(places.begin(), places.end(), [](auto p) { return p.y < 0.6F; });
  const auto high = std::count_if(places.begin(), places.end(), [](auto p) { return p.y > 1.9F; });
  EXPECT_GT(high, low);
}

TEST(MilkTruck, IsPainted) {
  const Scene scene = package_model("assimp/milk-truck");
  EXPECT_TRUE(scene.notes.empty()) << scene.notes.front();
  ASSERT_EQ(scene.textures.size(), 1U);
  EXPECT_EQ(scene.textures[0].width, 2048);
  EXPECT_EQ(scene.mesh.uvs.size(), scene.mesh.positions.size());
  std::size_t painted = 0;
  for (std::size_t i = 0; i < scene.mesh.triangle_count(); ++i) {
    painted += scene.materials.at(scene.mesh.material_of(i)).base_colour_texture == 0 ? 1U : 0U;
  }
  EXPECT_GT(painted, scene.mesh.triangle_count() / 3);
}

TEST(Engine, HasColoursOfItsOwn) {
  const Scene scene = package_model("assimp/engine", {.ground = false});
  std::set<std::tuple<float, float, float>> colours;
  for (std::size_t i = 0; i < scene.mesh.triangle_count(); ++i) {
    const glm::vec3 colour = scene.materials.at(scene.mesh.material_of(i)).base_colour;
    colours.insert({colour.r, colour.g, colour.b});
  }
  EXPECT_GE(colours.size(), 4U);
}

TEST_F(ImportTest, MissingPackageIsTheEnvironmentsFaultAndNamesThePackage) {
  try {
    package_model("glmark2/horse", {}, folder_);
    FAIL();
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstrs("horse.3ds", "apt-get install glmark2-data"));
  }
}

TEST_F(ImportTest, LoadTakesBuiltInNamesPackageNamesAndFiles) {
  EXPECT_EQ(content_hash(load("slabs")), content_hash(built_in("slabs")));
  EXPECT_EQ(load("package:glmark2/horse").name, "glmark2/horse");
  const auto file = write("tetrahedron.obj", kTetrahedron);
  EXPECT_EQ(load(file.string()).name, "tetrahedron");
  for (const std::string& name : built_in_names()) EXPECT_THAT(scene_names(), testing::Contains(name));
}

TEST_F(ImportTest, LoadNamesTheNearestOfWhatItDoesNotKnow) {
  const auto refusal_of = [](std::string_view name) -> std::string {
    return input_error_of([&] { load(name); });
  };
  EXPECT_THAT(refusal_of("tress"), HasSubstr("did you mean 'trees'"));
  EXPECT_THAT(refusal_of("package:glmark2/hors"), HasSubstr("did you mean 'glmark2/horse'"));
  EXPECT_THAT(refusal_of("no/such.glb"), HasSubstrs("no/such.glb", "no such file"));
  EXPECT_THAT(refusal_of(""), HasSubstr("known are: contact-boxes"));
}

}  // namespace
}  // namespace penumbra::scene
