// Compares Cell PCSS's filter of one receiver, from textures, with others on the built-in scenes: where
// its planes decide, it is PCSS, bit for bit; where neither they nor the tiles of Cell PCSS decide, it is
// nearer to the tiles, whose receivers share the sums over large cells, than PCSS 24+16 with its noise is.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "resolve/drawn_scenes.h"
#include "resolve/kept_runners.h"
#include "resolve/run_once.h"
#include "resolve/shortened_graph.h"

namespace penumbra::resolve {
namespace {

class DepthRingFilter : public testing::TestWithParam<bool> {
 protected:
  // The graph has the draws that make the planes, and a kernel of the test.
  static ShadowGraph of_pixels(const std::string& kernel) {
    ShadowGraph graph = library_graph("cell-pcss", GetParam());
    const techniques::PassGraph drawn = library_techniques().find("cell-pcss-pixel").graph;
    const techniques::GraphPass last = rings_by_textures(graph.graph.passes.back(), kernel);
    graph.graph.textures = drawn.textures;
    graph.graph.textures.push_back(*library_techniques().find("cell-pcss").graph.texture("visibility"));
    graph.graph.buffers.clear();
    graph.graph.passes = drawn.passes;
    graph.graph.passes.back() = last;
    return graph;
  }

  enum class Chain { cell_pcss, classified, filtered, pixel, decided };

  static std::vector<float> run(Chain chain, const FrameOnDevice& frame, const CameraImage& camera) {
    static KeptRunners runners;
    GraphRunner& runner = runners.of(std::to_string(static_cast<int>(chain)), GetParam(), [&] {
      ShadowGraph graph = chain == Chain::decided    ? of_pixels("DecisionOfPixels")
                          : chain == Chain::filtered ? library_graph("screen-pcss-angular-24-16", GetParam())
                          : chain == Chain::pixel    ? of_pixels("VisibilityOfPixels")
                                                     : library_graph("cell-pcss", GetParam());
      if (chain == Chain::classified) remove_passes_after(graph.graph, "ClassifyTiles");
      return graph;
    });
    return runner.run(frame, &camera, kOnce).visibility[0];
  }

  struct Pixels {
    long decided = 0;
    long left = 0;         // pixels left by the planes and by the tiles
    double squares = 0.0;  // squared differences of those from the tiles
    double squares_of_pcss = 0.0;

    double root(double sum) const { return std::sqrt(sum / static_cast<double>(std::max(left, 1L))); }
    double apart() const { return root(squares); }
    double pcss_apart() const { return root(squares_of_pcss); }
  };

  static void compare(const scene::Frame& frame, const std::string& what, Pixels& pixels) {
    const CameraImage camera = camera_image(frame, RowOrder::top_first);
    const FrameOnDevice on_device(test_device(), frame);
    const std::vector<float> tiles = run(Chain::cell_pcss, on_device, camera);
    const std::vector<float> classified = run(Chain::classified, on_device, camera);
    const std::vector<float> filtered = run(Chain::filtered, on_device, camera);
    const std::vector<float> pixel = run(Chain::pixel, on_device, camera);
    const std::vector<float> decision = run(Chain::decided, on_device, camera);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
      const std::string where = what + ", pixel " + std::to_string(i);
      ASSERT_TRUE(pixel[i] >= 0.0F && pixel[i] <= 1.0F) << where << ": " << pixel[i];
      if (decision[i] >= 0.0F) {
        ASSERT_EQ(pixel[i], decision[i]) << where;
        ASSERT_EQ(pixel[i], filtered[i]) << where;
        if (classified[i] >= 0.0F) {
          ASSERT_EQ(pixel[i], classified[i]) << where;
        }
        ++pixels.decided;
        continue;
      }
      if (classified[i] >= 0.0F) continue;
      ++pixels.left;
      const double difference = static_cast<double>(pixel[i]) - static_cast<double>(tiles[i]);
      pixels.squares += difference * difference;
      const double of_pcss = static_cast<double>(filtered[i]) - static_cast<double>(tiles[i]);
      pixels.squares_of_pcss += of_pcss * of_pcss;
    }
  }
};

TEST_P(DepthRingFilter, IsPcssWhereThePlanesDecideAndNearTheTilesElsewhere) {
  Pixels all;
  for (const std::string& scene : scenes_for_small_pictures())
    for (const auto& [cascades, degrees] : {std::pair(4, 0.53), {4, 2.0}, {1, 5.0}}) {
      Pixels here;
      const std::string what = scene + ", " + std::to_string(degrees) + " degrees";
      compare(under_disc(drawn(scene, cascades, GetParam()), degrees), what, here);
      std::printf("%s: %ld decided, %ld left, %.4f apart, PCSS %.4f\n", what.c_str(), here.decided, here.left,
                  here.apart(), here.pcss_apart());
      all.decided += here.decided;
      all.left += here.left;
      all.squares += here.squares;
      all.squares_of_pcss += here.squares_of_pcss;
    }
  EXPECT_GT(all.decided, 20000);
  EXPECT_GT(all.left, 20000);
  EXPECT_LT(all.apart(), all.pcss_apart());
}

// In a border between cascades the filter reads the cascade that the noise chooses, as the tiles do.
TEST_P(DepthRingFilter, FollowsTheBorderBetweenCascades) {
  scene::Frame frame = drawn("trees", 4, GetParam());
  frame.settings.cascade_choices.blend = {0.3, false};
  Pixels pixels;
  compare(frame, "trees", pixels);
  EXPECT_GT(pixels.left, 100);
}

INSTANTIATE_TEST_SUITE_P(BothDirections, DepthRingFilter, testing::Bool(), direction_name);

}  // namespace
}  // namespace penumbra::resolve
