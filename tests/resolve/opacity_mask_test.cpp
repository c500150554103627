// Tests the map of blended casters (Shaders/PenumbraOpacity.shader) and the filters that read it
// (ShaderLibrary/Filters/Opacity/OpacityMask.technique.json): the product of what stacked sheets transmit, in
// whatever order they are drawn, and what is dimmed by it.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "resolve/kept_runners.h"
#include "resolve/map_receivers.h"
#include "resolve/run_once.h"

namespace penumbra::resolve {
namespace {

using testing_frames::place_receivers;
using testing_frames::position_at;

constexpr int kMapSize = 64;

// A horizontal sheet over all x from `from` on, and all of z.
struct Sheet {
  float height;
  float alpha;  // negative alpha means opaque
  float from = -300.0F;
};

scene::Scene sheets(const std::vector<Sheet>& stack) {
  scene::Scene scene;
  scene.name = "sheets";
  scene.light_direction = scene::sunlight(60.0, 25.0);
  scene.camera = scene::camera_looking({0.0, 2.0, -9.0}, {0.0, 0.5, 0.0});
  scene.shadow_distance_metres = 30.0;
  scene.materials.clear();
  for (const Sheet& sheet : stack) {
    const auto first = static_cast<std::uint32_t>(scene.mesh.positions.size());
    for (const glm::vec2 corner : {glm::vec2(sheet.from, -300), glm::vec2(300, -300), glm::vec2(300, 300),
                                   glm::vec2(sheet.from, 300)}) {
      scene.mesh.positions.emplace_back(corner.x, sheet.height, corner.y);
      scene.mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
    }
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) scene.mesh.indices.push_back(first + corner);
    const auto material = static_cast<std::uint16_t>(scene.materials.size());
    scene.mesh.triangle_materials.insert(scene.mesh.triangle_materials.end(), 2, material);
    scene.materials.emplace_back();
    if (sheet.alpha >= 0.0F)
      scene.materials.back().cut_out =
          scene::CutOut{.factor = sheet.alpha, .mode = scene::AlphaMode::blended};
  }
  return scene;
}

// The opacity is 1 less the product of what those transmit that lie over the texel, above its highest opaque
// one.
long double opacity_over(const std::vector<Sheet>& stack, const scene::Frame& frame, int x, int y) {
  const glm::dvec3 near = position_at(frame, x, y, 0.0), far = position_at(frame, x, y, 1.0);
  const auto covers = [&](const Sheet& sheet) {
    const double way = (sheet.height - near.y) / (far.y - near.y);
    return near.x + way * (far.x - near.x) > sheet.from;
  };
  double highest = -1e9;
  for (const Sheet& sheet : stack)
    if (sheet.alpha < 0.0F && covers(sheet)) highest = std::max(highest, double{sheet.height});
  long double through = 1.0L;
  for (const Sheet& sheet : stack)
    if (sheet.alpha >= 0.0F && covers(sheet) && sheet.height > highest) through *= 1.0L - sheet.alpha;
  return 1.0L - through;
}

class OpacityMask : public testing::TestWithParam<bool> {
 protected:
  static std::vector<float> run(const techniques::TechniqueList& list, const std::string& technique,
                                const scene::Scene& scene, const scene::Frame& frame) {
    GraphRunner runner(test_device(),
                       compile(technique_graph(list, list.find(technique), Taps::as_listed, GetParam())));
    const CastersOnDevice casters(test_device(), scene);
    return runner.run(FrameOnDevice(test_device(), frame, &casters), kOnce).visibility[0];
  }

  static std::vector<float> mask(const scene::Scene& scene, const scene::Frame& frame) {
    static const techniques::TechniqueList list =
        techniques::read_technique_list(std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests" / "resolve" /
                                        "samples" / "ReadOpacity.technique.json");
    return run(list, "opacity", scene, frame);
  }

  // The frame's receivers are at that height, on the texels' rays.
  static scene::Frame frame_of(const scene::Scene& scene, double height) {
    scene::Frame frame = testing_frames::map_of(scene, kMapSize, GetParam());
    place_receivers(frame, [&](int x, int y) {
      const double near = position_at(frame, x, y, 0.0).y, far = position_at(frame, x, y, 1.0).y;
      return (height - near) / (far - near);
    });
    return frame;
  }

