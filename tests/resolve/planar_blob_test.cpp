// Compares the techniques without a shadow map with rays: planar shadows with rays through the mesh in
// double, and balls' shadows with rays to the sun's disc.
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <optional>

#include "resolve/drawn_scenes.h"
#include "resolve/kept_runners.h"
#include "resolve/run_once.h"

namespace penumbra::resolve {
namespace {

std::vector<float> drawn_by(const std::string& technique, const scene::Frame& frame,
                            const CastersOnDevice* casters,
                            const std::optional<glm::vec4>& parameters = std::nullopt) {
  const techniques::TechniqueList& list = library_techniques();
  GraphRunner runner(test_device(), compile(technique_graph(list, list.find(technique), Taps::as_listed,
                                                            frame.cascades.reversed_z)));
  if (parameters) {
    UniformValues values;
    values.set(technique == "planar" ? "_PenumbraPlanarParameters0" : "_PenumbraBlobParameters0",
               *parameters);
    runner.set_parameters(values);
  }
  const CameraImage camera = camera_image(frame);
  return runner.run(FrameOnDevice(test_device(), frame, casters), &camera, kOnce).visibility[0];
}

// The height over the place of the lowest triangle of the mesh on the ray; nothing where there is none.
// Triangles in the ground do not count. The intersection is Moeller and Trumbore's, "Fast, Minimum Storage
// Ray/Triangle Intersection" (1997).
std::optional<double> lowest_hit(const scene::Mesh& mesh, const glm::dvec3& from, const glm::dvec3& along) {
  std::optional<double> lowest;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const auto corner = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[3 * i + k]]); };
    const glm::dvec3 a = corner(0), u = corner(1) - a, v = corner(2) - a;
    const glm::dvec3 p = glm::cross(along, v);
    const double determinant = glm::dot(u, p);
    if (std::abs(determinant) < 1e-12) continue;
    const glm::dvec3 s = from - a, q = glm::cross(s, u);
    const double x = glm::dot(s, p) / determinant, y = glm::dot(along, q) / determinant;
    const double height = glm::dot(v, q) / determinant * along.y;
    if (x < 0.0 || y < 0.0 || x + y > 1.0 || height < 1e-3) continue;
    if (!lowest || height < *lowest) lowest = height;
  }
  return lowest;
}

class Planar : public testing::TestWithParam<bool> {
 protected:
  static bool on_ground(const scene::Frame& frame, std::size_t pixel) {
    const glm::vec4& at = frame.receivers.position_ws[pixel];
    return at.w > 0.0F && std::abs(at.y) < 1e-4F && frame.receivers.normal_ws[pixel].y > 0.999F;
  }

  // The hit at the ground under a pixel, and 4 mm beside it in four directions; nothing where these differ.
  std::optional<std::optional<double>> traced(const scene::Frame& frame, std::size_t pixel) const {
    const glm::dvec3 at(glm::dvec2(frame.receivers.position_ws[pixel]), frame.receivers.position_ws[pixel].z);
    const glm::dvec3 sun = -glm::normalize(frame.cascades.light_direction);
    const glm::dvec3 ground(at.x, 0.0, at.z);
    const std::optional<double> here = lowest_hit(scene_.mesh, ground, sun);
    for (const glm::dvec2 side : {glm::dvec2(4e-3, 0.0), {-4e-3, 0.0}, {0.0, 4e-3}, {0.0, -4e-3}})
      if (lowest_hit(scene_.mesh, ground + glm::dvec3(side.x, 0.0, side.y), sun).has_value() !=
          here.has_value())
        return std::nullopt;
    return here;
  }

  const scene::Scene scene_ = scene::built_in("contact-boxes");
};

