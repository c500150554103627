// The flagship's filter of one receiver, from textures, against the flagship's tiles on the built-in scenes:
//
// - given the radius that the tile has, both are the same bits at every pixel that a cluster takes: nothing
// but
//   the choice of radii and of exits, which a tile makes for clusters, tells them apart;
// - where its planes decide, the filter is PCSS, bit for bit;
// - where neither decides, both are the same bits wherever neither radius cuts off a cell that holds a
// blocker
//   in the light's cone. Other radii change no sum: they add cells without blockers.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "resolve/drawn_scenes.h"
#include "resolve/graph_runner.h"

namespace penumbra::resolve {
namespace {

constexpr RunOptions kRingsOnce{.noise_seeds = 1, .timing_repeats = 0, .count_fetches = false};

enum class RingProbe { visibility, decision, radius, needed_radius, joined };

// The flagship with draws for its maps, too, and a kernel of the test in place of its last.
ShadowGraph rings_by_textures(const std::string& kernel, bool reversed_z) {
  const techniques::TechniqueList& list = library_techniques();
  ShadowGraph graph = technique_graph(list, list.find("flagship"), Taps::as_listed, reversed_z);
  const techniques::PassGraph drawn = list.find("flagship-pixel").graph;
  techniques::PassGraph& all = graph.graph;
  const auto renamed = [](std::string& name) {
    name = name == "depthPlanes" ? "blockPlanes" : "blockSpreads";
  };
  for (techniques::GraphTexture texture : drawn.textures) {
    renamed(texture.name);
    all.textures.push_back(texture);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    techniques::GraphPass pass = drawn.passes[i];
    for (auto& [shader_name, name] : pass.writes) renamed(name);
    for (auto& [shader_name, name] : pass.reads) renamed(name);
    all.passes.insert(all.passes.begin() + static_cast<std::ptrdiff_t>(i), pass);
  }
  techniques::GraphPass& last = all.passes.back();
  last.name = last.program = kernel;
  last.file = (std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests/resolve/samples/RingsByTextures.compute")
                  .generic_string();
  last.reads = {{"_PenumbraBlockPlanes", "blockPlanes"}, {"_PenumbraBlockSpreads", "blockSpreads"}};
  if (kernel == "WithTilesRadius") {
    last.reads.emplace_back("_PenumbraTileList", "tileList");
  } else {
    last.groups = {};
    last.groups.texels_of = "visibility";
  }
  return graph;
}

class DepthRingFilter : public testing::TestWithParam<bool> {
 protected:
  static std::vector<float> run(const std::string& kernel, RingProbe probe, const FrameOnDevice& frame,
                                const CameraImage& camera) {
    static KeptOnDevice<std::map<std::pair<std::string, bool>, std::unique_ptr<GraphRunner>>> runners;
    std::unique_ptr<GraphRunner>& made = (*runners)[{kernel, GetParam()}];
    if (made == nullptr)
      made = std::make_unique<GraphRunner>(test_device(), compile(rings_by_textures(kernel, GetParam())));
    UniformValues values;
    values.set("_PenumbraProbe", glm::vec4(static_cast<float>(probe), 0.0F, 0.0F, 0.0F));
    made->set_parameters(values);
    return made->run(frame, &camera, kRingsOnce).visibility[0];
  }

  static std::vector<float> run(const std::string& technique, const FrameOnDevice& frame,
                                const CameraImage& camera, bool without_last = false) {
    static KeptOnDevice<std::map<std::pair<std::string, bool>, std::unique_ptr<GraphRunner>>> runners;
    std::unique_ptr<GraphRunner>& made = (*runners)[{technique + (without_last ? "-" : ""), GetParam()}];
    if (made == nullptr) {
      const techniques::TechniqueList& list = library_techniques();
      ShadowGraph graph = technique_graph(list, list.find(technique), Taps::as_listed, GetParam());
      if (without_last) graph.graph.passes.pop_back();
      made = std::make_unique<GraphRunner>(test_device(), compile(graph));
    }
    return made->run(frame, &camera, kRingsOnce).visibility[0];
  }

  struct Pixels {
    long decided = 0;       // by the filter's own planes
    long both_left = 0;     // by the tile and by the filter
    long same_bits = 0;     // of those
    long whole_radius = 0;  // of those: neither radius cuts off a blocker
    long all = 0;
    double squares = 0.0;  // of the differences between the pictures
    double largest = 0.0;

    void print(const std::string& what) const {
      std::printf(
          "%s: %ld pixels, %ld decided; of %ld left by both %ld the same, %ld with whole radii; "
          "pictures differ by %.5f (root mean square), at most %.3f\n",
          what.c_str(), all, decided, both_left, same_bits, whole_radius,
          std::sqrt(squares / static_cast<double>(all)), largest);
    }
  };

  static void compare(const scene::Frame& frame, const std::string& what, Pixels& pixels) {
    const CameraImage camera = camera_image(frame, RowOrder::top_first);
    const FrameOnDevice on_device(test_device(), frame);
    const std::vector<float> tiles = run("flagship", on_device, camera);
    const std::vector<float> classified = run("flagship", on_device, camera, true);
    const std::vector<float> filtered = run("screen-pcss-angular-24-16", on_device, camera);
    const auto of_tiles = [&](RingProbe probe) { return run("WithTilesRadius", probe, on_device, camera); };
    const auto alone = [&](RingProbe probe) { return run("PerPixel", probe, on_device, camera); };
    const std::vector<float> with_tiles_radius = of_tiles(RingProbe::visibility);
    const std::vector<float> tiles_radius = of_tiles(RingProbe::radius);
    const std::vector<float> needed = of_tiles(RingProbe::needed_radius);
    const std::vector<float> joined = of_tiles(RingProbe::joined);
    const std::vector<float> pixel = alone(RingProbe::visibility);
    const std::vector<float> decision = alone(RingProbe::decision);
    const std::vector<float> radius = alone(RingProbe::radius);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
      const std::string where = what + ", pixel " + std::to_string(i);
      ASSERT_EQ(with_tiles_radius[i], tiles[i]) << where;
      ASSERT_TRUE(pixel[i] >= 0.0F && pixel[i] <= 1.0F) << where;
      ++pixels.all;
      if (decision[i] >= 0.0F) {
        ASSERT_EQ(pixel[i], decision[i]) << where;
        ASSERT_EQ(pixel[i], filtered[i]) << where;
        if (classified[i] >= 0.0F) {
          ASSERT_EQ(pixel[i], tiles[i]) << where;
        }
        ++pixels.decided;
      }
      const double difference = std::abs(static_cast<double>(pixel[i]) - static_cast<double>(tiles[i]));
      pixels.squares += difference * difference;
      pixels.largest = std::max(pixels.largest, difference);
      if (classified[i] >= 0.0F || decision[i] >= 0.0F || joined[i] == 0.0F) continue;
      ++pixels.both_left;
      pixels.same_bits += pixel[i] == tiles[i] ? 1 : 0;
      if (std::min(radius[i], tiles_radius[i]) < needed[i]) continue;
      ++pixels.whole_radius;
      ASSERT_EQ(pixel[i], tiles[i]) << where << ": radii " << radius[i] << " and " << tiles_radius[i]
                                    << ", needed " << needed[i];
    }
  }
};

TEST_P(DepthRingFilter, IsTheTilesFilterWithRadiiOfItsOwn) {
  Pixels all;
  for (const std::string& scene : scenes_for_small_pictures()) {
    for (const auto& [cascades, degrees] : {std::pair(4, 0.53), {4, 2.0}, {1, 5.0}}) {
      Pixels here;
      const std::string what = scene + ", " + std::to_string(degrees) + " degrees";
      compare(under_disc(drawn(scene, cascades, GetParam()), degrees), what, here);
      here.print(what);
      all.decided += here.decided;
      all.both_left += here.both_left;
      all.same_bits += here.same_bits;
      all.whole_radius += here.whole_radius;
      all.all += here.all;
      all.squares += here.squares;
      all.largest = std::max(all.largest, here.largest);
    }
  }
  all.print("all scenes");
  EXPECT_GT(all.decided, 20000);
  EXPECT_GT(all.both_left, 20000);
  EXPECT_GT(2 * all.whole_radius, all.both_left);
}

// In a border between cascades the filter reads the cascade that the noise chooses, as the tiles do.
TEST_P(DepthRingFilter, FollowsTheBorderBetweenCascades) {
  scene::Frame frame = drawn("trees", 4, GetParam());
  frame.settings.cascade_choices.blend = {0.3, false};
  Pixels pixels;
  compare(frame, "trees", pixels);
  EXPECT_GT(pixels.both_left, 100);
}

INSTANTIATE_TEST_SUITE_P(BothDirections, DepthRingFilter, testing::Bool(),
                         [](const auto& direction) { return direction.param ? "Reversed" : "Conventional"; });

}  // namespace
}  // namespace penumbra::resolve
