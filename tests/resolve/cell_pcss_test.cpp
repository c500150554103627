// Compares Cell PCSS's passes over the built-in scenes with the filter: what they decide for whole
// clusters is what the filter gives at each pixel, bit for bit; what they do not decide is resolved, and
// nothing else is touched.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <regex>

#include "resolve/drawn_scenes.h"
#include "resolve/kept_runners.h"
#include "resolve/run_once.h"
#include "resolve/shortened_graph.h"

namespace penumbra::resolve {
namespace {

// Fills a tile of a map of 32 bits.
void fill_tile(scene::Frame& frame, int cascade, float depth) {
  const int side = frame.cascades.tile_resolution;
  const int tiles_across = frame.atlas.width / side;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const int row = cascade / tiles_across * side + y;
      const int column = cascade % tiles_across * side + x;
      const auto texel = static_cast<std::size_t>(row * frame.atlas.width + column);
      frame.atlas.depth[texel] = depth;
      std::memcpy(&frame.atlas.texels[texel * sizeof depth], &depth, sizeof depth);
    }
}

class CellPcss : public testing::TestWithParam<bool> {
 protected:
  static GraphRunner& chain(const std::string& name, bool classified = false) {
    static KeptRunners runners;
    return runners.of(name + (classified ? ", classified" : ""), GetParam(), [&] {
      ShadowGraph graph = library_graph(name, GetParam());
      if (classified) remove_passes_after(graph.graph, "ClassifyTiles");
      return graph;
    });
  }

  // Cell PCSS's kernels with other numbers of windows, or of groups along an axis.
  static GraphRunner with_macros_of(const std::string& sample) {
    ShadowGraph graph = library_graph("cell-pcss", GetParam());
    for (techniques::GraphPass& pass : graph.graph.passes) pass.file = sample_file(sample);
    return GraphRunner(test_device(), compile(graph));
  }

  // This runner filters each pixel by itself, whatever the planes say.
  static GraphRunner computed_alone() {
    ShadowGraph graph = library_graph("cell-pcss", GetParam());
    const techniques::GraphPass last = rings_by_textures(graph.graph.passes.back(), "ComputedOfPixels");
    remove_passes_after(graph.graph, "NextLevel");
    graph.graph.passes.push_back(last);
    return GraphRunner(test_device(), compile(graph));
  }

  static std::vector<float> picture_of(GraphRunner& chain, const scene::Frame& frame) {
    const CameraImage camera = camera_image(frame, RowOrder::top_first);
    return chain.run(FrameOnDevice(test_device(), frame), &camera, kOnce).visibility[0];
  }

  static constexpr std::size_t kCascades = 4;

  // The changes at each pixel that the texels of each cascade's tile make, whatever they are: from the
  // nearest of the pictures, of which the first is the chain's own.
  static std::vector<std::array<float, kCascades>> changes_by_cascade(
      GraphRunner& chain, const scene::Frame& frame, const std::vector<std::vector<float>>& pictures) {
    std::vector<std::array<float, kCascades>> change(pictures.front().size());
    for (std::size_t cascade = 0; cascade < kCascades; ++cascade) {
      for (const float poison : {0.0f, 1.0f, std::numeric_limits<float>::quiet_NaN()}) {
        scene::Frame poisoned = frame;
        fill_tile(poisoned, static_cast<int>(cascade), poison);
        const std::vector<float> after = picture_of(chain, poisoned);
        for (std::size_t i = 0; i < after.size(); ++i) {
          EXPECT_TRUE(after[i] >= 0.0f && after[i] <= 1.0f) << "pixel " << i << ": " << after[i];
          float apart = 1.0f;
          for (const std::vector<float>& picture : pictures)
            apart = std::min(apart, std::abs(after[i] - picture[i]));
          change[i][cascade] = std::max(change[i][cascade], apart);
        }
      }
    }
    return change;
  }

  // Expects little change of the pixels that read another cascade.
  static void expect_little(std::vector<std::array<float, kCascades>> change) {
    int touched = 0;
    float most = 0.0f;
    for (std::array<float, kCascades>& of_pixel : change) {
      std::sort(of_pixel.begin(), of_pixel.end(), std::greater<float>());
      touched += of_pixel[1] > 0.0f ? 1 : 0;
      most = std::max(most, of_pixel[1]);
    }
    // Whose search a pixel shares depends on the other pixels of its part, and so do the roundings of sums.
    EXPECT_LT(touched, static_cast<int>(change.size()) / 200);
    EXPECT_LT(most, 0.005f) << "a texel of another cascade taken for a blocker changes it by up to 1";
  }

