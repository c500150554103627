// Tiled PCSS calls no receiver lit or dark that rays through the same shadow map call otherwise.
//
// DecideTiles runs on the device, and TileClasses.compute gives the tiles' classes to their pixels; -1 is
// where nothing is decided. What it calls lit must be a receiver from which no ray to any point of the
// light's disc, edge included, meets a square of the map's surface; that is decided exactly, in double, by a
// search over the whole tile. What it calls dark must be one from which every ray is blocked: proved where
// every texel that a ray can come near blocks, and else, and for a share of those for which it is proved,
// tried with rays to kRays points over the disc and its edge. map_rays.h says what the surface is: no slack
// in depth or distance, no interpolation between texels. Rays know neither of planes that hold blocks between
// them nor of the filter's samples. Each frame has two of three softness caps, and the rays end where it lets
// them.
//
// The receiver is the one that the shaders have, to the bit: its place, depth and plane are read back as
// floats, by TileReceivers.compute, and taken for exact. Its place and depth are also worked out here.
//
//   build/release/penumbra_resolve_tests --gtest_filter='*Classified*'
//
// prints how many receivers were lit and dark.
#include <gmock/gmock.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <random>
#include <thread>

#include "platform/thread_group.h"
#include "reference/disc_samples.h"
#include "resolve/adversarial_maps.h"
#include "resolve/drawn_scenes.h"
#include "resolve/kept_runners.h"
#include "resolve/map_rays.h"
#include "resolve/run_once.h"
#include "resolve/shortened_graph.h"

namespace penumbra::resolve {
namespace {

constexpr std::array kCaps{2.0F, 100.0F,
                           1e6F};  // widest penumbrae, metres; the last is the most that there is

constexpr int kTileOfMaps = 256;  // texels of a side of the adversarial maps
constexpr int kRays = 80;
constexpr int kRaysToTheEdge = 16;  // of these rays, so many go to the edge
// One dark receiver of so many is tried with rays although it is proved.
constexpr std::uint64_t kProvedOfOneTried = 16;

struct Counts {
  long receivers = 0;
  long lit = 0;
  long dark = 0;
  long tried = 0;  // dark ones that were tried with rays
  long wrong = 0;
  std::string first_wrong;

  void add(const Counts& other) {
    receivers += other.receivers;
    lit += other.lit;
    dark += other.dark;
    tried += other.tried;
    wrong += other.wrong;
    if (first_wrong.empty()) first_wrong = other.first_wrong;
  }
};

// The numbers of TileReceivers.compute at each pixel.
struct TileReceivers {
  std::vector<float> cascade;
  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> depth;
  std::vector<float> slope_x;
  std::vector<float> slope_y;
  std::vector<float> quad_slope_x;
  std::vector<float> quad_slope_y;

  std::string text(std::size_t i) const {
    char line[200];
    std::snprintf(line, sizeof line, "cascade %g, place (%.9g, %.9g), depth %.9g, plane (%.9g, %.9g)",
                  cascade[i], x[i], y[i], depth[i], slope_x[i], slope_y[i]);
    return line;
  }
};

using DiscPoints = std::array<glm::dvec2, kRays>;

DiscPoints disc_points(std::uint64_t seed) {
  DiscPoints points;
  for (int ray = 0; ray < kRays; ++ray) {
    const glm::dvec2 square = reference::scrambled_sobol(static_cast<std::uint32_t>(ray), seed);
    const double angle = 2.0 * M_PI * (ray + square.x) / kRaysToTheEdge;
    points.at(static_cast<std::size_t>(ray)) = ray < kRaysToTheEdge
                                                   ? glm::dvec2(std::cos(angle), std::sin(angle))
                                                   : reference::concentric_disc(square);
  }
  return points;
}

// Each seed has one of kSets sets of points: scrambling them takes longer than tracing the rays.
const DiscPoints& kept_disc_points(std::uint64_t seed) {
  constexpr std::size_t kSets = 1024;
  static const std::vector<DiscPoints> sets = [] {
    std::vector<DiscPoints> made;
    for (std::size_t set = 0; set < kSets; ++set) made.push_back(disc_points(set));
    return made;
  }();
  return sets[seed % kSets];
}

class Classified : public testing::TestWithParam<bool> {
 protected:
  static std::vector<float> classes_of(float cap, const FrameOnDevice& on_device, const CameraImage& camera) {
    static KeptRunners runners;
    GraphRunner& classifier = runners.of("tiled-pcss", GetParam(), [] {
      ShadowGraph graph = library_graph("tiled-pcss", GetParam());
      show_tile_classes(graph.graph);
      return graph;
    });
    UniformValues capped;
    capped.set("_PenumbraPcssBoundedParameters0", glm::vec4(1.0F, 1.0F, cap, 0.0F));
    classifier.set_parameters(capped);
    return classifier.run(on_device, &camera, kOnce).visibility[0];
  }

