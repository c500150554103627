// Tests the penumbra mask through the package's .shader on drawn scenes: what it marks, how it widens, and
// what the resolve pass makes of it.
#include <gmock/gmock.h>

#include <cmath>
#include <glm/trigonometric.hpp>

#include "as_identifier.h"
#include "resolve/drawn_scenes.h"
#include "resolve/hand_graph.h"
#include "resolve/kept_runners.h"
#include "resolve/run_once.h"

namespace penumbra::resolve {
namespace {

constexpr int kBlock = 4;

struct Case {
  std::string scene;
  int cascades;
  bool reversed_z;
  RowOrder rows;
};

void PrintTo(const Case& value, std::ostream* stream) {
  *stream << value.scene << ", " << value.cascades << " cascades";
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const std::string& scene : scenes_for_small_pictures()) {
    cases.push_back({scene, 4, true, RowOrder::top_first});
    cases.push_back({scene, 1, false, RowOrder::bottom_first});
  }
  return cases;
}

int blocks(int pixels) {
  return (pixels + kBlock - 1) / kBlock;
}

class ScreenMask : public testing::TestWithParam<Case> {
 protected:
  ScreenMask()
      : frame_(drawn(GetParam().scene, GetParam().cascades, GetParam().reversed_z)),
        on_device_(test_device(), frame_),
        camera_(camera_image(frame_, GetParam().rows)) {}

  const techniques::Technique& technique(const std::string& name) const {
    return library_techniques().find(name);
  }

  // The chains are kept, because their pipelines cost more than running them.
  GraphRunner& chain(const std::string& name) const {
    static KeptRunners runners;
    const bool reversed_z = GetParam().reversed_z;
    return runners.of(name, reversed_z, [&] {
      return technique_graph(library_techniques(), technique(name), Taps::as_listed, reversed_z);
    });
  }

  // The library's filter alone makes one comparison per pixel of the camera's image, in its own row order.
  std::vector<float> single_taps() const {
    scene::Frame seen = frame_;
    seen.receivers = SeenByDepth(camera_).receivers();
    const FrameOnDevice on_device(test_device(), seen);
    return GraphRunner(test_device(), compile(technique_shader(library_techniques(), technique("bilinear"),
                                                               Taps::as_listed, GetParam().reversed_z)))
        .run(on_device, kOnce)
        .visibility.front();
  }

  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * camera_.width + x); }

  const scene::Frame& frame_;
  FrameOnDevice on_device_;
  CameraImage camera_;
};

// The edges are those that single comparisons at four pixels of the block find, written out here.
std::vector<bool> edges_of(const std::vector<float>& taps, const CameraImage& camera) {
  const int columns[] = {1, 3, 0, 2};
  std::vector<bool> edges;
  for (int y = 0; y < blocks(camera.height); ++y) {
    for (int x = 0; x < blocks(camera.width); ++x) {
      bool lit = true;
      bool dark = true;
      for (int tap = 0; tap < 4; ++tap) {
        const int px = std::min(kBlock * x + columns[tap], camera.width - 1);
        const int py = std::min(kBlock * y + tap, camera.height - 1);
        const float visibility = taps[static_cast<std::size_t>(py * camera.width + px)];
        lit = lit && visibility > 0.998f;
        dark = dark && visibility < 0.002f;
      }
      edges.push_back(!lit && !dark);
    }
  }
  return edges;
}

