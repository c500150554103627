// Compares the width of a penumbra in the shader with geometry: a half-plane blocker g metres above a
// receiver, both facing the light, makes an edge that goes from 0 to 1 over 2 tan(a/2) g metres, in every
// cascade and for both depth directions. HDRP's scale, twice as large, must fail the same cases.
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <random>

#include "resolve/graph_runner.h"
#include "resolve/synthetic_frame.h"
#include "resolve/test_device.h"

namespace penumbra::resolve {
namespace {

using testing_frames::FrameSetup;
using testing_frames::TilePoint;

constexpr int kSetups = 1000;
constexpr int kReceivers = 256;
constexpr int kTileTexels = 256;
constexpr double kPi = 3.14159265358979323846;

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

glm::dvec3 direction(std::mt19937& random, double lowest_elevation_degrees) {
  const double elevation = uniform(random, lowest_elevation_degrees, 90.0) * kPi / 180.0;
  const double azimuth = uniform(random, 0.0, 2.0 * kPi);
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
          std::cos(elevation) * std::cos(azimuth)};
}

struct EdgeCase {
  FrameSetup setup;
  scene::Frame frame;
  double expected_width = 0.0;  // metres: 2 tan(a/2) g
  double texel = 0.0;           // metres
  double spacing = 0.0;         // metres between receivers
  std::string description;
};

constexpr double kNarrowestTexels = 8.0;

// The widest penumbra, metres: 60 texels, or what 85 % of the depth range can make.
double widest_penumbra(const FrameSetup& setup, const parameters::Cascade& cascade) {
  const double tan_half = std::tan(setup.light.angular_diameter_degrees * kPi / 360.0);
  return std::min(60.0 * cascade.texel_size_metres, 2.0 * tan_half * 0.85 / cascade.depth_per_metre);
}

FrameSetup random_setup(std::mt19937& random, int index) {
  FrameSetup setup;
  setup.camera.position = {uniform(random, -100, 100), uniform(random, 1, 30), uniform(random, -100, 100)};
  const glm::dvec3 look = direction(random, -60.0);
  setup.camera.forward = {look.x, 0.9 * look.y, look.z + 0.01};
  setup.camera.fov_y_degrees = uniform(random, 30, 90);
  setup.light.direction = -direction(random, 5.0);
  setup.light.angular_diameter_degrees = uniform(random, 0.5, 10.0);
  setup.shadows.cascades = 4;
  setup.shadows.resolution = 2 * kTileTexels;
  setup.shadows.distance_metres = uniform(random, 20, 150);
  setup.shadows.reversed_z = index % 2 == 0;
  setup.cascade = index / 2 % 4;
  return setup;
}

parameters::Cascade fitted_cascade(const FrameSetup& setup) {
  const parameters::CascadeSet set = parameters::fit_cascades(setup.camera, setup.light, setup.shadows);
  return set.cascades[static_cast<std::size_t>(setup.cascade)];
}

// A random camera, light, cascade and gap whose penumbra is 8 to 60 texels wide and fits its tile. A light
// too small for that is drawn again.
EdgeCase random_case(std::mt19937& random, int index) {
  EdgeCase edge;
  FrameSetup& setup = edge.setup;
  setup = random_setup(random, index);
  while (widest_penumbra(setup, fitted_cascade(setup)) <
         kNarrowestTexels * fitted_cascade(setup).texel_size_metres) {
    setup = random_setup(random, index);
  }
  const parameters::Cascade cascade = fitted_cascade(setup);
  const double tan_half = std::tan(setup.light.angular_diameter_degrees * kPi / 360.0);
  edge.texel = cascade.texel_size_metres;
  const double range = 1.0 / cascade.depth_per_metre;
  edge.expected_width = uniform(random, kNarrowestTexels * edge.texel, widest_penumbra(setup, cascade));
  const double gap = edge.expected_width / (2.0 * tan_half);

  // The distances are from the light's end, as shares of the depth range.
  const double receiver = uniform(random, gap / range + 0.02, 0.98);
  const auto stored = [&](double d) { return setup.shadows.reversed_z ? 1.0 - d : d; };
  const auto blocker = static_cast<float>(stored(receiver - gap / range));
  const float empty = testing_frames::farthest_depth(setup.shadows.reversed_z);
  const int edge_texel = kTileTexels / 2 + static_cast<int>(random() % 32) - 16;
  const bool across = random() % 2 == 0;
  const auto map = [=](double u, double v, int tile) {
    return tile == setup.cascade && (across ? u : v) * kTileTexels < edge_texel ? blocker : empty;
  };

  const double span = 1.4 * edge.expected_width;
  edge.spacing = span / kReceivers;
  std::vector<TilePoint> points;
  for (int i = 0; i < kReceivers; ++i) {
    const double metres = (i + 0.5) * edge.spacing - 0.5 * span;
    const double along = static_cast<double>(edge_texel) / kTileTexels + metres * cascade.uv_per_metre;
    points.emplace_back(across ? along : 0.5, across ? 0.5 : along, stored(receiver));
  }
  edge.frame = testing_frames::make_frame(setup, map, points, kReceivers);
  edge.description = "set-up " + std::to_string(index) + ", cascade " + std::to_string(setup.cascade) +
                     (setup.shadows.reversed_z ? ", reversed Z" : ", conventional Z") + ", penumbra of " +
                     std::to_string(edge.expected_width / edge.texel) + " texels";
  return edge;
}

// The metres over which the visibility is neither 0 nor 1.
double measured_width(const std::vector<float>& visibility, double spacing) {
  int partial = 0;
  for (const float v : visibility) partial += v > 0.0f && v < 1.0f ? 1 : 0;
  return partial * spacing;
}

std::vector<glm::vec4> tile_scales(const scene::Frame& frame, float radial_factor) {
  std::vector<glm::vec4> scales;
  for (const parameters::Cascade& cascade : frame.cascades.cascades) {
    scales.emplace_back(cascade.uv_per_metre, cascade.depth_per_metre,
                        radial_factor * cascade.depth_to_radial,
                        cascade.radial_to_depth.value_or(0.0) / radial_factor);
  }
  return scales;
}

class GeometricScale : public testing::Test {
 protected:
  // Limits that are there for speed or looks are lifted, so that geometry alone decides.
  static std::array<GraphRunner, 2> unlimited_passes() {
    const techniques::TechniqueList& list = library_techniques();
    techniques::Technique technique = list.find("pcss-angular-64-64");
    technique.unlimited["maxPenumbraMetres"] = 1e4;
    technique.unlimited["maxSamplingMetres"] = 1e4;
    const auto pass = [&](bool reversed_z) {
      return GraphRunner(test_device(),
                         compile(technique_shader(list, technique, Taps::unlimited, reversed_z)));
    };
    return {pass(false), pass(true)};
  }
};

TEST_F(GeometricScale, PenumbraWidthIsTwiceTanHalfTimesTheGap) {
  std::array<GraphRunner, 2> passes = unlimited_passes();
  std::mt19937 random(1);
  double worst = 0.0;
  int hdrp_within = 0;
  for (int index = 0; index < kSetups; ++index) {
    const EdgeCase edge = random_case(random, index);
    ASSERT_GE(edge.expected_width, kNarrowestTexels * edge.texel) << edge.description;
    const FrameOnDevice frame(test_device(), edge.frame);
    GraphRunner& pass = passes[edge.setup.shadows.reversed_z ? 1 : 0];
    const auto width = [&](float radial_factor) {
      UniformValues scales;
      scales.set("_PenumbraTileScales", std::span<const glm::vec4>(tile_scales(edge.frame, radial_factor)));
      pass.set_parameters(scales);
      const RunOptions once{.noise_seeds = 1, .first_seed = index, .timing_repeats = 0};
      return measured_width(pass.run(frame, once).visibility.front(), edge.spacing);
    };
    const double tolerance = std::max(edge.texel, 0.03 * edge.expected_width);
    const double error = std::abs(width(1.0f) - edge.expected_width);
    worst = std::max(worst, error / tolerance);
    EXPECT_LE(error, tolerance) << edge.description;
    hdrp_within += std::abs(width(2.0f) - edge.expected_width) <= tolerance ? 1 : 0;
  }
  RecordProperty("worst_share_of_tolerance", std::to_string(worst));
  EXPECT_EQ(hdrp_within, 0) << "HDRP's scale, twice the geometric one, passed";
}

}  // namespace
}  // namespace penumbra::resolve