  static GraphRunner& prober() {
    static const techniques::TechniqueList list = techniques::read_technique_list(
        std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests/resolve/samples/TileReceivers.technique.json");
    static KeptRunners runners;
    return runners.of("tile-receivers", GetParam(), [] {
      return technique_graph(list, list.find("tile-receivers"), Taps::as_listed, GetParam());
    });
  }

  static TileReceivers receivers_of(const FrameOnDevice& on_device, const CameraImage& camera) {
    TileReceivers receivers;
    int value = 0;
    for (std::vector<float>* into :
         {&receivers.cascade, &receivers.x, &receivers.y, &receivers.depth, &receivers.slope_x,
          &receivers.slope_y, &receivers.quad_slope_x, &receivers.quad_slope_y}) {
      UniformValues values;
      values.set("_PenumbraTileReceiversParameters0",
                 glm::vec4(static_cast<float>(value++), 0.0F, 0.0F, 0.0F));
      prober().set_parameters(values);
      *into = prober().run(on_device, &camera, kOnce).visibility[0];
    }
    return receivers;
  }

  // Compares the receivers with place and depth as the camera's image and the frame's matrices have them, in
  // double.
  static bool is_receiver_of(const TileReceivers& receivers, std::size_t i, const scene::Frame& frame,
                             const SeenByDepth& seen, const CameraImage& camera) {
    const int x = static_cast<int>(i) % camera.width, y = static_cast<int>(i) / camera.width;
    const std::optional<double> depth = seen.depth(x, y);
    if (!depth) return false;
    const parameters::Cascade& cascade =
        frame.cascades.cascades.at(static_cast<std::size_t>(receivers.cascade[i]));
    const glm::dvec4 at = cascade.world_to_shadow * glm::dvec4(seen.position(x, y, *depth), 1.0);
    const glm::dvec2 low = glm::dvec2(cascade.offset_scale);
    const glm::dvec2 uv =
        glm::clamp(glm::dvec2(at), low, low + glm::dvec2(cascade.offset_scale.z, cascade.offset_scale.w));
    // The bound is a hundredth of a texel, and the same along the light, beyond what floats lose on the way.
    const double metres = 0.01 * cascade.texel_size_metres + rounding_metres(camera, x, y, *depth);
    const double texels = metres / cascade.texel_size_metres;
    return std::abs(uv.x * frame.atlas.width - static_cast<double>(receivers.x[i])) < texels &&
           std::abs(uv.y * frame.atlas.height - static_cast<double>(receivers.y[i])) < texels &&
           std::abs(at.z - static_cast<double>(receivers.depth[i])) < metres * cascade.depth_per_metre;
  }

  // The error of a position that is worked out in floats: a few roundings of each sum's terms, which are
  // larger than the sum far from the camera.
  static double rounding_metres(const CameraImage& camera, int x, int y, double depth) {
    const glm::dmat4& m = camera.screen_to_world;
    const glm::dvec4 from((x + 0.5) / camera.width, (y + 0.5) / camera.height, depth, 1.0);
    const glm::dvec4 sum = m * from;
    glm::dvec4 terms(0.0);
    for (int k = 0; k < 4; ++k) terms += glm::abs(m[k] * from[k]);
    const double distance = glm::length(glm::dvec3(sum)) / std::abs(sum.w);
    return 0x1p-21 * (glm::length(glm::dvec3(terms)) + distance * terms.w) / std::abs(sum.w);
  }

  static Counts count(const scene::Frame& frame, const CameraImage& camera, const std::string& what) {
    const FrameOnDevice on_device(test_device(), frame);
    const TileReceivers receivers = receivers_of(on_device, camera);
    const std::size_t first = frames_++;
    Counts all;
    for (const std::size_t cap : {first, first + 1})
      all.add(count_of(kCaps.at(cap % kCaps.size()), on_device, receivers, frame, camera, what));
    return all;
  }

  static Counts count_of(float cap, const FrameOnDevice& on_device, const TileReceivers& receivers,
                         const scene::Frame& frame, const CameraImage& camera, const std::string& what) {
    const std::vector<float> classes = classes_of(cap, on_device, camera);
    std::vector<MapRays> maps;
    for (std::size_t cascade = 0; cascade < frame.cascades.cascades.size(); ++cascade)
      maps.emplace_back(frame, cascade, 0.5 * static_cast<double>(cap));
    const SeenByDepth seen(camera);
    std::atomic<std::size_t> next_row{0};
    std::mutex adding;
    Counts all;
    platform::run_on_threads(std::thread::hardware_concurrency(), [&] {
      Counts own;
      const auto width = static_cast<std::size_t>(camera.width);
      for (std::size_t row; (row = next_row++) < static_cast<std::size_t>(camera.height);)
        for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
          if (receivers.cascade[i] < 0.0F) continue;
          ++own.receivers;
          std::string fault;
          if (!is_receiver_of(receivers, i, frame, seen, camera))
            fault = "stands elsewhere";
          else if (classes[i] >= 0.0F)
            fault =
                fault_of(maps[static_cast<std::size_t>(receivers.cascade[i])], receivers, i, classes[i], own);
          if (fault.empty()) continue;
          if (own.wrong++ == 0)
            own.first_wrong = what + ", pixel " + std::to_string(i) + " " + fault + ": " + receivers.text(i);
        }
      const std::lock_guard lock(adding);
      all.add(own);
    });
    EXPECT_EQ(all.wrong, 0) << "cap " << cap << ": " << all.first_wrong;
    return all;
  }

