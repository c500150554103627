#include "reference/trace_visibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "input/input_error.h"
#include "reference/disc_tracer.h"
#include "reference/hand_built.h"

namespace penumbra::reference {
namespace {

using hand_built::Setting;

constexpr double gap = 3.0;
const Setting default_setting{};

// The receivers lie across the whole penumbra of an edge whose shadow falls on the centre, with the blocker
// to the left.
struct EdgeCase {
  scene::Scene scene;
  scene::Receivers receivers;
  double radius;

  explicit EdgeCase(const Setting& setting = {}, ImageSize size = {64, 16}) {
    radius = gap * setting.tan_half();
    hand_built::add_rectangle(scene.mesh, setting, {-40.0, 0.0, -40.0, 40.0}, gap);
    receivers = hand_built::receivers(setting, size,
                                      [&](int x, int y) { return glm::dvec2(distance(x, size), 0.05 * y); });
  }
  double distance(int x, ImageSize size = {64, 16}) const {
    return radius * 1.2 * (2.0 * (x + 0.5) / size.width - 1.0);
  }
};

double rms_error(const EdgeCase& edge, const VisibilityImage& image, const Setting& setting = {}) {
  double squares = 0.0;
  int pixels = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double exact = hand_built::visible_past_edge(edge.distance(x), gap, setting.tan_half());
      if (exact <= 0.02 || exact >= 0.98) continue;
      const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width);
      const double error = image.visibility[pixel + static_cast<std::size_t>(x)] - exact;
      squares += error * error;
      ++pixels;
    }
  }
  return std::sqrt(squares / pixels);
}

TEST(TraceVisibility, StraightEdgeIsTheCircularSegment) {
  for (const double degrees : {0.53, 5.0, 30.0}) {
    Setting setting;
    setting.light.angular_diameter_degrees = degrees;
    const EdgeCase edge(setting);
    const VisibilityImage image = trace_visibility(edge.scene, edge.receivers, setting.light);
    EXPECT_EQ(image.samples, 1024);
    for (int x = 0; x < image.width; ++x) {
      const double exact = hand_built::visible_past_edge(edge.distance(x), gap, setting.tan_half());
      EXPECT_NEAR(image.visibility[static_cast<std::size_t>(x)], exact, 6.0 * image.noise_floor)
          << degrees << " degrees, pixel " << x;
    }
  }
}

TEST(TraceVisibility, StatedNoiseFloorIsTheErrorAgainstTheExactEdge) {
  const EdgeCase edge;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const VisibilityImage image =
        trace_visibility(edge.scene, edge.receivers, default_setting.light, {1024, seed});
    const double error = rms_error(edge, image);
    EXPECT_GT(image.noise_floor, 0.8 * error) << "seed " << seed;
    EXPECT_LT(image.noise_floor, 1.25 * error) << "seed " << seed;
    EXPECT_LT(error, 0.004) << "random points would have 0.012";
  }
}

TEST(TraceVisibility, NoiseFallsFasterThanRandomSampling) {
  const EdgeCase edge;
  const auto error = [&](int samples) {
    return rms_error(edge, trace_visibility(edge.scene, edge.receivers, default_setting.light, {samples, 1}));
  };
  // An error of n^(-3/4) falls by a factor 8 over 16 times the samples; that of random points would fall by
  // 4.
  EXPECT_GT(error(256) / error(4096), 5.5);
}

// Neighbours that draw the same pair of sets must still not make the same errors.
TEST(TraceVisibility, EveryPixelTurnsItsPoints) {
  const Setting setting;
  scene::Scene scene;
  hand_built::add_rectangle(scene.mesh, setting, {-40.0, 0.0, -40.0, 40.0}, gap);
  const DiscLight disc = setting.disc();
  const EmbreeScene embree(scene);
  const DiscTracer tracer(embree, disc, 1024, 1);
  const DiscSamples samples(1024, 1);
  const LitReceiver receiver{setting.at(0.2 * gap * disc.tan_half, 0.0, 0.001), disc.to_light};
  std::set<std::pair<int, int>> answers;
  int pixels = 0;
  for (std::size_t pixel = 0; pixels < 50; ++pixel) {
    if (samples.draw(pixel).pair != 7) continue;
    const HalfCounts lit = tracer.lit_points(receiver, pixel);
    answers.emplace(lit.first, lit.second);
    ++pixels;
  }
  EXPECT_GT(answers.size(), 10U) << "of 50 pixels with the same pair";
}