TEST_P(Planar, IsTheTracedShadowOfTheSunsCentreOnThePlaneAndNothingElsewhere) {
  const scene::Frame& frame = drawn("contact-boxes", 4, GetParam());
  const CastersOnDevice casters(test_device(), scene_);
  const std::vector<float> seen = drawn_by("planar", frame, &casters);
  int lit = 0, dark = 0, beside = 0, edges = 0;
  for (std::size_t pixel = 0; pixel < seen.size(); ++pixel) {
    if (!on_ground(frame, pixel)) {
      if (frame.receivers.position_ws[pixel].y < 0.5F && frame.receivers.position_ws[pixel].w > 0.0F)
        continue;
      ASSERT_EQ(seen[pixel], 1.0F) << pixel;
      ++beside;
      continue;
    }
    const auto hit = traced(frame, pixel);
    if (!hit) {
      ++edges;
      continue;
    }
    ASSERT_EQ(seen[pixel], hit->has_value() ? 0.0F : 1.0F) << pixel;
    (hit->has_value() ? dark : lit) += 1;
  }
  EXPECT_GT(lit, 1500);
  EXPECT_GT(dark, 500);
  EXPECT_GT(beside, 500);
  EXPECT_LT(edges, (lit + dark) / 10);
}

TEST_P(Planar, FadesWithTheHeightOfTheLowestCaster) {
  const scene::Frame& frame = drawn("contact-boxes", 4, GetParam());
  const CastersOnDevice casters(test_device(), scene_);
  constexpr double kFade = 2.0;
  const std::vector<float> seen =
      drawn_by("planar", frame, &casters, glm::vec4(static_cast<float>(kFade), 0.002F, 0.0F, 0.0F));
  int faded = 0, gone = 0;
  for (std::size_t pixel = 0; pixel < seen.size(); ++pixel) {
    if (!on_ground(frame, pixel)) continue;
    const auto hit = traced(frame, pixel);
    if (!hit || !hit->has_value()) continue;
    const double wanted = std::min(**hit / kFade, 1.0);
    ASSERT_NEAR(seen[pixel], wanted, 2e-3) << pixel;
    (wanted < 1.0 ? faded : gone) += 1;
  }
  EXPECT_GT(faded, 300);
  EXPECT_GT(gone, 20);
}

TEST_P(Planar, LightFromBelowCastsNothing) {
  scene::Frame frame = drawn("contact-boxes", 4, GetParam());
  frame.cascades.light_direction.y = -frame.cascades.light_direction.y;
  const CastersOnDevice casters(test_device(), scene_);
  EXPECT_THAT(drawn_by("planar", frame, &casters), testing::Each(1.0F));
}

INSTANTIATE_TEST_SUITE_P(BothDirections, Planar, testing::Bool(), direction_name);

class Blob : public testing::Test {
 protected:
  // Three balls over the ground whose shadows do not meet.
  Blob() : frame_(under_disc(drawn("contact-boxes", 4, true), 4.0)) {
    frame_.balls = {{{0.0, 1.2, 2.0}, 0.5}, {{2.4, 2.5, 4.0}, 0.7}, {{-1.0, 0.3, 0.5}, 0.3}};
  }

  // The share of rays to the sun's disc that pass the ball, and how high its lowest point is over the
  // receiver.
  double free_of(const scene::Ball& ball, const glm::dvec3& at) const {
    const glm::dvec3 sun = -glm::normalize(frame_.cascades.light_direction);
    const glm::dvec3 right = glm::normalize(glm::cross(sun, glm::dvec3(0.0, 0.0, 1.0))),
                     up = glm::cross(sun, right);
    const double half = 0.5 * frame_.cascades.angular_diameter_degrees * M_PI / 180.0;
    const glm::dvec3 towards = ball.centre - at;
    constexpr int kRings = 48;
    int free = 0;
    for (int i = 0; i < kRings; ++i)
      for (int j = 0; j < kRings; ++j) {
        const double angle = half * std::sqrt((i + 0.5) / kRings);
        const double turn = 2.0 * M_PI * (j + 0.618 * i) / kRings;
        const glm::dvec3 ray =
            std::cos(angle) * sun + std::sin(angle) * (std::cos(turn) * right + std::sin(turn) * up);
        const double along = glm::dot(ray, towards);
        const double beside = glm::dot(towards, towards) - along * along;
        free += along > 0.0 && beside < ball.radius * ball.radius ? 0 : 1;
      }
    return free / static_cast<double>(kRings * kRings);
  }