  // The reason why the decision is wrong; empty where it is right.
  static std::string fault_of(const MapRays& map, const TileReceivers& receivers, std::size_t i,
                              float decided, Counts& counts) {
    const MapReceiver receiver =
        map.receiver({receivers.x[i], receivers.y[i]}, static_cast<double>(receivers.depth[i]),
                     {receivers.slope_x[i], receivers.slope_y[i]});
    const double highest = map.highest_in_cone(receiver);
    if (decided == 1.0F) {
      ++counts.lit;
      return highest > 0.0 ? "is called lit below a texel " + std::to_string(highest) + " above it" : "";
    }
    if (decided != 0.0F) return "is neither lit nor dark nor left";
    ++counts.dark;
    const std::string fault = fault_of_dark(map, receiver, i, counts);
    if (fault.empty()) return fault;
    // At a crease the plane of one side is as good as that of the other.
    const MapReceiver of_quad =
        map.receiver({receivers.x[i], receivers.y[i]}, static_cast<double>(receivers.depth[i]),
                     {receivers.quad_slope_x[i], receivers.quad_slope_y[i]});
    return fault_of_dark(map, of_quad, i, counts).empty() ? "" : fault;
  }

  static std::string fault_of_dark(const MapRays& map, const MapReceiver& receiver, std::size_t i,
                                   Counts& counts) {
    const double highest = map.highest_in_cone(receiver);
    const std::uint64_t seed = reference::mixed_bits(i);
    const bool proved = highest > 0.0 && map.all_block(receiver, highest);
    if (proved && seed % kProvedOfOneTried != 0) return "";
    ++counts.tried;
    const double above = map.highest_above(receiver);
    for (const glm::dvec2& point : kept_disc_points(seed / kProvedOfOneTried))
      if (!map.ray_is_blocked(receiver, point, above))
        return "is called dark although a ray to (" + std::to_string(point.x) + ", " +
               std::to_string(point.y) + ") of the disc passes" + (proved ? ", against the proof" : "");
    return "";
  }

  static inline std::size_t frames_ = 0;