TEST(TraceVisibility, CircularBlockerHidesItsShareOfTheDisc) {
  const Setting setting;
  const double radius = gap * setting.tan_half();
  const scene::Receivers at_centre =
      hand_built::receivers(setting, {16, 16}, [](int, int) { return glm::dvec2(0.0); });
  for (const double share : {0.3, 0.7, 0.95}) {
    scene::Scene scene;
    hand_built::add_circle(scene.mesh, setting, share * radius, gap);
    const VisibilityImage image = trace_visibility(scene, at_centre, setting.light);
    double mean = 0.0;
    for (const float visibility : image.visibility) mean += visibility / 256.0;
    EXPECT_NEAR(mean, 1.0 - share * share, 0.001) << "blocker of " << share << " of the disc";
  }
}

TEST(TraceVisibility, PointLightIsAllOrNothing) {
  Setting setting;
  setting.light.angular_diameter_degrees = 0.0;
  scene::Scene scene;
  hand_built::add_rectangle(scene.mesh, setting, {-9.0, 0.0, -9.0, 9.0}, gap);
  const scene::Receivers receivers = hand_built::receivers(
      setting, {20, 1}, [](int x, int) { return glm::dvec2(0.01 * (x - 10) + 0.005, 0.0); });
  double rays = 0.0;
  RunOptions run;
  run.progress = [&](double, double total) { rays = total; };
  const VisibilityImage image = trace_visibility(scene, receivers, setting.light, {}, run);
  for (int x = 0; x < 20; ++x) EXPECT_EQ(image.visibility[static_cast<std::size_t>(x)], x < 10 ? 0.0F : 1.0F);
  EXPECT_EQ(rays, 20.0);
  EXPECT_EQ(image.noise_floor, 0.0);
}

TEST(TraceVisibility, NothingAboveIsLitAndEverythingAboveIsDark) {
  const Setting setting;
  const scene::Receivers receivers =
      hand_built::receivers(setting, {9, 9}, [](int x, int y) { return glm::dvec2(0.3 * x, 0.3 * y); });
  scene::Scene scene;
  for (const float visibility : trace_visibility(scene, receivers, setting.light).visibility) {
    EXPECT_EQ(visibility, 1.0F);
  }
  // The receivers' own plane does not shade them, however far from the origin they are.
  hand_built::add_rectangle(scene.mesh, setting, {-90.0, 90.0, -90.0, 90.0}, 0.0);
  for (const float visibility : trace_visibility(scene, receivers, setting.light).visibility) {
    EXPECT_EQ(visibility, 1.0F);
  }
  hand_built::add_rectangle(scene.mesh, setting, {-90.0, 90.0, -90.0, 90.0}, gap);
  for (const float visibility : trace_visibility(scene, receivers, setting.light).visibility) {
    EXPECT_EQ(visibility, 0.0F);
  }
}

// A plane through points of single precision hundreds of metres off is itself rounded: receivers on it must
// still not shade themselves.
TEST(TraceVisibility, SlopedGroundFarOffDoesNotShadeItself) {
  Setting setting;
  setting.light = {{0.9, -0.3, 0.2}, 5.0};
  scene::Scene scene;
  scene.mesh.positions = {{-700.0F, 90.0F, -700.0F}, {900.0F, 30.0F, -600.0F}, {100.0F, 60.0F, 900.0F}};
  scene.mesh.indices = {0, 1, 2};
  const glm::dvec3 a(scene.mesh.positions[0]);
  const glm::dvec3 b(scene.mesh.positions[1]);
  const glm::dvec3 c(scene.mesh.positions[2]);
  glm::dvec3 normal = glm::normalize(glm::cross(c - a, b - a));
  if (normal.y < 0.0) normal = -normal;
  scene::Receivers receivers =
      hand_built::receivers(setting, {16, 16}, [](int, int) { return glm::dvec2(0.0); });
  for (int pixel = 0; pixel < 256; ++pixel) {
    const double u = (pixel % 16 + 0.5) / 40.0;
    const int row = pixel / 16;
    const double v = (row + 0.5) / 40.0;
    const glm::vec4 position(glm::vec3(a + u * (b - a) + v * (c - a)), 1.0F);
    receivers.position_relative[static_cast<std::size_t>(pixel)] = position;
    receivers.normal_ws[static_cast<std::size_t>(pixel)] = glm::vec4(glm::vec3(normal), 0.0F);
  }
  const VisibilityImage image = trace_visibility(scene, receivers, setting.light);
  for (std::size_t pixel = 0; pixel < 256; ++pixel) {
    ASSERT_EQ(image.valid[pixel], 1);
    EXPECT_EQ(image.visibility[pixel], 1.0F) << "pixel " << pixel;
  }
}

