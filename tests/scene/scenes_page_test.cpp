// docs/measuring.md has every scene, with the numbers that the scene itself has.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <glm/trigonometric.hpp>
#include <iterator>
#include <sstream>

#include "scene/scene.h"

namespace penumbra::scene {
namespace {

using testing::HasSubstr;

std::string page() {
  std::ifstream file(PENUMBRA_SOURCE_DIR "/docs/measuring.md");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return digits;
}

// The line of the table that begins with the scene's name.
std::string row(const std::string& name) {
  const std::string text = page();
  const std::size_t begin = text.find("\n| `" + name + "` |");
  if (begin == std::string::npos) return "no row";
  return text.substr(begin + 1, text.find('\n', begin + 1) - begin - 1);
}

TEST(ScenesPage, SaysOfEveryBuiltInSceneItsSunDistanceAndTriangles) {
  for (const std::string& name : all_built_in_names()) {
    const Scene scene = built_in(name);
    const glm::dvec3 to_sun = -scene.light_direction;
    std::ostringstream numbers;
    numbers << "| " << std::lround(glm::degrees(std::asin(to_sun.y))) << ", "
            << std::lround(glm::degrees(std::atan2(to_sun.x, to_sun.z))) << " | "
            << scene.shadow_distance_metres << " | " << grouped(scene.mesh.triangle_count()) << " |";
    EXPECT_THAT(row(name), testing::EndsWith(numbers.str())) << name;
  }
}

TEST(ScenesPage, SaysOfEveryPackagesModelWhatItIsAndWhereItComesFrom) {
  for (const PackageModel& model : package_models()) {
    const std::string line = row("package:" + model.name);
    EXPECT_THAT(line, HasSubstr("| `package:" + model.name + "` | " + model.description));
    EXPECT_THAT(line, HasSubstr("| `" + model.debian_package + "` |"));
  }
}

}  // namespace
}  // namespace penumbra::scene