  bool receives(std::size_t pixel, const scene::Ball& ball) const {
    return std::abs(frame_.receivers.normal_ws[pixel].y) > 0.6F &&
           static_cast<double>(frame_.receivers.position_ws[pixel].y) < ball.centre.y - 1e-3;
  }

  // Whether the depth image tells the pixel's surface: it tells level ones, away from edges.
  bool is_known(std::size_t pixel) const {
    const glm::vec4& at = frame_.receivers.position_ws[pixel];
    if (!(at.w > 0.0F) || !(frame_.receivers.normal_ws[pixel].y > 0.999F)) return false;
    const auto width = static_cast<std::size_t>(frame_.receivers.width);
    for (const std::size_t other : {pixel - 1, pixel + 1, pixel - width, pixel + width}) {
      if (other >= frame_.receivers.position_ws.size()) return false;
      if (std::abs(frame_.receivers.position_ws[other].y - at.y) > 1e-3F) return false;
    }
    return true;
  }

  scene::Frame frame_;
};

TEST_F(Blob, IsTheShareOfTheSunsDiscThatRaysReach) {
  const std::vector<float> seen = drawn_by("blob", frame_, nullptr);
  int partly = 0, dark = 0, lit = 0;
  double squared = 0.0;
  for (std::size_t pixel = 0; pixel < seen.size(); ++pixel) {
    if (!is_known(pixel)) continue;
    double wanted = 1.0;
    for (const scene::Ball& ball : frame_.balls)
      if (receives(pixel, ball)) wanted *= free_of(ball, glm::dvec3(frame_.receivers.position_ws[pixel]));
    ASSERT_NEAR(seen[pixel], wanted, 0.01) << pixel;
    squared += std::pow(static_cast<double>(seen[pixel]) - wanted, 2);
    (wanted == 0.0 ? dark : wanted == 1.0 ? lit : partly) += 1;
  }
  EXPECT_GT(partly, 100);
  EXPECT_GT(dark, 100);
  EXPECT_GT(lit, 1000);
  EXPECT_LT(std::sqrt(squared / (partly + dark + lit)), 1e-3);
}

TEST_F(Blob, FadesWithItsHeight) {
  const std::vector<float> seen = drawn_by("blob", frame_, nullptr);
  constexpr double kFade = 2.0;
  const std::vector<float> faded =
      drawn_by("blob", frame_, nullptr, glm::vec4(static_cast<float>(kFade), 0.0F, 0.0F, 0.0F));
  int weaker = 0;
  for (std::size_t pixel = 0; pixel < seen.size(); ++pixel) {
    if (!is_known(pixel) || seen[pixel] == 1.0F) continue;
    const glm::dvec3 at(frame_.receivers.position_ws[pixel]);
    double wanted = 1.0;
    for (const scene::Ball& ball : frame_.balls) {
      if (!receives(pixel, ball)) continue;
      const double height = std::max(ball.centre.y - ball.radius - at.y, 0.0);
      wanted *= 1.0 - (1.0 - std::min(height / kFade, 1.0)) * (1.0 - free_of(ball, at));
    }
    ASSERT_NEAR(faded[pixel], wanted, 0.01) << pixel;
    weaker += faded[pixel] > seen[pixel] + 0.1F ? 1 : 0;
  }
  EXPECT_GT(weaker, 50);
}

TEST_F(Blob, WithoutBallsAllIsLit) {
  frame_.balls.clear();
  EXPECT_THAT(drawn_by("blob", frame_, nullptr), testing::Each(1.0F));
}

}  // namespace
}  // namespace penumbra::resolve