TEST(TraceVisibility, UnusablePixelsAreNotReceivers) {
  const Setting setting;
  const DiscLight disc = setting.disc();
  scene::Receivers receivers =
      hand_built::receivers(setting, {8, 1}, [](int x, int) { return glm::dvec2(x, 0.0); });
  // a normal whose cosine to the light is the sine of this angle.
  const auto tilted = [&](double above_horizon) {
    return glm::vec4(glm::vec3(std::sqrt(1.0 - above_horizon * above_horizon) * disc.right +
                               above_horizon * disc.to_light),
                     0.0F);
  };
  receivers.position_ws[0].w = 0.0F;
  receivers.position_relative[1].y = std::numeric_limits<float>::quiet_NaN();
  receivers.position_relative[2].x = std::numeric_limits<float>::infinity();
  receivers.normal_ws[3] = glm::vec4(0.0F);
  receivers.normal_ws[4] = -receivers.normal_ws[4];
  receivers.normal_ws[5] = tilted(disc.sin_half * 0.99);
  receivers.normal_ws[6] = tilted(disc.sin_half * 1.01);
  scene::Scene scene;
  hand_built::add_rectangle(scene.mesh, setting, {-90.0, 90.0, -90.0, 90.0}, gap);
  const VisibilityImage image = trace_visibility(scene, receivers, setting.light);
  EXPECT_EQ(image.valid, (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 1, 1}));
  for (std::size_t pixel = 0; pixel < 6; ++pixel) EXPECT_EQ(image.visibility[pixel], 1.0F);
  EXPECT_EQ(image.visibility[7], 0.0F);
}

TEST(TraceVisibility, SameBytesFromEveryNumberOfThreads) {
  const EdgeCase edge;
  RunOptions one;
  one.jobs = 1;
  const VisibilityImage expected =
      trace_visibility(edge.scene, edge.receivers, default_setting.light, {}, one);
  for (const int jobs : {2, 3, 8, 0}) {
    RunOptions run;
    run.jobs = jobs;
    EXPECT_EQ(trace_visibility(edge.scene, edge.receivers, default_setting.light, {}, run), expected)
        << jobs << " jobs";
  }
  EXPECT_NE(trace_visibility(edge.scene, edge.receivers, default_setting.light, {1024, 2}), expected);
}

TEST(TraceVisibility, BadInputSaysWhatIsWrong) {
  const EdgeCase edge;
  const scene::Scene& scene = edge.scene;
  for (const int samples : {0, -1, 16, 1000, 131072}) {
    EXPECT_THROW(trace_visibility(scene, edge.receivers, default_setting.light, {samples, 1}), InputError)
        << samples;
  }
  EXPECT_THROW(trace_visibility(scene, edge.receivers, {{0.0, 0.0, 0.0}, 1.0}), InputError);
  EXPECT_THROW(trace_visibility(scene, edge.receivers, {{0.0, NAN, 0.0}, 1.0}), InputError);
  EXPECT_THROW(trace_visibility(scene, edge.receivers, {{0.0, -1.0, 0.0}, 31.0}), InputError);
  EXPECT_THROW(trace_visibility(scene, edge.receivers, {{0.0, -1.0, 0.0}, NAN}), InputError);
  scene::Receivers fewer = edge.receivers;
  fewer.normal_ws.pop_back();
  EXPECT_THROW(trace_visibility(scene, fewer, default_setting.light), InputError);
  scene::Scene broken = scene;
  broken.mesh.indices.back() = 1000;
  EXPECT_THROW(trace_visibility(broken, edge.receivers, default_setting.light), InputError);
}

}  // namespace
}  // namespace penumbra::reference
