#include <gmock/gmock.h>

#include <glm/trigonometric.hpp>
#include <map>
#include <set>

#include "as_identifier.h"
#include "input/input_error_matcher.h"
#include "scene/content_hash.h"
#include "scene/mesh_properties.h"
#include "scene/scene.h"

namespace penumbra::scene {
namespace {

class BuiltIn : public testing::TestWithParam<std::string> {
 protected:
  const Scene scene = built_in(GetParam());
};

TEST_P(BuiltIn, IsTheSameToTheByteEverywhere) {
  // These hashes were taken when the scenes were looked at. A changed scene changes every published figure:
  // update both together.
  const std::map<std::string, std::string> golden{
      {"contact-boxes", "1626be759b9a731721041cc2d384d9fabd44ae0558bc91309f11a7bc70413335"},
      {"poles-and-fence", "1733bdd4d6157f58981b9ed77543fd72fad738b06f7915fbf1303b0dac537db6"},
      {"trees", "f3f5748b6f288b653971282277505254a773846ea6d34e535b40786cb5ddef65"},
      {"slabs", "4e9bfe0871dabe5550023772e3281051fc59ce380e38d6779c67bc391ff92e46"},
      {"colonnade", "d94d04e26d0482d9764c2b41bf00fa3f46f6fd9af24f6773ef354007c59caf94"},
      {"street", "b9e85a3580ae0e28f5dd4390ae4fc01b931d0e855e5a42e7e3c108c95c223da1"},
      {"garden", "49b06af10b503e49e1b7ae199d654ad2f4f585cf34a914bef63b25f7e6f3783d"},
      {"overlaps", "efc34cebca352a9fbad7c5ad2f81915c63bda66fcc9027108b3dd703caeeed3f"},
      {"wires-and-smoke", "9fbabed107752ad0e99b9e0256d90efb4b09dc7d368905858f68116c56806577"},
  };
  EXPECT_EQ(content_hash(scene), golden.at(GetParam()));
  EXPECT_EQ(content_hash(built_in(GetParam())), content_hash(scene));
}

TEST_P(BuiltIn, HasFiniteVerticesUnitNormalsAndIndicesInRange) {
  ASSERT_EQ(scene.mesh.positions.size(), scene.mesh.normals.size());
  for (std::size_t i = 0; i < scene.mesh.positions.size(); ++i) {
    const glm::vec3 p = scene.mesh.positions[i];
    ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) << "vertex " << i;
    ASSERT_NEAR(glm::length(scene.mesh.normals[i]), 1.0, 1e-5) << "vertex " << i;
  }
  ASSERT_EQ(scene.mesh.indices.size() % 3, 0U);
  for (const std::uint32_t index : scene.mesh.indices) ASSERT_LT(index, scene.mesh.positions.size());
}

TEST_P(BuiltIn, HasTrianglesWithAnAreaWhoseNormalsFollowTheWinding) {
  for (std::size_t i = 0; i < scene.mesh.triangle_count(); ++i) {
    const glm::dvec3 area = area_vector(scene.mesh, i);
    ASSERT_GT(glm::length(area), 2e-6) << "triangle " << i;  // a square millimetre
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 normal(scene.mesh.normals[scene.mesh.indices[3 * i + k]]);
      ASSERT_GT(glm::dot(normal, area), 0.0) << "triangle " << i;
    }
  }
}

TEST_P(BuiltIn, GivesEveryTriangleAMaterialOfNature) {
  ASSERT_EQ(scene.mesh.triangle_materials.size(), scene.mesh.triangle_count());
  std::set<std::size_t> used;
  for (std::size_t i = 0; i < scene.mesh.triangle_count(); ++i) used.insert(scene.mesh.material_of(i));
  EXPECT_LT(*used.rbegin(), scene.materials.size());
  EXPECT_FALSE(used.contains(0)) << "some surface was drawn before any material was chosen";
  EXPECT_GE(used.size(), 3U);
  for (const Material& material : scene.materials) {
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_GT(material.base_colour[channel], 0.0F) << material.name;
      EXPECT_LT(material.base_colour[channel], 0.9F) << material.name << " is whiter than snow";
    }
  }
}