  static std::vector<float> seen(const std::string& technique, const std::vector<Sheet>& stack,
                                 double height) {
    const scene::Scene scene = sheets(stack);
    return run(library_techniques(), technique, scene, frame_of(scene, height));
  }
};

TEST_P(OpacityMask, IsOneLessTheProductInAnyOrder) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> alpha(0.0F, 0.9F), place(-4.0F, 4.0F);
  for (int draw = 0; draw < 3; ++draw) {
    std::vector<Sheet> stack{{2.0F, -1.0F, 1.0F}};
    for (int i = 0; i < 6; ++i)
      stack.push_back({1.0F + 0.5F * static_cast<float>(i) + 0.1F, alpha(random), place(random)});
    const scene::Frame frame = frame_of(sheets(stack), 0.5);
    std::vector<float> first;
    for (int order = 0; order < 3; ++order) {
      std::shuffle(stack.begin(), stack.end(), random);
      const std::vector<float> texels = mask(sheets(stack), frame);
      int off = 0;
      for (int y = 0; y < kMapSize; ++y)
        for (int x = 0; x < kMapSize; ++x) {
          const float texel = texels[static_cast<std::size_t>(y * kMapSize + x)];
          off += std::abs(texel - double(opacity_over(stack, frame, x, y))) < 1e-6 ? 0 : 1;
        }
      EXPECT_LT(off, kMapSize) << "texels whose centre an edge is at";
      for (std::size_t i = 0; i < first.size(); ++i) ASSERT_NEAR(texels[i], first[i], 1e-6);
      first = texels;
    }
    EXPECT_GT(*std::max_element(first.begin(), first.end()),
              *std::min_element(first.begin(), first.end()) + 0.1F);
  }
}

TEST_P(OpacityMask, AlphaThatMakesNoSenseStaysBetween0And1) {
  for (const auto& [alpha, wanted] : {std::pair{7.0F, 1.0F}, {1.0F, 1.0F}, {0.0F, 0.0F}}) {
    const scene::Scene scene = sheets({{2.0F, alpha}});
    EXPECT_THAT(mask(scene, frame_of(scene, 0.5)), testing::Each(wanted)) << alpha;
  }
}

TEST_P(OpacityMask, IsEmptyOfOpaqueCastersAndFiltersAreThenTheirBases) {
  const std::vector<Sheet> opaque{{2.0F, -1.0F, 1.0F}, {4.0F, -1.0F, 2.5F}};
  const scene::Scene scene = sheets(opaque);
  EXPECT_THAT(mask(scene, frame_of(scene, 0.5)), testing::Each(0.0F));
  for (const char* base : {"single-loop-32", "pcss-angular-24-16"}) {
    const std::vector<float> without = seen(base, opaque, 0.5);
    EXPECT_EQ(seen(base + std::string("-opacity"), opaque, 0.5), without) << base;
    EXPECT_THAT(without, testing::Contains(0.0F));
    EXPECT_THAT(without, testing::Contains(testing::AllOf(testing::Gt(0.0F), testing::Lt(1.0F))));
  }
}

// RDR2's mask has no depth: a roof above the smoke is dimmed by it.
TEST_P(OpacityMask, ReceiversAboveBlendedCastersAreLitWithTheirDepth) {
  const std::vector<Sheet> stack{{1.0F, 0.4F}, {2.0F, 0.5F}};
  EXPECT_THAT(seen("pcss-angular-24-16-opacity", stack, 3.0), testing::Each(1.0F));
  EXPECT_THAT(seen("single-loop-32-opacity", stack, 3.0), testing::Each(testing::FloatNear(0.3F, 1e-5F)));
  for (const char* technique : {"pcss-angular-24-16-opacity", "single-loop-32-opacity"})
    EXPECT_THAT(seen(technique, stack, 0.5), testing::Each(testing::FloatNear(0.3F, 1e-5F))) << technique;
}

// Across an edge the shadow goes from nothing to the sheet's own, also where a lower one is below the
// receiver.
TEST_P(OpacityMask, AnEdgeIsSoftAndNotThatOfWhatIsBelow) {
  for (const std::vector<Sheet>& stack :
       {std::vector<Sheet>{{6.0F, 0.5F, 0.0F}}, {{6.0F, 0.5F, 0.0F}, {1.0F, 0.5F}}}) {
    const float dark = stack.size() == 1 ? 0.5F : 0.25F;
    const std::vector<float> visibility = seen("pcss-angular-24-16-opacity", stack, 2.0);
    const auto between = [&](float low, float high) {
      return std::count_if(visibility.begin(), visibility.end(),
                           [=](float v) { return v > low && v < high; });
    };
    EXPECT_EQ(between(-1.0F, dark - 1e-4F), 0);
    EXPECT_GT(between(dark - 1e-4F, dark + 1e-4F), 10 * kMapSize);
    EXPECT_GT(between(0.99999F, 1.1F), 10 * kMapSize);
    EXPECT_GT(between(dark + 0.1F, 0.7F), kMapSize / 4);
    EXPECT_GT(between(0.8F, 0.99F), kMapSize / 4) << "at the rim";
  }
}

INSTANTIATE_TEST_SUITE_P(Depth, OpacityMask, testing::Bool(), direction_name);

}  // namespace
}  // namespace penumbra::resolve
