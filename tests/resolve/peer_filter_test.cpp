// Compares the filters that follow other engines' rules with those rules in double precision
// (peer_references.h): visibility and fetches of every receiver of a slanted surface below casters of several
// heights, both directions of depth.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "as_identifier.h"
#include "resolve/graph_runner.h"
#include "resolve/peer_references.h"
#include "resolve/synthetic_frame.h"
#include "resolve/test_device.h"

namespace penumbra::resolve {
namespace {

using testing_peers::Answer;
using testing_peers::dvec2;
using testing_peers::dvec3;
using testing_peers::Receiver;
using testing_peers::Shift;
using testing_peers::Tile;

constexpr int kColumns = 48;
constexpr int kCascade = 1;
constexpr double kDegrees = 10.0;

// The shader's positions are floats, and its noise is a fraction of 53 times a float.
constexpr double kTexelError = 1e-4;
constexpr double kDepthError = 2e-6;
constexpr double kNoiseError = 1e-5;

struct Peer {
  std::string technique;
  std::function<Answer(const Tile&, const Receiver&, const Shift&)> answer;
  int least_fetches;
  int most_fetches;
  bool soft = true;  // its penumbrae are wider than a texel here
};

Peer godot_peer(const std::string& name, int samples, double degrees) {
  return {name,
          [=](const Tile& tile, const Receiver& receiver, const Shift& shift) {
            return testing_peers::godot(tile, receiver, shift,
                                        {.samples = samples, .angular_size_degrees = degrees});
          },
          samples, 2 * samples};
}

// With bulb_metres 0 the bulb is as wide as the light's disc at half the depth range.
Peer filament_peer(const std::string& name, int search, int filter, double bulb_metres) {
  return {name,
          [=](const Tile& tile, const Receiver& receiver, const Shift& shift) {
            const double bulb = bulb_metres > 0.0 ? bulb_metres : 0.5 * tile.tan_half * tile.range;
            return testing_peers::filament(
                tile, receiver, shift,
                {.search_taps = search, .filter_taps = filter, .bulb_radius_metres = bulb});
          },
          search, search + filter, bulb_metres == 0.0};
}

std::vector<Peer> peers() {
  return {{"unreal-smrt-7-8",
           [](const Tile& tile, const Receiver& receiver, const Shift& shift) {
             return testing_peers::smrt(tile, receiver, shift, {});
           },
           1, 7 * 9},  // samples beside the tile cost nothing
          godot_peer("godot-pcss-8", 8, kDegrees),
          godot_peer("godot-pcss-8-half-diameter", 8, 0.5 * kDegrees),
          godot_peer("godot-pcss-32", 32, kDegrees),
          filament_peer("filament-pcss-16-16", 16, 16, 0.0),
          filament_peer("filament-pcss-16-16-bulb", 16, 16, 0.02),
          filament_peer("filament-dpcf-12", 12, 0, 0.0),
          filament_peer("filament-dpcf-12-bulb", 12, 0, 0.02)};
}

struct Case {
  Peer peer;
  bool reversed_z;
};

void PrintTo(const Case& value, std::ostream* stream) {
  *stream << value.peer.technique << (value.reversed_z ? ", reversed Z" : ", conventional Z");
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const Peer& peer : peers())
    for (const bool reversed_z : {true, false}) cases.push_back({peer, reversed_z});
  return cases;
}

// The distances are from the near plane, 0 to 1: the receivers' surface, and two casters above parts of it.
double surface_at(double u, double v) {
  return 0.62 + 0.05 * u - 0.03 * v;
}

double nearest_at(double u, double v) {
  if (u > 0.55 && v < 0.5) return 0.4 + 0.02 * v;
  if (u < 0.3 && v > 0.4 && v < 0.8) return surface_at(u, v) - 0.06;
  return surface_at(u, v);
}

class PeerFilters : public testing::TestWithParam<Case> {
 protected:
  double stored(double distance) const { return GetParam().reversed_z ? 1.0 - distance : distance; }

  scene::Frame frame() const {
    testing_frames::FrameSetup setup;
    setup.shadows.resolution = 256;
    setup.shadows.cascades = 4;
    setup.shadows.reversed_z = GetParam().reversed_z;
    setup.shadows.depth_range_metres = 60.0;
    setup.light.angular_diameter_degrees = kDegrees;
    setup.cascade = kCascade;
    std::vector<testing_frames::TilePoint> points;
    for (int i = 0; i < kColumns * kColumns; ++i) {
      const double u = 0.004 + 0.992 * (i % kColumns) / (kColumns - 1.0);
      const double v = 0.004 + 0.992 * (i / kColumns) / (kColumns - 1.0);
      points.emplace_back(u, v, stored(surface_at(u, v)));
    }
    scene::Frame made = testing_frames::make_frame(
        setup, [this](double u, double v, int) { return static_cast<float>(stored(nearest_at(u, v))); },
        points, kColumns);
    for (glm::vec4& normal : made.receivers.normal_ws) normal = glm::vec4(surface_normal(made), 0.0F);
    return made;
  }

