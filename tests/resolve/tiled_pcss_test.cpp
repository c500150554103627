// Compares the passes of Tiled PCSS over the built-in scenes with its filter alone, and with each other: what
// they decide for whole tiles is what the filter gives at each pixel; borders, other cascades' texels, half
// resolution and both eyes change no more than they may.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <set>

#include "resolve/drawn_scenes.h"
#include "resolve/kept_runners.h"
#include "resolve/run_once.h"
#include "resolve/shortened_graph.h"

namespace penumbra::resolve {
namespace {

constexpr std::size_t kCascades = 4;

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

class TiledPcss : public testing::TestWithParam<bool> {
 protected:
  static GraphRunner& chain(const std::string& name, bool classified = false) {
    static KeptRunners runners;
    return runners.of(name + (classified ? ", classified" : ""), GetParam(), [&] {
      ShadowGraph graph = library_graph(name, GetParam());
      if (classified) show_tile_classes(graph.graph);
      return graph;
    });
  }

  static std::vector<float> picture_of(GraphRunner& chain, const scene::Frame& frame) {
    const CameraImage camera = camera_image(frame, RowOrder::top_first);
    return chain.run(FrameOnDevice(test_device(), frame), &camera, kOnce).visibility[0];
  }

  struct Pictures {
    std::vector<float> filtered;  // answers of the filter alone, as a screen pass
    std::vector<float> classified;
    std::vector<float> tiled;
  };

  static Pictures pictures_of(const scene::Frame& frame) {
    const CameraImage camera = camera_image(frame, RowOrder::top_first);
    const FrameOnDevice on_device(test_device(), frame);
    return {chain("fallback-medium").run(on_device, &camera, kOnce).visibility[0],
            chain("tiled-pcss", true).run(on_device, &camera, kOnce).visibility[0],
            chain("tiled-pcss").run(on_device, &camera, kOnce).visibility[0]};
  }

  struct Classes {
    int lit = 0;
    int dark = 0;
    int undecided = 0;
    int dark_at_creases = 0;  // called dark, and partly lit by the filter
    double apart = 0.0;       // sum of differences from the filter's answer over the undecided

    void add(const Classes& other) {
      lit += other.lit;
      dark += other.dark;
      dark_at_creases += other.dark_at_creases;
      undecided += other.undecided;
      apart += other.apart;
    }
  };