TEST_P(BuiltIn, IsOfASizeAPersonWouldExpectAndAffordable) {
  EXPECT_GT(scene.mesh.triangle_count(), 500U);
  EXPECT_LT(scene.mesh.triangle_count(), 600'000U);
  const parameters::Bounds bounds = scene.bounds();
  EXPECT_GE(bounds.minimum.y, -0.01) << "nothing lies below the ground";
  EXPECT_GT(bounds.maximum.y, 2.5);
  EXPECT_LT(bounds.maximum.y, 15.0);
  EXPECT_GE(bounds.maximum.z, scene.camera.position.z + scene.shadow_distance_metres);
}

TEST_P(BuiltIn, LooksFromHumanHeightAboveWhatTheCameraStandsOn) {
  const glm::dvec3 eye = scene.camera.position;
  const double height = first_hit(scene.mesh, eye, {0, -1, 0});
  EXPECT_GE(height, 1.6);
  EXPECT_LE(height, 1.8);
  EXPECT_NEAR(glm::length(scene.camera.forward), 1.0, 1e-9);
  EXPECT_LT(winding_number(scene.mesh, eye), 0.25) << "the camera is inside something";
  EXPECT_GT(first_hit(scene.mesh, eye, scene.camera.forward), 1.0) << "something stands before the lens";
}

TEST_P(BuiltIn, HasASunAboveTheHorizon) {
  EXPECT_NEAR(glm::length(scene.light_direction), 1.0, 1e-9);
  EXPECT_LT(scene.light_direction.y, -0.3);
}

// Each camera ray of a grid is followed to the light's centre: the picture has to hold light and shadow.
TEST_P(BuiltIn, ShowsLightAndShadow) {
  const glm::dvec3 right = glm::normalize(glm::cross(scene.camera.up, scene.camera.forward));
  const glm::dvec3 up = glm::cross(scene.camera.forward, right);
  int lit = 0, shadowed = 0;
  for (int i = 0; i < 192; ++i) {
    const int column = i % 16, row = i / 16;
    // The rays go through the lower half of the picture.
    const double x = (column + 0.5) / 8.0 - 1.0, y = -(row + 0.5) / 12.0;
    const glm::dvec3 ray = glm::normalize(scene.camera.forward + x * right + 0.57 * y * up);
    const double distance = first_hit(scene.mesh, scene.camera.position, ray);
    if (distance > scene.shadow_distance_metres) continue;
    const glm::dvec3 seen = scene.camera.position + (distance - 1e-3) * ray;
    (std::isinf(first_hit(scene.mesh, seen, -scene.light_direction)) ? lit : shadowed)++;
  }
  EXPECT_GT(lit, 15);
  EXPECT_GT(shadowed, 15);
}

// landscape_test.cpp has the others.
std::vector<std::string> names_with_near_shadows() {
  std::vector<std::string> names = all_built_in_names();
  std::erase_if(names, [](const std::string& name) { return name.starts_with("valley"); });
  return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, BuiltIn, testing::ValuesIn(names_with_near_shadows()),
                         [](const auto& test) { return as_identifier(test.param); });

TEST(BuiltInNames, NamesTheNearestForOneThatIsUnknown) {
  expect_input_error([&] { built_in("colonade"); },
                     HasSubstrs("unknown scene 'colonade'", "did you mean 'colonnade'"));
}

TEST(Sunlight, MovesBackByAnAngleOfTheSky) {
  for (const double azimuth : {-120.0, 0.0, 55.0, 180.0}) {
    const glm::dvec3 now = sunlight(40.0, azimuth);
    EXPECT_EQ(sun_before(now, 0.0), now);
    for (const double degrees : {0.001, 0.5, 10.0}) {
      const glm::dvec3 before = sun_before(now, degrees);
      EXPECT_NEAR(glm::degrees(std::atan2(glm::length(glm::cross(now, before)), glm::dot(now, before))),
                  degrees, 1e-6);
      EXPECT_NEAR(glm::length(before), 1.0, 1e-12);
    }
  }
  EXPECT_NEAR(glm::length(sun_before(sunlight(45.0, 0.0), 0.1)), 1.0, 1e-9) << "at the pole of the sky";
  // The sun rises in the east (+X), stands in the south (-Z) at noon and sets in the west.
  EXPECT_GT(-sun_before(sunlight(40.0, 180.0), 1.0).x, 0.0) << "before noon";
  EXPECT_LT(-sun_before(sunlight(40.0, 90.0), 1.0).y, std::sin(glm::radians(40.0))) << "lower in the morning";
  EXPECT_GT(-sun_before(sunlight(40.0, -90.0), 1.0).y, std::sin(glm::radians(40.0)))
      << "higher in the afternoon";
}

TEST(Sunlight, TravelsFromWhereTheSunStands) {
  const glm::dvec3 east = sunlight(30.0, 90.0);  // the azimuth goes from +Z towards +X
  EXPECT_NEAR(east.x, -std::cos(glm::radians(30.0)), 1e-9);
  EXPECT_NEAR(east.y, -0.5, 1e-9);
  EXPECT_NEAR(east.z, 0.0, 1e-9);
  for (const double elevation : {0.0, -1.0, 90.1, std::nan("")}) {
    EXPECT_THROW(sunlight(elevation, 0.0), InputError) << elevation;
  }
}

}  // namespace
}  // namespace penumbra::scene
