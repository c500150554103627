// Tests the way from the manifests to passes, and runs every technique that runs over the screen from end to
// end.
#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "as_identifier.h"
#include "input/input_error_matcher.h"
#include "resolve/drawn_scenes.h"
#include "resolve/graph_runner.h"
#include "resolve/ground_at_random.h"
#include "resolve/hand_graph.h"
#include "resolve/run_once.h"

namespace penumbra::resolve {
namespace {

TEST(ScreenTechnique, PassesAreThoseOfTheShaderInItsOrder) {
  const shaders::PackageShader shader(shaders::package_shader_file());
  EXPECT_EQ(shader.pass_names(),
            (std::vector<std::string>{"PenumbraMask", "MaskBlurHorizontal", "MaskBlurVertical", "Resolve",
                                      "DenoiseHorizontal", "DenoiseVertical", "ConservativeMask"}));
}

TEST(ScreenTechnique, APassThatIsNotThereIsNamedWithTheNearest) {
  expect_input_error(
      [&] { compile_pass(shaders::PackageShader(shaders::package_shader_file()), "Resolv", {}, true); },
      HasSubstrs("PenumbraShadows.shader", "no pass 'Resolv'", "did you mean 'Resolve'?"));
}

// The message names the pass and the texture.
TEST(ScreenTechnique, AbsentTexturesAreThoseOfTheProgramAlone) {
  const FrameOnDevice on_device(test_device(), drawn("trees", 4, true));
  const CameraImage camera = camera_image(drawn("trees", 4, true));
  const auto refusal = [&](const std::string& name) -> std::string {
    ShadowGraph graph = hand_graph({{"Resolve"}});
    graph.graph.passes[0].absent.push_back(name);
    return input_error_of([&] { GraphRunner(test_device(), compile(graph)).run(on_device, &camera, kOnce); });
  };
  EXPECT_THAT(refusal("_PenumbraMaskTexure"),
              testing::HasSubstr(
                  "'Resolve' lists '_PenumbraMaskTexure' as absent, and its program reads no such texture"));
  EXPECT_THAT(
      refusal("_CameraDepthTexture"),
      testing::HasSubstr("'Resolve' lists '_CameraDepthTexture' as absent, which every pass is given"));
}

// The pixels drawn at half size are those that the whole resolve draws where they stand, and upsampling
// leaves them.
TEST(ScreenTechnique, HalfResolutionKeepsThePixelsItSaw) {
  const scene::Frame& frame = drawn("trees", 4, true);
  const FrameOnDevice on_device(test_device(), frame);
  const CameraImage camera = camera_image(frame);
  const GraphResult full =
      GraphRunner(test_device(), compile(hand_graph({{"Resolve"}}))).run(on_device, &camera, kCountedOnce);
  const GraphResult half =
      GraphRunner(test_device(), compile(hand_graph({{"Resolve", 2}, {"Resolve", 1, true}})))
          .run(on_device, &camera, kCountedOnce);
  for (int y = 1; y < camera.height; y += 2) {
    for (int x = 1; x < camera.width; x += 2) {
      const auto at = static_cast<std::size_t>(y * camera.width + x);
      ASSERT_EQ(half.visibility[0][at], full.visibility[0][at]) << x << ", " << y;
      ASSERT_EQ(4.0f * half.fetches_of_others_at[at], static_cast<float>(full.fetches[at]))
          << "a quarter of a texel's";
    }
  }
  EXPECT_LT(half.passes[0].fetches, 0.3 * full.passes[0].fetches);
  EXPECT_EQ(half.fetches_of_others, half.passes[0].fetches);
}

// Between pixels that differ widely the filter itself runs; few of those see too many surfaces to do so.
TEST(ScreenTechnique, HalfResolutionComputesWhatLiesOnAnEdge) {
  const scene::Frame& frame = drawn("trees", 4, true);
  const FrameOnDevice on_device(test_device(), frame);
  const CameraImage camera = camera_image(frame);
  const auto visibility = [&](std::vector<HandPass> passes) {
    return GraphRunner(test_device(), compile(hand_graph(std::move(passes))))
        .run(on_device, &camera, kOnce)
        .visibility[0];
  };
  const std::vector<float> full = visibility({{"Resolve"}});
  const std::vector<float> half = visibility({{"Resolve", 2}, {"Resolve", 1, true}});
  int edges = 0;
  int computed = 0;
  for (int y = 1; y + 2 < camera.height; y += 2) {
    for (int x = 1; x + 2 < camera.width; x += 2) {
      const auto at = [&](int right, int down) {
        return static_cast<std::size_t>((y + down) * camera.width + x + right);
      };
      const auto [lowest, highest] =
          std::minmax({full[at(0, 0)], full[at(2, 0)], full[at(0, 2)], full[at(2, 2)]});
      if (highest - lowest < 0.5f) continue;
      ++edges;
      if (half[at(1, 1)] == full[at(1, 1)]) ++computed;
    }
  }
  EXPECT_GT(edges, 50);
  EXPECT_GT(computed, 0.75 * edges) << "of " << edges;
}

struct ScreenCase {
  std::string technique;
  bool reversed_z;
};

// The directions of depth take turns, since the techniques of a family have their programs in common.
std::vector<ScreenCase> screen_cases() {
  std::vector<ScreenCase> cases;
  for (const techniques::Technique& technique : library_techniques().techniques)
    if (technique.graph.over_screen()) cases.push_back({technique.name, cases.size() % 2 == 0});
  return cases;
}

class EveryScreenTechnique : public testing::TestWithParam<ScreenCase> {};

TEST_P(EveryScreenTechnique, StaysInRangeOverCamerasThatSeeRubbish) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const scene::Scene colonnade = scene::built_in("colonnade");
  CastersOnDevice casters(test_device(), colonnade);
  casters.add_volumes(test_device(), colonnade);
  const FrameInputs inputs = ground_at_random();
  const auto& [technique, reversed_z] = GetParam();
  GraphRunner runner(test_device(),
                     compile(technique_graph(library_techniques(), library_techniques().find(technique),
                                             Taps::as_listed, reversed_z)));
  const scene::Frame& frame = drawn("colonnade", 3, reversed_z);
  const FrameOnDevice on_device(test_device(), frame, &casters, &inputs);
  for (const RowOrder rows : {RowOrder::top_first, RowOrder::bottom_first}) {
    CameraImage camera = camera_image(frame, rows);
    const GraphResult right = runner.run(on_device, &camera, kOnce);
    EXPECT_THAT(right.unset_uniforms, testing::IsEmpty());
    EXPECT_THAT(right.visibility[0], testing::Each(testing::AllOf(testing::Ge(0.0f), testing::Le(1.0f))));
    const float rubbish[] = {nan, -nan, infinity, -infinity, -1.0f, 2.0f, 0.0f, 1.0f, 1e-30f};
    for (std::size_t i = 0; i < camera.depth.size(); i += 3) camera.depth[i] = rubbish[i % 9];
    const GraphResult broken = runner.run(on_device, &camera, kOnce);
    EXPECT_THAT(broken.visibility[0], testing::Each(testing::AllOf(testing::Ge(0.0f), testing::Le(1.0f))));
  }
}

INSTANTIATE_TEST_SUITE_P(Library, EveryScreenTechnique, testing::ValuesIn(screen_cases()),
                         [](const auto& instance) { return as_identifier(instance.param.technique); });

}  // namespace
}  // namespace penumbra::resolve