  static Classes expect_decided_as_filtered(const Pictures& pictures, const std::string& what) {
    Classes classes;
    for (std::size_t i = 0; i < pictures.classified.size(); ++i) {
      const float decided = pictures.classified[i];
      const float shown = pictures.tiled[i];
      if (decided == -1.0F) {
        ++classes.undecided;
        classes.apart += std::abs(static_cast<double>(shown - pictures.filtered[i]));
        EXPECT_TRUE(shown >= 0.0F && shown <= 1.0F) << what << ", pixel " << i << ": " << shown;
        continue;
      }
      if (decided == 1.0F) {
        EXPECT_EQ(pictures.filtered[i], 1.0F) << what << ", pixel " << i;
      } else if (pictures.filtered[i] > 0.0F) {
        ++classes.dark_at_creases;
      }
      EXPECT_EQ(decided, shown) << what << ", pixel " << i;
      (decided == 1.0F ? classes.lit : classes.dark) += 1;
    }
    return classes;
  }
};

TEST_P(TiledPcss, DecidesForTilesWhatTheFilterGives) {
  Classes all;
  for (const std::string& scene : scenes_for_small_pictures()) {
    for (const auto& [cascades, degrees] : {std::pair(4, 0.53), {4, 2.0}, {4, 5.0}, {1, 2.0}}) {
      const Classes here =
          expect_decided_as_filtered(pictures_of(under_disc(drawn(scene, cascades, GetParam()), degrees)),
                                     scene + ", " + std::to_string(degrees) + " degrees");
      EXPECT_GT(here.lit + here.dark, 0) << scene << ", " << degrees;
      // Samples scatter by some hundredths, which are smoothed in one of the pictures.
      EXPECT_LT(here.apart / here.undecided, 0.06) << scene << ", " << degrees;
      all.add(here);
    }
  }
  EXPECT_GT(all.lit, 20000);
  EXPECT_GT(all.dark, 1000);
  // A tile has the planes of its quads of pixels, and the filter a plane for each pixel.
  EXPECT_LT(all.dark_at_creases, all.dark / 1000);
  EXPECT_GT(all.undecided, 20000);
}

// The maps are the pipeline's: any number of cascades in the atlas, and depths of 16 bits as well.
TEST_P(TiledPcss, DecidesOverEveryMapWhatTheFilterGives) {
  for (const scene::DepthFormat format : {scene::DepthFormat::d16, scene::DepthFormat::d32}) {
    Classes all;
    for (int cascades = 1; cascades <= 4; ++cascades) {
      const std::string what = (format == scene::DepthFormat::d16 ? "16" : "32") +
                               (" bits, " + std::to_string(cascades)) + " cascades";
      const Classes here = expect_decided_as_filtered(
          pictures_of(under_disc(drawn("street", cascades, GetParam(), format), 2.0)), what);
      EXPECT_GT(here.lit, 0) << what;
      EXPECT_GT(here.undecided, 0) << what;
      all.add(here);
    }
    EXPECT_GT(all.lit, 2000);
    EXPECT_GT(all.dark, 2000);
    EXPECT_LT(all.dark_at_creases, all.dark / 1000);
  }
}

// Four gathers of 4 texels for 4 x 4 texels of the map; two words for each block of 4, 16 and 64 texels.
// Four tiles are a group of 64 threads in DecideTiles.
TEST_P(TiledPcss, ReadsAndWritesInEachPassWhatItsPageSays) {
  const scene::Frame& frame = drawn("trees", 4, GetParam());
  const CameraImage camera = camera_image(frame, RowOrder::top_first);
  const GraphResult result =
      chain("tiled-pcss").run(FrameOnDevice(test_device(), frame), &camera, kCountedOnce);
  const double pixels = static_cast<double>(camera.width) * camera.height;
  const auto across = [](int size, int part) { return static_cast<double>((size + part - 1) / part); };
  const double tiles = across(camera.width, 8) * across(camera.height, 8);
  const double texels = static_cast<double>(frame.atlas.width) * frame.atlas.height;
  const auto named = [&](const std::string& name) {
    return *std::find_if(result.passes.begin(), result.passes.end(),
                         [&](const PassCounts& pass) { return pass.pass == name; });
  };
  const PassCounts bounds = named("Bounds");
  EXPECT_DOUBLE_EQ(bounds.bytes_read * pixels, 4.0 * texels);
  EXPECT_DOUBLE_EQ(bounds.bytes_written * pixels, texels * (8.0 / 16 + 8.0 / 256 + 8.0 / 4096));
  EXPECT_EQ(bounds.groups, texels / 4096);
  EXPECT_EQ(bounds.barriers_per_group, 6.0);
  const PassCounts decide = named("DecideTiles");
  EXPECT_DOUBLE_EQ(decide.bytes_written * pixels, 4.0 * tiles);
  EXPECT_EQ(decide.groups, across(camera.width, 16) * across(camera.height, 16));
  EXPECT_EQ(decide.barriers_per_group, 6.0);
  for (const char* name : {"FilterTiles", "SmoothNear", "SmoothFar"}) {
    EXPECT_DOUBLE_EQ(named(name).bytes_written, 4.0) << name;
    EXPECT_EQ(named(name).groups, tiles) << name;
    EXPECT_EQ(named(name).barriers_per_group, 0.0) << name;
    EXPECT_GE(named(name).bytes_read, 4.0) << name;
  }
  for (const PassCounts& pass : result.passes) EXPECT_EQ(pass.steps, 1) << pass.pass;
}

// Where the bounds say that no penumbra is wider than about a texel, nothing is searched: the picture does
// not depend on the number of samples, and four gathers of the map are all that a pixel takes.
TEST_P(TiledPcss, NarrowPenumbraeAreNotSearched) {
  const scene::Frame frame = under_disc(drawn("street", 4, GetParam()), 0.005);
  const CameraImage camera = camera_image(frame, RowOrder::top_first);
  const FrameOnDevice on_device(test_device(), frame);
  const GraphResult few = chain("tiled-pcss").run(on_device, &camera, kCountedOnce);
  const GraphResult many = chain("preset-ultra").run(on_device, &camera, kCountedOnce);
  EXPECT_EQ(few.visibility[0], many.visibility[0]);
  EXPECT_THAT(few.visibility[0], testing::Contains(testing::AllOf(testing::Gt(0.1F), testing::Lt(0.9F))));
  double filtered = 0.0;
  for (const float of_tile : picture_of(chain("tiled-pcss", true), frame)) filtered += of_tile < 0.0F ? 1 : 0;
  EXPECT_GT(filtered, 500.0);
  const auto fetches = [](const GraphResult& result) {
    return std::find_if(result.passes.begin(), result.passes.end(),
                        [](const PassCounts& pass) { return pass.pass == "FilterTiles"; })
        ->fetches;
  };
  EXPECT_EQ(fetches(few), fetches(many));
  // Besides its tile, a filtered pixel reads the depth of the camera at most six times: two gathers, and two
  // more pixels along each axis at edges.
  const auto pixels = static_cast<double>(few.visibility[0].size());
  EXPECT_LE(fetches(few) * pixels, pixels + (4.0 + 6.0) * filtered);
}

// Pixels of a border between cascades may read the next one: their tiles are not decided, and all are
// filtered.
TEST_P(TiledPcss, FiltersTheBorderBetweenCascades) {
  scene::Frame frame = drawn("trees", 4, GetParam());
  const int without_border = expect_decided_as_filtered(pictures_of(frame), "trees").undecided;
  frame.settings.cascade_choices.blend = {0.3, false};
  const Classes classes = expect_decided_as_filtered(pictures_of(frame), "trees with a border");
  EXPECT_GT(classes.lit, 0);
  EXPECT_GT(classes.undecided, without_border);
}

// With static noise the picture is the same each time: nothing depends on the order of threads.
TEST_P(TiledPcss, DrawsTheSamePictureAgain) {
  const scene::Frame frame = under_disc(drawn("street", 4, GetParam()), 2.0);
  EXPECT_EQ(pictures_of(frame).tiled, pictures_of(frame).tiled);
}

using Changes = std::array<float, kCascades>;  // by a poisoned tile of each cascade

// Returns the cascade of each pixel as far as the changes tell it, else kCascades.
std::vector<std::size_t> poisoned_cascades(const std::vector<Changes>& changes) {
  std::vector<std::size_t> cascades;
  for (const Changes& of_pixel : changes) {
    const auto largest = std::max_element(of_pixel.begin(), of_pixel.end());
    cascades.push_back(*largest > 0.5F ? static_cast<std::size_t>(largest - of_pixel.begin()) : kCascades);
  }
  return cascades;
}

// Returns whether pixels of two cascades lie among those that are smoothed into a pixel.
bool is_in_border(const std::vector<std::size_t>& cascades, std::size_t width, std::size_t pixel) {
  constexpr std::size_t reach = 4;  // of SmoothNear and SmoothFar together
  const std::size_t height = cascades.size() / width;
  const std::size_t column = pixel % width;
  const std::size_t row = pixel / width;
  std::set<std::size_t> near;
  for (std::size_t y = std::max(row, reach) - reach; y < std::min(row + reach + 1, height); ++y)
    for (std::size_t x = std::max(column, reach) - reach; x < std::min(column + reach + 1, width); ++x)
      near.insert(cascades[y * width + x]);
  near.erase(kCascades);
  return near.size() > 1;
}

// The texels of a cascade's tile may be anything, far, near or NaN. Pixels that read another cascade hardly
// change: a block of the bounds may hold texels of both, so that the search is wider and its samples lie
// elsewhere, and pixels at the border of two cascades are smoothed together.
TEST_P(TiledPcss, ReadsNoTexelOfOtherCascades) {
  GraphRunner& tiled = chain("tiled-pcss");
  for (const auto& [map_size, degrees] : {std::pair(0, 2.0), {528, 8.0}}) {
    SCOPED_TRACE(map_size);
    const scene::Frame frame =
        under_disc(drawn("street", kCascades, GetParam(), scene::DepthFormat::d32, map_size), degrees);
    const std::vector<float> picture = picture_of(tiled, frame);
    std::vector<Changes> changes(picture.size());
    for (std::size_t cascade = 0; cascade < kCascades; ++cascade)
      for (const float poison : {0.0F, 1.0F, std::numeric_limits<float>::quiet_NaN()}) {
        scene::Frame poisoned = frame;
        fill_tile(poisoned, static_cast<int>(cascade), poison);
        const std::vector<float> after = picture_of(tiled, poisoned);
        for (std::size_t i = 0; i < after.size(); ++i) {
          EXPECT_TRUE(after[i] >= 0.0F && after[i] <= 1.0F) << "pixel " << i << ": " << after[i];
          changes[i].at(cascade) = std::max(changes[i].at(cascade), std::abs(after[i] - picture[i]));
        }
      }
    const std::vector<std::size_t> cascades = poisoned_cascades(changes);
    const auto width = static_cast<std::size_t>(frame.settings.width);
    int changed = 0;
    int noisy = 0;
    int wrong = 0;
    for (std::size_t i = 0; i < changes.size(); ++i) {
      Changes& of_pixel = changes[i];
      std::sort(of_pixel.begin(), of_pixel.end(), std::greater<>());
      changed += of_pixel[0] > 0.5F ? 1 : 0;
      noisy += of_pixel[1] > 0.05F ? 1 : 0;
      wrong += of_pixel[1] > 0.1F && !is_in_border(cascades, width, i) ? 1 : 0;
    }
    const int pixels = static_cast<int>(changes.size());
    EXPECT_GT(changed, pixels / 4);
    EXPECT_LT(noisy, pixels / 100);
    EXPECT_EQ(wrong, 0) << "a texel of another cascade taken for a blocker changes it by up to 1";
  }
}

// At half resolution the picture differs by noise and smoothing alone where tiles are not decided.
TEST_P(TiledPcss, HasTheSamePenumbraeAtHalfResolution) {
  for (const auto& [scene, degrees] : {std::pair("street", 0.53), {"trees", 2.0}, {"slabs", 5.0}}) {
    const scene::Frame frame = under_disc(drawn(scene, 4, GetParam()), degrees);
    const std::vector<float> classes = picture_of(chain("tiled-pcss", true), frame);
    const std::vector<float> full = picture_of(chain("tiled-pcss"), frame);
    const std::vector<float> half = picture_of(chain("tiled-pcss-half"), frame);
    double apart = 0.0;
    int undecided = 0;
    for (std::size_t i = 0; i < full.size(); ++i) {
      if (classes[i] >= 0.0F) continue;
      ++undecided;
      apart += std::abs(static_cast<double>(half[i] - full[i]));
    }
    EXPECT_GT(undecided, 500) << scene;
    EXPECT_LT(apart / undecided, 0.04) << scene;
  }
}

// There are two cameras side by side: each eye's picture is that which the kernels draw for it alone.
TEST_P(TiledPcss, DrawsBothEyesAtOnceAsEachAlone) {
  for (const char* name : {"tiled-pcss", "tiled-pcss-half"}) {
    ShadowGraph of_both_eyes = library_graph(name, GetParam());
    of_both_eyes.keywords.emplace_back("_PENUMBRA_BOTH_EYES");
    for (techniques::GraphTexture& texture : of_both_eyes.graph.textures)
      if (texture.extent == techniques::ExtentOf::screen) texture.layers = 2;
    GraphRunner runner(test_device(), compile(of_both_eyes));
    const scene::Frame frame = under_disc(drawn("street", 4, GetParam()), 2.0);
    const scene::Frame other = under_disc(drawn("slabs", 4, GetParam()), 2.0);
    const CameraImage left = camera_image(frame, RowOrder::top_first);
    // The right eye has a picture of its own: what another camera sees of another scene, as the same map
    // would shadow it.
    const CameraImage right = camera_image(other, RowOrder::top_first);
    const FrameOnDevice on_device(test_device(), frame);
    const auto alone = [&](const CameraImage& eye) {
      return chain(name).run(on_device, &eye, kOnce).visibility[0];
    };
    RunOptions options = kOnce;
    options.second_eye = &right;
    const std::vector<float> both = runner.run(on_device, &left, options).visibility[0];
    std::vector<float> expected = alone(left);
    const std::vector<float> second = alone(right);
    EXPECT_NE(expected, second);
    expected.insert(expected.end(), second.begin(), second.end());
    EXPECT_EQ(both, expected) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(BothDirections, TiledPcss, testing::Bool(), direction_name);

}  // namespace
}  // namespace penumbra::resolve