  struct Pictures {
    std::vector<float> filtered;    // answers of PCSS alone
    std::vector<float> classified;  // -1: not decided
    std::vector<float> cell_pcss;
  };

  static Pictures pictures_of(const scene::Frame& frame) {
    const CameraImage camera = camera_image(frame, RowOrder::top_first);
    const FrameOnDevice on_device(test_device(), frame);
    return {chain("screen-pcss-angular-24-16").run(on_device, &camera, kOnce).visibility[0],
            chain("cell-pcss", true).run(on_device, &camera, kOnce).visibility[0],
            chain("cell-pcss").run(on_device, &camera, kOnce).visibility[0]};
  }

  struct Classes {
    int lit = 0;
    int dark = 0;
    int undecided = 0;
    double apart = 0.0;  // sum of differences from the filter's answer over the undecided
  };

  static Classes expect_decided_as_filtered(const Pictures& pictures, const std::string& what) {
    Classes classes;
    for (std::size_t i = 0; i < pictures.classified.size(); ++i) {
      const float decided = pictures.classified[i];
      const float shown = pictures.cell_pcss[i];
      if (decided == -1.0f) {
        ++classes.undecided;
        classes.apart += std::abs(static_cast<double>(shown - pictures.filtered[i]));
        EXPECT_TRUE(shown >= 0.0f && shown <= 1.0f) << what << ", pixel " << i << ": " << shown;
        continue;
      }
      EXPECT_EQ(decided, pictures.filtered[i]) << what << ", pixel " << i;
      EXPECT_EQ(decided, shown) << what << ", pixel " << i;
      (decided == 1.0f ? classes.lit : classes.dark) += 1;
    }
    return classes;
  }
};

TEST_P(CellPcss, DecidesForClustersWhatTheFilterGives) {
  Classes all;
  for (const std::string& scene : scenes_for_small_pictures()) {
    for (const auto& [cascades, degrees] : {std::pair(4, 0.53), {4, 2.0}, {4, 5.0}, {1, 2.0}}) {
      const Classes here =
          expect_decided_as_filtered(pictures_of(under_disc(drawn(scene, cascades, GetParam()), degrees)),
                                     scene + ", " + std::to_string(degrees) + " degrees");
      EXPECT_GT(here.lit + here.dark, 0) << scene << ", " << degrees;
      all.lit += here.lit;
      all.dark += here.dark;
      all.undecided += here.undecided;
      // Samples of PCSS 24+16 scatter by some hundredths; a window that is read wrongly is off by tenths.
      EXPECT_LT(here.apart / here.undecided, 0.06) << scene << ", " << degrees;
    }
  }
  EXPECT_GT(all.lit, 20000);
  EXPECT_GT(all.dark, 2000);
  EXPECT_GT(all.undecided, 20000);
}

// The maps are the pipeline's: any number of cascades in the atlas, and depths of 16 bits as well.
TEST_P(CellPcss, DecidesOverEveryMapWhatTheFilterGives) {
  for (const scene::DepthFormat format : {scene::DepthFormat::d16, scene::DepthFormat::d32}) {
    Classes all;
    for (int cascades = 1; cascades <= 4; ++cascades) {
      const std::string what = (format == scene::DepthFormat::d16 ? "16" : "32") +
                               (" bits, " + std::to_string(cascades)) + " cascades";
      const Classes here = expect_decided_as_filtered(
          pictures_of(under_disc(drawn("slabs", cascades, GetParam(), format), 2.0)), what);
      EXPECT_GT(here.lit, 0) << what;
      EXPECT_GT(here.undecided, 0) << what;
      all.lit += here.lit;
      all.dark += here.dark;
    }
    EXPECT_GT(all.lit, 4000);
    EXPECT_GT(all.dark, 0);
  }
}

// Pixels of a border between cascades may read the next one: none of them is decided, all are resolved.
TEST_P(CellPcss, ResolvesTheBorderBetweenCascades) {
  scene::Frame frame = drawn("trees", 4, GetParam());
  frame.settings.cascade_choices.blend = {0.3, false};
  const Classes classes = expect_decided_as_filtered(pictures_of(frame), "trees");
  EXPECT_GT(classes.lit, 0);
  EXPECT_GT(classes.undecided, 0);
}

// The picture is the same each time: there is no noise, and no order of threads.
TEST_P(CellPcss, DrawsTheSamePictureAgain) {
  const scene::Frame frame = under_disc(drawn("street", 4, GetParam()), 2.0);
  EXPECT_EQ(pictures_of(frame).cell_pcss, pictures_of(frame).cell_pcss);
}

// The texels of a cascade's tile may be anything, far, near or NaN. Of the pixels that read another cascade
// few change, and little, since what they share with their neighbours changes.
TEST_P(CellPcss, ReadsNoTexelOfOtherCascadesWhereWindowsTakeAll) {
  GraphRunner chain = with_macros_of("MoreWindows.compute");
  // 528 is 2 x 8 x 33 texels, so that cells of 16 and more texels could hold texels of two tiles.
  for (const auto& [map_size, degrees] : {std::pair(0, 2.0), {528, 8.0}}) {
    const scene::Frame frame =
        under_disc(drawn("street", kCascades, GetParam(), scene::DepthFormat::d32, map_size), degrees);
    SCOPED_TRACE(map_size);
    expect_little(changes_by_cascade(chain, frame, {picture_of(chain, frame)}));
  }
}

// With fewer windows, neighbours also decide whether a window takes a pixel: it may change to what it is
// alone, or in a window.
TEST_P(CellPcss, ReadsNoTexelOfOtherCascades) {
  const scene::Frame frame = under_disc(drawn("street", kCascades, GetParam()), 2.0);
  GraphRunner alone = computed_alone();
  GraphRunner shared = with_macros_of("MoreWindows.compute");
  GraphRunner& cell_pcss = chain("cell-pcss");
  expect_little(changes_by_cascade(
      cell_pcss, frame, {picture_of(cell_pcss, frame), picture_of(alone, frame), picture_of(shared, frame)}));
}

// No API runs more than 65,535 groups along an axis, and a screen may have more tiles.
TEST_P(CellPcss, ListsGoOnAlongTheNextAxis) {
  const scene::Frame frame = under_disc(drawn("street", kCascades, GetParam()), 2.0);
  GraphRunner few_across = with_macros_of("FewGroupsAcross.compute");
  EXPECT_EQ(picture_of(few_across, frame), picture_of(chain("cell-pcss"), frame));
}

// The threads of a part filter what no window takes as one thread does, for all pixels that are not decided.
TEST_P(CellPcss, FiltersAloneWhatNoWindowTakes) {
  for (const int cascades : {1, 4}) {
    const scene::Frame frame = under_disc(drawn("street", cascades, GetParam()), 2.0);
    GraphRunner without_windows = with_macros_of("NoWindows.compute");
    GraphRunner one_by_one = computed_alone();
    const std::vector<float> classified = picture_of(chain("cell-pcss", true), frame);
    const std::vector<float> by_parts = picture_of(without_windows, frame);
    const std::vector<float> alone = picture_of(one_by_one, frame);
    int compared = 0, apart = 0;
    float most = 0.0F;
    for (std::size_t i = 0; i < classified.size(); ++i) {
      if (classified[i] >= 0.0F) continue;
      ++compared;
      if (std::abs(by_parts[i] - alone[i]) > 0.001F) ++apart;
      most = std::max(most, std::abs(by_parts[i] - alone[i]));
    }
    EXPECT_GT(compared, 2000) << cascades;
    // A part's search is no wider than the penumbrae that its planes allow; a wider one may find blockers
    // beyond.
    EXPECT_LT(apart, compared / 100) << cascades;
    EXPECT_LT(most, 0.1F) << cascades;
  }
}

// At half resolution every second pixel is computed as at full resolution, with other pixels beside it in its
// tile: the upsampling copies it. A pixel that whole clusters decide may then be computed, and the other way
// round.
TEST_P(CellPcss, ComputesTheSamePixelsAtHalfResolution) {
  for (const auto& [scene, degrees] : {std::pair("street", 0.53), {"trees", 2.0}, {"slabs", 5.0}}) {
    const scene::Frame frame = under_disc(drawn(scene, 4, GetParam()), degrees);
    const CameraImage camera = camera_image(frame, RowOrder::top_first);
    const FrameOnDevice on_device(test_device(), frame);
    const std::vector<float> full = chain("cell-pcss").run(on_device, &camera, kOnce).visibility[0];
    const std::vector<float> half = chain("cell-pcss-half").run(on_device, &camera, kOnce).visibility[0];
    const auto is_computed = [](int at, int size) { return at % 2 == 1 || at == size - 1; };
    int computed = 0, same = 0;
    double apart = 0.0;
    for (int y = 0; y < camera.height; ++y)
      for (int x = 0; x < camera.width; ++x) {
        if (!is_computed(x, camera.width) || !is_computed(y, camera.height)) continue;
        const auto pixel = static_cast<std::size_t>(y * camera.width + x);
        const double difference = std::abs(static_cast<double>(half[pixel] - full[pixel]));
        ++computed;
        same += difference <= 0.5 / 255.0 + 1e-6 ? 1 : 0;
        apart += difference;
      }
    EXPECT_EQ(computed, 65 * 37) << scene;
    // Pixels that share a window with others differ a little; a pixel that stands for another one is off by
    // tenths.
    EXPECT_GT(same, 0.8 * computed) << scene;
    EXPECT_LT(apart / computed, 0.01) << scene;
  }
}

// There are two cameras side by side: each eye's picture is that which the kernels draw for it alone.
TEST_P(CellPcss, DrawsBothEyesAtOnceAsEachAlone) {
  ShadowGraph of_both_eyes = library_graph("cell-pcss", GetParam());
  of_both_eyes.keywords.emplace_back("_PENUMBRA_BOTH_EYES");
  for (techniques::GraphTexture& texture : of_both_eyes.graph.textures)
    if (texture.name == "visibility") texture.layers = 2;
  GraphRunner runner(test_device(), compile(of_both_eyes));
  const scene::Frame frame = under_disc(drawn("street", 4, GetParam()), 2.0);
  const scene::Frame other = under_disc(drawn("slabs", 4, GetParam()), 2.0);
  const CameraImage left = camera_image(frame, RowOrder::top_first);
  // The right eye has a picture of its own: what another camera sees of another scene, as the same map would
  // shadow it.
  const CameraImage right = camera_image(other, RowOrder::top_first);
  const FrameOnDevice on_device(test_device(), frame);
  const auto alone = [&](const CameraImage& eye) {
    return chain("cell-pcss").run(on_device, &eye, kOnce).visibility[0];
  };
  RunOptions options = kOnce;
  options.second_eye = &right;
  const std::vector<float> both = runner.run(on_device, &left, options).visibility[0];
  std::vector<float> expected = alone(left);
  const std::vector<float> second = alone(right);
  EXPECT_NE(expected, second);
  expected.insert(expected.end(), second.begin(), second.end());
  ASSERT_EQ(both.size(), expected.size());
  EXPECT_EQ(both, expected);
}

// The value of a macro of ShaderLibrary/ScreenTiles/TileWindows.hlsl.
int window_constant(const std::string& name) {
  std::ifstream file(std::filesystem::path(PENUMBRA_SOURCE_DIR) /
                     "ShaderLibrary/ScreenTiles/TileWindows.hlsl");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  std::smatch found;
  if (!std::regex_search(text, found, std::regex("#define " + name + " (\\d+)")))
    throw std::logic_error("there is no " + name);
  return std::stoi(found[1]);
}

// Wherever the receivers of a cluster lie, up to 2 kWindowReach apart, the windows of all levels have room:
// kRingCells = 5 cells and one more on each side, of cells that hold any part of that.
TEST(CellPcssWindows, HaveRoomForTheCellsAroundEveryCluster) {
  constexpr int kAround = 6;
  const int texels = window_constant("WINDOW_TEXELS");
  const double reach = 0.5 * (texels - 3.0) - kAround;
  int widest = 0, most = 0;
  for (int low = 0; low < 256; ++low) {
    const int high = low + static_cast<int>(std::floor(2.0 * reach));
    int cells = 0;
    for (int level = 0; level < window_constant("WINDOW_LEVELS"); ++level) {
      const double cell = std::exp2(level);
      const int size = static_cast<int>(std::floor((high + 1 + kAround * cell) / cell) -
                                        std::floor((low - kAround * cell) / cell)) +
                       1;
      if (level == 0)
        widest = std::max(widest, size);
      else
        cells += size * size;
    }
    most = std::max(most, cells);
  }
  EXPECT_LE(widest, texels);
  EXPECT_LE(most, window_constant("WINDOW_CELLS"));
  EXPECT_GT(most, 0.9 * window_constant("WINDOW_CELLS"));
}

INSTANTIATE_TEST_SUITE_P(BothDirections, CellPcss, testing::Bool(), direction_name);

}  // namespace
}  // namespace penumbra::resolve