TEST_P(ScreenMask, MarksTheBlocksWhoseComparisonsDisagree) {
  ShadowGraph graph = hand_graph({{"PenumbraMask", kBlock}, {"Resolve"}}, GetParam().reversed_z,
                                 technique("screen-tent-5-masked").all_keywords(), 0);
  graph.parameters = parameter_uniforms(library_techniques(), technique("screen-tent-5-masked"));
  const GraphResult result = GraphRunner(test_device(), compile(graph)).run(on_device_, &camera_, kOnce);
  const std::vector<std::uint8_t> masked_out =
      rows_from_top(result.masked_out, camera_.width, GetParam().rows);  // back to the image's order
  const std::vector<bool> edges = edges_of(single_taps(), camera_);
  int wrong = 0;
  int marked = 0;
  for (int y = 0; y < camera_.height; ++y) {
    for (int x = 0; x < camera_.width; ++x) {
      const bool edge = edges[static_cast<std::size_t>(y / kBlock * blocks(camera_.width) + x / kBlock)];
      wrong += edge == (masked_out[index(x, y)] == 0) ? 0 : 1;
      marked += edge ? 1 : 0;
    }
  }
  EXPECT_GT(marked, 100);
  // Positions differ by a hundredth of a millimetre, which a hardware filter near its end may show: two
  // blocks.
  EXPECT_LE(wrong, 2 * kBlock * kBlock);
}

// The metres per block, tile texels and depth range as the C++ side knows them.
class Widening {
 public:
  Widening(const scene::Frame& frame, const CameraImage& camera)
      : frame_(frame), camera_(camera), seen_(camera) {}

  // The radius in blocks at a pixel; absent where nothing is seen or no map reaches.
  std::optional<double> radius(int x, int y, double penumbra_metres, double filter_texels) const {
    const std::optional<double> depth = seen_.depth(x, y);
    if (!depth) return std::nullopt;
    const glm::dvec3 at = seen_.position(x, y, *depth);
    for (const parameters::Cascade& cascade : frame_.cascades.cascades) {
      const glm::dvec3 from_centre = at - glm::dvec3(cascade.split_sphere);
      const bool inside =
          frame_.cascades.cascades.size() == 1 || glm::length(from_centre) < cascade.split_sphere.w;
      if (!inside) continue;
      const double stored = (cascade.world_to_shadow * glm::dvec4(at, 1.0)).z;
      if (stored <= 0.0 || stored >= 1.0) return std::nullopt;
      const double gap = frame_.cascades.reversed_z ? 1.0 - stored : stored;
      const double tan_half = std::tan(glm::radians(frame_.settings.angular_diameter_degrees) / 2.0);
      const double of_light = std::min(tan_half * gap / cascade.depth_per_metre, penumbra_metres / 2.0);
      const double reach = std::max(of_light, filter_texels * cascade.texel_size_metres);
      const double right = glm::length(seen_.position(x + 1.0, y, *depth) - at);
      const double down = glm::length(seen_.position(x, y + 1.0, *depth) - at);
      return reach / (kBlock * std::min(right, down));
    }
    return std::nullopt;
  }

 private:
  const scene::Frame& frame_;
  const CameraImage& camera_;
  SeenByDepth seen_;
};

TEST_P(ScreenMask, WidensByTheReachOfThePenumbra) {
  const GraphResult result = chain("screen-tent-5-masked").run(on_device_, &camera_, kOnce);
  const std::vector<std::uint8_t> masked_out =
      rows_from_top(result.masked_out, camera_.width, GetParam().rows);
  const std::vector<bool> edges = edges_of(single_taps(), camera_);
  const Widening widening(frame_, camera_);
  const int columns = blocks(camera_.width);
  const int rows = blocks(camera_.height);
  // The radius of the tap that needs most, in whole blocks, rounded up; `slack` stands for the rounding of
  // the radius itself.
  const auto widened = [&](double slack) {
    std::vector<int> radii;
    const int tap_columns[] = {1, 3, 0, 2};
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        double radius = 0.0;
        for (int tap = 0; tap < 4; ++tap) {
          const int px = std::min(kBlock * x + tap_columns[tap], camera_.width - 1);
          const int py = std::min(kBlock * y + tap, camera_.height - 1);
          radius = std::max(radius, widening.radius(px, py, 0.0, 3.0).value_or(0.0));
        }
        radii.push_back(std::min(32, static_cast<int>(std::ceil(radius * (1.0 + slack)))));
      }
    }
    std::vector<bool> mask = edges;
    for (const bool horizontal : {true, false}) {
      std::vector<bool> next(mask.size());
      for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
          const auto at = static_cast<std::size_t>(y * columns + x);
          for (int i = -radii[at]; i <= radii[at]; ++i) {
            const int bx = x + (horizontal ? i : 0);
            const int by = y + (horizontal ? 0 : i);
            if (bx < 0 || by < 0 || bx >= columns || by >= rows) continue;
            next[at] = next[at] || mask[static_cast<std::size_t>(by * columns + bx)];
          }
        }
      }
      mask = next;
    }
    return mask;
  };
  const std::vector<bool> narrow = widened(-1e-4);
  const std::vector<bool> wide = widened(1e-4);
  int wrong = 0;
  int saved = 0;
  for (int y = 0; y < camera_.height; ++y) {
    for (int x = 0; x < camera_.width; ++x) {
      const auto block = static_cast<std::size_t>(y / kBlock * columns + x / kBlock);
      const bool marked = masked_out[index(x, y)] == 0;
      wrong += (marked && !wide[block]) || (!marked && narrow[block]) ? 1 : 0;
      saved += marked ? 0 : 1;
    }
  }
  EXPECT_GT(saved, 0);
  EXPECT_LE(wrong, 100) << "an edge that only one side found, and its surroundings";
}

