// Compares the resolve pass of the package's own .shader with the library's filter alone, on every built-in
// scene: with an asymmetric lens, either row order, either depth direction, one to four cascades; and with
// maps of fewer bits, of which URP's has 16 unless the project says otherwise.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <memory>

#include "as_identifier.h"
#include "reference/trace_visibility.h"
#include "resolve/drawn_scenes.h"
#include "resolve/graph_runner.h"
#include "resolve/hand_graph.h"
#include "resolve/run_once.h"
#include "techniques/technique_call.h"

namespace penumbra::resolve {
namespace {

struct Case {
  std::string technique;
  std::string keyword;
  bool reversed_z;
};

void PrintTo(const Case& value, std::ostream* stream) {
  *stream << value.technique << (value.reversed_z ? ", reversed Z" : ", conventional Z");
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const auto& [technique, keyword] :
       {std::pair("tent-3-plane", "_PENUMBRA_TENT_3X3"), std::pair("tent-5-plane", "_"),
        std::pair("tent-7-plane", "_PENUMBRA_TENT_7X7"), std::pair("pcss-angular-24-16", "_PENUMBRA_PCSS"),
        std::pair("pcss-poisson-25", "_PENUMBRA_PCSS_POISSON"),
        std::pair("pcss-angular-24-16-hdrp", "_PENUMBRA_PCSS_HDRP")}) {
    for (const bool reversed_z : {true, false}) cases.push_back({technique, keyword, reversed_z});
  }
  for (const techniques::Technique& technique : library_techniques().techniques) {
    if (!technique.name.starts_with("screen-pcss-") && !technique.name.starts_with("fallback-")) continue;
    const std::string keyword = technique.keywords.empty() ? "_" : technique.keywords.front();
    for (const bool reversed_z : {true, false}) cases.push_back({technique.name, keyword, reversed_z});
  }
  return cases;
}

class ScreenResolve : public testing::TestWithParam<Case> {
 protected:
  ScreenResolve()
      : technique_(library_techniques().find(GetParam().technique)),
        library_(test_device(), has_maps()
                                    ? compile(technique_graph(library_techniques(), technique_,
                                                              Taps::as_listed, GetParam().reversed_z))
                                    : compile(technique_shader(library_techniques(), technique_,
                                                               Taps::as_listed, GetParam().reversed_z))),
        package_(test_device(), compile(graph())) {}

  ShadowGraph graph() const {
    ShadowGraph graph = hand_graph({{"Resolve"}}, GetParam().reversed_z, {GetParam().keyword});
    if (has_maps()) draw_maps_first(graph.graph);
    graph.parameters = parameter_uniforms(library_techniques(), technique_);
    return graph;
  }

  bool has_maps() const {
    return technique_.graph.filter_pass() != nullptr && technique_.graph.passes.size() > 1;
  }

  // Draws the passes before the technique's filter, whose maps Resolve reads by their names.
  void draw_maps_first(techniques::PassGraph& graph) const {
    const techniques::PassGraph& own = technique_.graph;
    graph.textures.insert(graph.textures.end(), own.textures.begin(), own.textures.end());
    for (const techniques::GraphTexture& texture : own.textures)
      if (own.filter()->takes(texture.name))
        graph.passes.back().reads.emplace_back(techniques::argument_name(texture.name), texture.name);
    graph.passes.insert(graph.passes.begin(), own.passes.begin(), own.passes.end());
    std::erase_if(graph.passes, [](const auto& pass) { return pass.kind == techniques::PassKind::filter; });
  }

  std::vector<float> by_shader(const scene::Frame& frame, RowOrder rows) {
    const FrameOnDevice on_device(test_device(), frame);
    const RunOptions options{.noise_seeds = 1, .timing_repeats = 0};
    const CameraImage camera = camera_image(frame, rows);
    const GraphResult result = package_.run(on_device, &camera, options);
    EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());
    return result.visibility.front();
  }

  std::vector<float> by_library(const scene::Frame& frame) {
    const FrameOnDevice on_device(test_device(), frame);
    return library_.run(on_device, kOnce).visibility.front();
  }

  // The answers of the library's filter over what the depth image tells, found without a shader.
  std::vector<float> by_library_from_depth(const scene::Frame& frame, RowOrder rows,
                                           float lifted_metres = 0.0f) {
    const CameraImage camera = camera_image(frame, rows);
    scene::Frame seen = frame;
    seen.receivers = SeenByDepth(camera).receivers();
    for (std::vector<glm::vec4>* positions : {&seen.receivers.position_ws, &seen.receivers.position_relative})
      for (glm::vec4& position : *positions) position.y += lifted_metres;
    return rows_from_top(by_library(seen), camera.width, rows);
  }

