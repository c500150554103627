// Compares FilterPcssSpot with the share of a disc that an edge hides, and with its sums in double.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "resolve/kept_runners.h"
#include "resolve/run_once.h"
#include "resolve/spot_frame.h"
#include "resolve/spot_transcription.h"

namespace penumbra::resolve {
namespace {

using testing_frames::grid;
using testing_frames::kColumns;
using testing_frames::kReceiver;
using testing_frames::lamp;
using testing_frames::positions;
using testing_frames::SpotPoint;
using testing_frames::SpotSetup;
using testing_frames::world_position;

// Runs FilterPcssSpot alone.
class SpotFilter : public testing::TestWithParam<bool> {
 protected:
  GraphResult resolve(const SpotSetup& setup, const scene::Frame& frame, int samples, int seeds) const {
    techniques::Technique technique = library_techniques().find("pcss-spot-24-16");
    technique.values.at("blockerSamples") = technique.values.at("filterSamples") = {double(samples)};
    ShadowGraph graph = testing_frames::spot_graph(technique, GetParam());
    graph.parameters.merge(slice_uniforms(setup));
    GraphRunner runner(test_device(), compile(graph));
    return runner.run(FrameOnDevice(test_device(), frame),
                      {.noise_seeds = seeds, .first_seed = 0, .timing_repeats = 0, .count_fetches = true});
  }
};

std::vector<double> means(const GraphResult& result) {
  std::vector<double> sums(result.visibility.front().size(), 0.0);
  for (const std::vector<float>& seen : result.visibility)
    for (std::size_t i = 0; i < seen.size(); ++i)
      sums[i] += seen[i] / static_cast<double>(result.visibility.size());
  return sums;
}

// One caster has a straight edge: visibility is the share of the source's disc beyond the edge.
double half_plane(double distance_in_radii) {
  const double d = std::clamp(distance_in_radii, -1.0, 1.0);
  return 0.5 + (std::asin(d) + d * std::sqrt(1.0 - d * d)) / std::numbers::pi;
}

// The edges go through a place of the slice, across the way to the axis and along it. There the source, which
// faces the receiver, makes the penumbra in the map 1 / cos as wide, and as wide as on the axis.
TEST_P(SpotFilter, APenumbraIsAsWideAsSimilarTrianglesSay) {
  constexpr double kBlocker = 2.4;
  for (const double outer : {40.0, 110.0}) {
    for (const double u : {0.5, 0.86}) {
      for (const bool across : {true, false}) {
        SpotSetup at = lamp(GetParam());
        at.slice_texels = 512;
        at.light.outer_angle_degrees = outer;
        at.light.source_radius_metres = outer > 90.0 ? 0.25 : 0.06;
        const parameters::SpotShadow shadow = at.shadow();
        const double v = 0.5 + 0.2 / at.slice_texels;
        const double tangent = (u - 0.5) / shadow.uv_per_tangent;
        const double radius = penumbra_radius_metres(shadow.light, kReceiver, kBlocker) *
                              shadow.uv_per_tangent / kReceiver *
                              (across ? std::sqrt(1.0 + tangent * tangent) : 1.0);
        ASSERT_GT(radius * at.slice_texels, 4.0) << "a penumbra that the map resolves";
        const auto blocker = static_cast<float>(shadow.stored_depth(kBlocker));
        const float nothing = testing_frames::farthest_depth(GetParam());
        const auto map = [=](double x, double y, int) {
          return (across ? x < u : y < v) ? blocker : nothing;
        };
        // The edge lies between texels, half a texel or less from u or v.
        const double edge = std::round((across ? u : v) * at.slice_texels) / at.slice_texels;
        std::vector<SpotPoint> points;
        std::vector<double> exact;
        for (int i = 0; i < 31; ++i) {
          const double place = (i - 15) / 16.0;  // place in radii
          points.emplace_back(across ? edge + place * radius : u, across ? v : edge + place * radius,
                              kReceiver);
          exact.push_back(half_plane(place));
        }
        const scene::Frame frame =
            testing_frames::make_spot_frame(at, map, positions(at, points), static_cast<int>(points.size()));
        const std::vector<double> seen = means(resolve(at, frame, 64, 16));
        double squared = 0.0;
        for (std::size_t i = 0; i < seen.size(); ++i) {
          squared += (seen[i] - exact[i]) * (seen[i] - exact[i]);
          EXPECT_NEAR(seen[i], exact[i], 0.06)
              << outer << " degrees, u " << u << (across ? ", across, " : ", along, ") << points[i].x;
        }
        EXPECT_LE(std::sqrt(squared / static_cast<double>(seen.size())), 0.03)
            << outer << " degrees, u " << u << (across ? ", across" : ", along");
      }
    }
  }
}

// NaN stands alone and scattered among what blocks.
TEST_P(SpotFilter, NaNDoesNotBlock) {
  const SpotSetup at = lamp(GetParam());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float behind = testing_frames::farthest_depth(GetParam());
  const auto nowhere = [nan](double, double, int) { return nan; };
  const auto some = [=](double u, double v, int) {
    return int(u * 256.0) % 3 == int(v * 256.0) % 2 ? nan : behind;
  };
  for (const testing_frames::TexelDepth& map :
       {testing_frames::TexelDepth(nowhere), testing_frames::TexelDepth(some)}) {
    const scene::Frame frame =
        testing_frames::make_spot_frame(at, map, positions(at, grid(kReceiver)), kColumns);
    EXPECT_THAT(resolve(at, frame, 24, 1).visibility.front(), testing::Each(1.0F));
  }
}

// A floor seen at a slant is its own caster: its map holds its own depths.
TEST_P(SpotFilter, ASlantedSurfaceDoesNotShadowItself) {
  for (const double radius : {0.01, 0.3}) {
    SpotSetup at = lamp(GetParam());
    at.light.source_radius_metres = radius;
    const parameters::SpotShadow shadow = at.shadow();
    const glm::dvec3 normal = glm::normalize(-shadow.light.direction + glm::dvec3(0.25, 0.1, 0.2));
    const glm::dvec3 on_plane = at.light.position + 4.0 * shadow.light.direction;
    const auto metres_at = [&](double u, double v) {  // distance where the ray of that place meets the plane
      const glm::dvec3 ray = world_position(shadow, {u, v, 1.0}) - at.light.position;
      return glm::dot(on_plane - at.light.position, normal) / glm::dot(ray, normal);
    };
    const auto map = [&](double u, double v, int) {
      return static_cast<float>(shadow.stored_depth(std::min(metres_at(u, v) + 0.002, 8.99)));
    };
    std::vector<SpotPoint> points;
    for (const SpotPoint& point : grid(1.0)) {
      const double metres = metres_at(point.x, point.y);
      points.emplace_back(point.x, point.y, metres);
      ASSERT_LT(metres, 8.9) << "the plane lies in the map";
    }
    const scene::Frame frame =
        testing_frames::make_spot_frame(at, map, positions(at, points), kColumns, normal);
    for (const std::vector<float>& seen : resolve(at, frame, 24, 2).visibility)
      EXPECT_THAT(seen, testing::Each(1.0F)) << radius;
  }
}

// The fields of the harness's receivers, one component at a time.
std::vector<float> told(const SpotSetup& setup, const FrameOnDevice& frame, const std::string& component) {
  const techniques::Technique& technique = library_techniques().find("pcss-spot-24-16");
  ShadowShader shader = technique_shader(library_techniques(), technique, Taps::as_listed, setup.reversed_z,
                                         techniques::LightKind::spot);
  shader.body =
      "#include \"Platform/Platform.hlsl\"\n#include \"Core/ShadowStructs.hlsl\"\n"
      "float ResolveTechnique(ShadowReceiver receiver, ShadowTile tile, int cascade) { return receiver." +
      component + "; }\n";
  shader.parameters = {};
  ShadowGraph graph = filter_graph(shader);
  graph.parameters.merge(slice_uniforms(setup));
  GraphRunner runner(test_device(), compile(graph));
  return runner.run(frame, kOnce).visibility.front();
}

// Boards, poles and a rough ground are at many heights, and receivers everywhere on a slanted plane; the sums
// are the same in double.
TEST_P(SpotFilter, IsWhatItsDescriptionSays) {
  SpotSetup at = lamp(GetParam());
  at.light.source_radius_metres = 0.15;
  at.slice = 2;
  const parameters::SpotShadow shadow = at.shadow();
  const auto metres = [](int x, int y) {
    const unsigned hash = (unsigned(x / 5) * 2654435761U) ^ (unsigned(y / 7) * 2246822519U);
    const double rough = 0.01 * ((unsigned(x) * 97U + unsigned(y) * 57U) % 11U);
    if (hash % 11U == 0U) return 1.5 + rough;
    if (hash % 5U == 0U) return 3.7 + rough;
    return x % 41 < 2 ? 2.5 : 4.3 + rough;
  };
  const int n = at.slice_texels;
  const auto texel = [&](int x, int y) { return static_cast<float>(shadow.stored_depth(metres(x, y))); };
  const auto map = [&](double u, double v, int slice) {
    return slice == at.slice ? texel(int(u * n), int(v * n)) : 0.5F;
  };
  const glm::dvec3 normal = glm::normalize(-shadow.light.direction + glm::dvec3(0.1, 0.05, 0.1));
  const scene::Frame frame =
      testing_frames::make_spot_frame(at, map, positions(at, grid(kReceiver)), kColumns, normal);
  const FrameOnDevice on_device(test_device(), frame);
  std::map<std::string, std::vector<float>> receivers;
  for (const char* component : {"shadowCoord.x", "shadowCoord.y", "shadowCoord.z", "depthGradient.x",
                                "depthGradient.y", "rotation.x", "rotation.y"})
    receivers[component] = told(at, on_device, component);

  techniques::Technique technique = library_techniques().find("pcss-spot-24-16");
  ShadowGraph graph = testing_frames::spot_graph(technique, GetParam());
  graph.parameters.merge(slice_uniforms(at));
  GraphRunner runner(test_device(), compile(graph));
  const std::vector<float> seen = runner.run(on_device, kOnce).visibility.front();

  testing_spot::Filter filter({0.3, 9.0, 0.5 / shadow.uv_per_tangent, 0.15}, {24, 16, 1.25, 100.0}, n,
                              GetParam(), texel);
  std::size_t apart = 0, between = 0;
  double difference = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto of = [&](const char* name) { return double(receivers.at(name)[i]); };
    testing_spot::Receiver receiver{{of("shadowCoord.x"), of("shadowCoord.y")},
                                    of("shadowCoord.z"),
                                    {of("depthGradient.x"), of("depthGradient.y")},
                                    {of("rotation.x"), of("rotation.y")}};
    receiver.uv = (receiver.uv - glm::dvec2(0.0, 0.5)) * 2.0;  // from the atlas into the slice
    receiver.gradient *= 0.5;
    const double wanted = filter.visibility(receiver);
    between += wanted > 0.02 && wanted < 0.98;
    // A texel that lies on a threshold may fall to either side by rounding.
    apart += std::fabs(seen[i] - wanted) > 1e-3;
    difference += std::fabs(seen[i] - wanted);
  }
  EXPECT_GT(between, seen.size() / 3) << "penumbrae enough to tell filters apart";
  EXPECT_LE(apart, seen.size() / 50);
  EXPECT_LE(difference / double(seen.size()), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Depth, SpotFilter, testing::Bool(), direction_name);

}  // namespace
}  // namespace penumbra::resolve