TEST_P(ScreenMask, ResolvesPenumbraeInFullAndTheRestByOneComparison) {
  for (const char* name : {"screen-tent-5", "screen-pcss-angular-24-16"}) {
    const GraphResult whole = chain(name).run(on_device_, &camera_, kCountedOnce);
    const GraphResult masked = chain(std::string(name) + "-masked").run(on_device_, &camera_, kCountedOnce);
    const std::vector<float> taps = rows_from_top(single_taps(), camera_.width, GetParam().rows);
    int apart = 0;
    int outside = 0;
    for (std::size_t i = 0; i < taps.size(); ++i) {
      if (frame_.receivers.position_ws[i].w == 0.0f) {
        ASSERT_EQ(masked.visibility[0][i], 1.0f);
        continue;
      }
      if (masked.masked_out[i] == 0) {
        ASSERT_EQ(masked.visibility[0][i], whole.visibility[0][i]) << name;
        ASSERT_EQ(masked.fetches[i], whole.fetches[i] + 1) << name;
        continue;
      }
      ++outside;
      apart += std::abs(masked.visibility[0][i] - taps[i]) > 0.01f ? 1 : 0;
      // A pixel reads mask, depth and comparison; it makes no comparison past the last cascade.
      ASSERT_LE(masked.fetches[i], 3u) << name;
      ASSERT_GE(masked.fetches[i], 2u) << name;
    }
    EXPECT_GT(outside, 0) << name;
    EXPECT_LE(apart, 4) << name;
  }
}

// There is half a fetch for the taps, and for each blur there are its depths and at most two reads a step.
TEST_P(ScreenMask, CostsLittle) {
  const GraphResult result = chain("screen-tent-5-masked").run(on_device_, &camera_, kCountedOnce);
  const double share =
      double(blocks(camera_.width)) * blocks(camera_.height) / (camera_.width * camera_.height);
  ASSERT_EQ(result.passes.size(), 4u);
  EXPECT_LE(result.passes[0].fetches, 8.0 * share);
  EXPECT_LE(result.passes[1].fetches, (4.0 + 65.0) * share);
  EXPECT_NEAR(result.fetches_of_others,
              result.passes[0].fetches + result.passes[1].fetches + result.passes[2].fetches, 1e-9);
  std::vector<double> written;
  for (const PassCounts& pass : result.passes) written.push_back(pass.texels_written);
  EXPECT_EQ(written, (std::vector<double>{share, share, share, 1.0}));
}

INSTANTIATE_TEST_SUITE_P(Package, ScreenMask, testing::ValuesIn(all_cases()), [](const auto& instance) {
  return as_identifier(instance.param.scene + (instance.param.reversed_z ? "_reversed" : "_conventional"));
});

}  // namespace
}  // namespace penumbra::resolve