  const techniques::Technique& technique_;
  GraphRunner library_;
  GraphRunner package_;
};

struct Difference {
  int pixels = 0;
  int above = 0;  // pixels that differ by more than the threshold
  double rms = 0.0;
};

Difference difference(const std::vector<float>& a, const std::vector<float>& b, const scene::Frame& frame,
                      double threshold) {
  Difference result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (frame.receivers.position_ws[i].w == 0.0f) continue;
    const double d = std::abs(double(a[i]) - b[i]);
    ++result.pixels;
    result.above += d > threshold ? 1 : 0;
    result.rms += d * d;
  }
  result.rms = std::sqrt(result.rms / std::max(1, result.pixels));
  return result;
}

void expect_the_same(const std::vector<float>& by_pass, const std::vector<float>& by_depth,
                     const scene::Frame& frame, const std::string& what) {
  const Difference d = difference(by_pass, by_depth, frame, 0.01);
  ASSERT_GT(d.pixels, 3000) << what;
  // Both sides round the same depth to a position once, but in float there and in double here: a hundredth of
  // a millimetre. Where a shadow texel's edge lies in between, a whole tap changes.
  EXPECT_LE(d.above, 4) << what;
  EXPECT_LE(d.rms, 0.005) << what;
}

// The same picture with its rows the other way round: noise goes by the row that a pixel is stored in.
scene::Frame in_order(scene::Frame frame, RowOrder rows) {
  scene::Receivers& seen = frame.receivers;
  for (std::vector<glm::vec4>* image : {&seen.position_ws, &seen.position_relative, &seen.normal_ws}) {
    *image = rows_from_top(*image, seen.width, rows);
  }
  return frame;
}

double rmse(const std::vector<float>& visibility, const reference::VisibilityImage& t1) {
  double squares = 0.0;
  int pixels = 0;
  for (std::size_t i = 0; i < visibility.size(); ++i) {
    if (t1.valid[i] == 0 || t1.visibility[i] < 0.02f || t1.visibility[i] > 0.98f) continue;
    squares += std::pow(double(visibility[i]) - t1.visibility[i], 2);
    ++pixels;
  }
  return std::sqrt(squares / std::max(1, pixels));
}

// The light and the receivers are the same for every map.
const reference::VisibilityImage& traced(const std::string& scene) {
  static std::map<std::string, reference::VisibilityImage> images;
  const auto [image, is_new] = images.try_emplace(scene);
  if (is_new) {
    const scene::Scene built_in = scene::built_in(scene);
    const scene::Frame& frame = drawn(scene, 4, true);
    image->second = reference::trace_visibility(
        built_in, frame.receivers, {built_in.light_direction, frame.settings.angular_diameter_degrees},
        {.samples = 128});
  }
  return image->second;
}

// A technique in both depth directions meets every scene with every count of cascades; in one direction,
// every scene and every count, each with both row orders.
bool meets(std::size_t scene, int cascades, bool reversed_z) {
  return (scene + static_cast<std::size_t>(cascades)) % 2 == (reversed_z ? 1U : 0U);
}

RowOrder row_order(std::size_t scene, int cascades) {
  const bool top = (scene / 2 + static_cast<std::size_t>((cascades - 1) / 2)) % 2 == 0;
  return top ? RowOrder::top_first : RowOrder::bottom_first;
}

// One drawing gives both: the picture, and how far it is from ray tracing.
TEST_P(ScreenResolve, DrawsWhatTheFilterAloneSaysAndIsAsFarFromRayTracing) {
  const std::vector<std::string> scenes = scenes_for_small_pictures();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    for (int cascades = 1; cascades <= 4; ++cascades) {
      if (!meets(i, cascades, GetParam().reversed_z)) continue;
      const scene::Frame& frame = drawn(scenes[i], cascades, GetParam().reversed_z);
      const RowOrder rows = row_order(i, cascades);
      const std::string what = scenes[i] + ", " + std::to_string(cascades) + " cascades, " +
                               (rows == RowOrder::top_first ? "top row first" : "bottom row first");
      const std::vector<float> by_pass = by_shader(frame, rows);
      const std::vector<float> by_depth = by_library_from_depth(frame, rows);
      expect_the_same(by_pass, by_depth, frame, what);

      const reference::VisibilityImage& t1 = traced(scenes[i]);
      EXPECT_NEAR(rmse(by_pass, t1), rmse(by_depth, t1), 0.0005) << what;
      // The filter alone is told each surface's normal. The pass has to find it in the depths beside the
      // pixel, and finds another on edges and on grass blades a pixel wide. That must cost next to nothing:
      // at most 0.0018 on lavapipe, and 0.0021 on an NVIDIA H100, which rounds edges in another way.
      const std::vector<float> told =
          rows_from_top(by_library(in_order(frame, rows)), frame.receivers.width, rows);
      EXPECT_LE(rmse(by_pass, t1), rmse(told, t1) + 0.0025) << what;
    }
  }
}