  static void print(const Counts& counts, const char* of) {
    std::printf("%ld receivers of %s: %ld lit, %ld dark (%ld of them by rays), %ld wrong\n", counts.receivers,
                of, counts.lit, counts.dark, counts.tried, counts.wrong);
  }
};

std::vector<std::string> drawable_scenes() {
  std::vector<std::string> names = scene::all_built_in_names();
  for (const scene::PackageModel& model : scene::package_models())
    if (std::filesystem::exists(std::filesystem::path("/usr/share") / model.file))
      names.push_back("package:" + model.name);
  return names;
}

// Each scene has one of its two suns in one direction of depth, and the other in the other.
TEST_P(Classified, ReceiversOfEveryScene) {
  Counts all;
  int drawing = GetParam() ? 1 : 0;
  bool low_sun = GetParam();
  std::mt19937 random(1);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (const std::string& name : drawable_scenes()) {
    scene::Scene scene = scene::load(name);
    if (low_sun) scene.light_direction = scene::sunlight(8.0, between(0.0, 360.0));
    scene::FrameSettings settings = screen_settings(1 + drawing++ % 4, GetParam());
    settings.shadows.distance_metres = scene.shadow_distance_metres;
    settings.width = 351;
    settings.height = 197;
    settings.lens_shift = {between(-0.2, 0.2), between(-0.2, 0.2)};
    const scene::Frame frame = scene::rasterise(test_device(), scene, settings);
    for (const double degrees : {0.53, 2.0, 5.0}) {
      const scene::Frame lit = under_disc(frame, degrees);
      all.add(count(lit, camera_image(lit),
                    name + (low_sun ? ", low sun, " : ", ") + std::to_string(degrees) + " degrees"));
    }
    low_sun = !low_sun;
  }
  print(all, "the scenes");
  EXPECT_GE(all.receivers, 2'500'000);
  EXPECT_GE(all.lit, 1'000'000);
  EXPECT_GE(all.dark, 50'000);
}

// Each pair of a map and its receivers has another light, cascade, width of the disc and view. Every second
// pair is of one direction of depth, the others are of the other.
TEST_P(Classified, ReceiversOfAdversarialMaps) {
  Counts all;
  std::mt19937 random(2);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  bool first_is_reversed = false;
  for (const NamedHeights& map : adversarial_maps()) {
    first_is_reversed = !first_is_reversed;
    bool reversed = !first_is_reversed;
    for (const NamedReceivers& receivers : adversarial_receivers()) {
      reversed = !reversed;
      if (reversed != GetParam()) continue;
      testing_frames::FrameSetup setup;
      setup.shadows.cascades = 1 + static_cast<int>(random() % 4);
      setup.shadows.resolution = setup.shadows.cascades == 1 ? kTileOfMaps : 2 * kTileOfMaps;
      setup.shadows.reversed_z = GetParam();
      setup.cascade = static_cast<int>(random() % static_cast<unsigned>(setup.shadows.cascades));
      setup.light.direction = scene::sunlight(between(8.0, 85.0), between(0.0, 360.0));
      const double diameters[] = {0.53, 2.0, 5.0, 30.0};
      setup.light.angular_diameter_degrees = diameters[random() % 4];
      const scene::Frame frame = testing_frames::make_frame(
          setup,
          [&](double u, double v, int) {
            return stored_height(
                map.height(static_cast<int>(u * kTileOfMaps), static_cast<int>(v * kTileOfMaps)), GetParam());
          },
          std::vector<testing_frames::TilePoint>(1, {0.5, 0.5, 0.5}), 1);
      ViewOfTile view;
      view.span = glm::dvec2(1.0, 1.0) * std::exp2(between(-3.0, 0.0));
      view.first = {between(0.0, 1.0 - view.span.x), between(0.0, 1.0 - view.span.y)};
      if (random() % 2 == 0) view.slant = {between(-0.2, 0.2), between(-0.2, 0.2)};
      all.add(count(frame, camera_along_light(frame, setup.cascade, view, map.height, receivers.height),
                    map.name + ", " + receivers.name + ", " +
                        std::to_string(setup.light.angular_diameter_degrees) + " degrees"));
    }
  }
  print(all, "adversarial maps");
  EXPECT_GE(all.receivers, 5'000'000);
  EXPECT_GE(all.lit, 1'000'000);
  EXPECT_GE(all.dark, 500'000);
}

// Columns of texels are as wide as the map and are crossed by rays: a formula for each square and wall says
// what they meet.
class Columns {
 public:
  Columns(std::mt19937& random, int side) : heights_(static_cast<std::size_t>(side)) {
    const auto share = [&] { return std::uniform_real_distribution<double>(0.0, 1.0)(random); };
    for (std::size_t i = 0; i < heights_.size();) {
      const double height = random() % 3 == 0 ? 0.0 : static_cast<double>(static_cast<float>(share()));
      for (std::size_t width = 1 + random() % 8; width > 0 && i < heights_.size(); --width)
        heights_[i++] = height;
    }
  }

  double height(int x) const { return heights_.at(static_cast<std::size_t>(x)); }

  // receiver.height is in [0, 1]. per_height is how far the ray goes along x for each unit of height.
  bool meet(const MapReceiver& receiver, double per_height) const {
    const auto blocks = [&](int x) {
      return height(x) > receiver.height &&
             height(x) >
                 std::min(receiver.height + receiver.slope.x * (x + 0.5 - receiver.place.x), 1.0 - 0x1p-24);
    };
    const int side = static_cast<int>(heights_.size());
    for (int x = 0; x < side; ++x) {
      if (!blocks(x)) continue;
      const double at_height = receiver.place.x + per_height * (height(x) - receiver.height);
      if (at_height >= x && at_height <= x + 1) return true;
      if (x + 1 == side || !blocks(x + 1)) continue;
      const double at_wall = receiver.height + (x + 1 - receiver.place.x) / per_height;
      if (at_wall >= receiver.height && at_wall >= std::min(height(x), height(x + 1)) &&
          at_wall <= std::max(height(x), height(x + 1)))
        return true;
    }
    return false;
  }

 private:
  std::vector<double> heights_;
};

TEST_P(Classified, RaysMeetWhatTheFormulaOfColumnsSays) {
  constexpr int kSide = 64;
  std::mt19937 random(3);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int met = 0, missed = 0, empty_cones = 0, proved = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Columns columns(random, kSide);
    testing_frames::FrameSetup setup;
    setup.shadows.resolution = kSide;
    setup.shadows.reversed_z = GetParam();
    setup.light.angular_diameter_degrees = between(0.5, 30.0);
    const scene::Frame frame = testing_frames::make_frame(
        setup,
        [&](double u, double, int) {
          return stored_height(columns.height(static_cast<int>(u * kSide)), GetParam());
        },
        std::vector<testing_frames::TilePoint>(1, {0.5, 0.5, 0.5}), 1);
    const MapRays map(frame, 0, 1e6);
    const double per_height = frame.cascades.cascades[0].depth_to_radial * kSide;
    ASSERT_LT(per_height, 0.4 * kSide);
    for (int i = 0; i < 50; ++i) {
      const double slope = i % 2 == 0 ? 0.0 : between(-0.02, 0.02);
      MapReceiver receiver =
          map.receiver({between(0.4, 0.6) * kSide, 0.5 * kSide}, stored_height(between(0.0, 0.5), GetParam()),
                       {GetParam() ? slope : -slope, 0.0});
      const double in_cone = map.highest_in_cone(receiver);
      const bool all_block = in_cone > 0.0 && map.all_block(receiver, in_cone);
      const DiscPoints& points = kept_disc_points(static_cast<std::uint64_t>(i));
      for (int ray = 0; ray < kRays; ++ray) {
        const glm::dvec2 point = points.at(static_cast<std::size_t>(ray));
        MapReceiver from_zero = receiver;
        from_zero.height += GetParam() ? 0.0 : 1.0;
        const bool expected = columns.meet(from_zero, point.x * per_height);
        ASSERT_EQ(map.ray_is_blocked(receiver, point, map.highest_above(receiver)), expected)
            << "map " << trial << ", receiver " << i << ", ray " << ray;
        ASSERT_FALSE(in_cone == 0.0 && expected);
        ASSERT_FALSE(all_block && !expected);
        (expected ? met : missed) += 1;
      }
      empty_cones += in_cone == 0.0 ? 1 : 0;
      proved += all_block ? 1 : 0;
    }
  }
  EXPECT_GT(met, 100'000);
  EXPECT_GT(missed, 100'000);
  EXPECT_GT(empty_cones, 1000);
  EXPECT_GT(proved, 1000);
}

INSTANTIATE_TEST_SUITE_P(BothDirections, Classified, testing::Bool(), direction_name);

}  // namespace
}  // namespace penumbra::resolve