  glm::dvec3 surface_normal(const scene::Frame& made) const {
    const parameters::Cascade& cascade = made.cascades.cascades[kCascade];
    const auto point = [&](double u, double v) {
      return testing_frames::world_position(cascade, {u, v, stored(surface_at(u, v))});
    };
    const glm::dvec3 normal =
        glm::normalize(glm::cross(point(1.0, 0.0) - point(0.0, 0.0), point(0.0, 1.0) - point(0.0, 0.0)));
    return glm::dot(normal, made.cascades.light_direction) < 0.0 ? normal : -normal;
  }
};

// The answers of all places within the errors, by the corners of that box.
struct Reachable {
  double least = 1.0, most = 0.0;
  int fewest = 1 << 20, highest = 0;

  void add(const Answer& answer) {
    least = std::min(least, answer.visibility);
    most = std::max(most, answer.visibility);
    fewest = std::min(fewest, answer.fetches);
    highest = std::max(highest, answer.fetches);
  }
};

Reachable reachable(const Peer& peer, const Tile& tile, const Receiver& receiver) {
  Reachable all;
  all.add(peer.answer(tile, receiver, {}));
  for (unsigned corner = 0; corner < 16; ++corner) {
    const auto either = [&](unsigned bit, double error) {
      return (corner >> bit & 1U) != 0 ? error : -error;
    };
    all.add(peer.answer(tile, receiver,
                        {.texels = {either(0, kTexelError), either(1, kTexelError)},
                         .depth = either(2, kDepthError),
                         .noise = either(3, kNoiseError)}));
  }
  return all;
}

double gradient_noise(int index) {
  const double x = index % kColumns + 0.5, y = index / kColumns + 0.5;
  return testing_peers::fraction(52.9829189 * testing_peers::fraction(0.06711056 * x + 0.00583715 * y));
}

TEST_P(PeerFilters, FollowTheirEnginesRules) {
  const Peer& peer = GetParam().peer;
  const scene::Frame frame = this->frame();
  const Tile tile(frame, kCascade, kDegrees);
  const techniques::TechniqueList& list = library_techniques();
  techniques::Technique technique = list.find(peer.technique);
  // This map is drawn without a rasteriser's bias, which stands for Filament's.
  if (technique.values.contains("slopeBias")) technique.values["slopeBias"] = {2.0};
  GraphRunner runner(test_device(),
                     compile(technique_shader(list, technique, Taps::as_listed, GetParam().reversed_z)));
  const GraphResult result =
      runner.run(FrameOnDevice(test_device(), frame),
                 {.noise_seeds = 1, .first_seed = 0, .timing_repeats = 0, .count_fetches = true});

  int between = 0, dark = 0, lit = 0;
  double width = 0.0;
  int fewest = 1 << 20, highest = 0;
  for (std::size_t i = 0; i < frame.receivers.position_ws.size(); ++i) {
    const Receiver receiver{dvec3(glm::vec3(frame.receivers.position_ws[i])), surface_normal(frame),
                            gradient_noise(static_cast<int>(i))};
    const Reachable wanted = reachable(peer, tile, receiver);
    const double seen = result.visibility[0][i];
    const int fetches = static_cast<int>(result.fetches[i]);
    EXPECT_GE(seen, wanted.least - 1e-4) << i % kColumns << ", " << i / kColumns;
    EXPECT_LE(seen, wanted.most + 1e-4) << i % kColumns << ", " << i / kColumns;
    EXPECT_GE(fetches, wanted.fewest) << i % kColumns << ", " << i / kColumns;
    EXPECT_LE(fetches, wanted.highest) << i % kColumns << ", " << i / kColumns;
    between += wanted.least > 0.05 && wanted.most < 0.95 ? 1 : 0;
    dark += wanted.most < 0.05 ? 1 : 0;
    lit += wanted.least > 0.95 ? 1 : 0;
    width += wanted.most - wanted.least;
    fewest = std::min(fewest, fetches);
    highest = std::max(highest, fetches);
  }
  EXPECT_LT(width / static_cast<double>(frame.receivers.position_ws.size()), 0.01)
      << "the intervals say something";
  EXPECT_TRUE(between > 10 || !peer.soft) << between;
  EXPECT_GT(dark, 10);
  EXPECT_GT(lit, 10);
  EXPECT_GE(fewest, peer.least_fetches);
  EXPECT_LE(highest, peer.most_fetches);
  EXPECT_GT(highest, (peer.least_fetches + peer.most_fetches) / 2 - 1);
}

INSTANTIATE_TEST_SUITE_P(Library, PeerFilters, testing::ValuesIn(all_cases()), [](const auto& instance) {
  return as_identifier(instance.param.peer.technique +
                       (instance.param.reversed_z ? "_reversed" : "_conventional"));
});

}  // namespace
}  // namespace penumbra::resolve