// There is one technique that compares and one that reads the depths themselves.
class ScreenResolveOfFewerBits : public ScreenResolve {};

TEST_P(ScreenResolveOfFewerBits, DrawsWhatTheFilterAloneSays) {
  const bool reversed_z = GetParam().reversed_z;
  for (const scene::DepthFormat format : {scene::DepthFormat::d16, scene::DepthFormat::d24}) {
    const std::string what = format == scene::DepthFormat::d16 ? "16 bits" : "24 bits";
    const scene::Frame& frame = drawn("trees", 4, reversed_z, format);
    ASSERT_NE(frame.atlas.depth, drawn("trees", 4, reversed_z).atlas.depth) << what;
    expect_the_same(by_shader(frame, RowOrder::top_first), by_library_from_depth(frame, RowOrder::top_first),
                    frame, what);
  }
}

class ScreenResolveOfBlendedCascades : public ScreenResolve {};

TEST_P(ScreenResolveOfBlendedCascades, DithersAsTheFilterAloneDoes) {
  scene::Frame frame = drawn("trees", 4, GetParam().reversed_z);
  const std::vector<float> plain = by_shader(frame, RowOrder::top_first);
  frame.settings.cascade_choices.blend = {.border = 0.25, .mixed = false};
  const std::vector<float> dithered = by_shader(frame, RowOrder::top_first);
  expect_the_same(dithered, by_library_from_depth(frame, RowOrder::top_first), frame, "dithered");
  EXPECT_GT(difference(dithered, plain, frame, 0.01).above, 100) << "pixels that read the next cascade";
}

// The cases are every technique that the renderer feature offers, with the passes that make its maps, but for
// those whose passes draw the visibility themselves.
class ScreenResolveOfEveryChoice : public ScreenResolve {};

TEST_P(ScreenResolveOfEveryChoice, DrawsWhatTheFilterAloneSays) {
  const scene::Frame& frame = drawn("trees", 4, GetParam().reversed_z);
  const std::vector<float> by_pass = by_shader(frame, RowOrder::top_first);
  const std::vector<float> by_depth = by_library_from_depth(frame, RowOrder::top_first);
  const Difference d = difference(by_pass, by_depth, frame, 0.01);
  ASSERT_GT(d.pixels, 3000);
  if (d.above <= 4) return;
  // Where moments of 32 bits are solved, rounding is enlarged: as many pixels may differ as change when all
  // surfaces are moved by what both sides round.
  int enlarged = 0;
  for (const float metres : {1e-5f, -1e-5f})
    enlarged = std::max(
        enlarged,
        difference(by_library_from_depth(frame, RowOrder::top_first, metres), by_depth, frame, 0.01).above);
  EXPECT_LE(d.above, 4 + enlarged);
}

// The directions of depth take turns: all_cases() has one technique of each kind in both.
std::vector<Case> every_choice() {
  std::vector<Case> cases;
  bool reversed_z = false;
  for (const techniques::Selection& selection : library_techniques().selections) {
    if (!selection.value || selection.draws_visibility) continue;
    const std::string keyword = selection.keyword.empty() ? "_" : selection.keyword;
    reversed_z = !reversed_z;
    cases.push_back({selection.technique, keyword, reversed_z});
    if (!selection.technique_16_bits.empty())
      cases.push_back({selection.technique_16_bits, keyword, reversed_z});
  }
  return cases;
}

std::string case_name(const testing::TestParamInfo<Case>& instance) {
  return as_identifier(instance.param.technique +
                       (instance.param.reversed_z ? "_reversed" : "_conventional"));
}

INSTANTIATE_TEST_SUITE_P(Package, ScreenResolve, testing::ValuesIn(all_cases()), case_name);
INSTANTIATE_TEST_SUITE_P(Package, ScreenResolveOfEveryChoice, testing::ValuesIn(every_choice()), case_name);
INSTANTIATE_TEST_SUITE_P(Package, ScreenResolveOfFewerBits,
                         testing::Values(Case{"tent-5-plane", "_", true}, Case{"tent-5-plane", "_", false},
                                         Case{"pcss-angular-24-16", "_PENUMBRA_PCSS", true},
                                         Case{"pcss-angular-24-16", "_PENUMBRA_PCSS", false}),
                         case_name);
INSTANTIATE_TEST_SUITE_P(Package, ScreenResolveOfBlendedCascades,
                         testing::Values(Case{"tent-5-plane", "_", true},
                                         Case{"pcss-angular-24-16", "_PENUMBRA_PCSS", false}),
                         case_name);

}  // namespace
}  // namespace penumbra::resolve
