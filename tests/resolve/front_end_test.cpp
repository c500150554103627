// Compares every technique from FXC's bytecode, as Unity compiles it, with glslang's modules: the same
// picture, the same fetches.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "as_identifier.h"
#include "fxc/at_hand.h"
#include "resolve/compiler.h"
#include "resolve/drawn_scenes.h"
#include "resolve/graph_runner.h"
#include "resolve/ground_at_random.h"
#include "shaders/bytecode_module.h"

namespace penumbra::resolve {
namespace {

// FXC multiplies and adds in one step, in another order, and reads a texture where its value is first needed.
// Where that is all, pictures differ by the last bits of a float.
constexpr double kRounding = 1e-5;
constexpr double kVisible = 1e-4;        // pixels that differ by more have more than rounding
constexpr double kVisibleShare = 0.025;  // share of the pixels, where a technique magnifies rounding
// This share holds in the scenes beside the colonnade, where a hash of a large sine turns the disks of more
// pixels.
constexpr double kVisibleShareElsewhere = 0.16;

struct Magnified {
  const char* technique;
  double largest;  // difference of a pixel
};

constexpr Magnified kMagnified[] = {
    // These are moments, whose differences are much smaller than they are: a last bit is magnified, most
    // where four of them are solved. With FXC's IEEE strictness, which keeps products and sums apart,
    // moments-16 and mssm-mip-16 differ by 5e-5 at most, while moments-32 and mssm-sat-32 differ by more than
    // without it.
    {"exponential-variance-16", 1e-3},
    {"moments-32", 0.3},
    {"moments-16", 5e-3},
    {"variance-quarter", 5e-3},
    {"vssm-sat-32", 5e-3},
    {"mssm-sat-32", 1e-3},
    {"mssm-mip-16", 0.02},
    {"evsm-mip", 5e-4},
    // These hash the pixel by the fraction of a large sine.
    {"godot-pcss-8", 5e-3},
    {"godot-pcss-8-half-diameter", 1e-3},
    {"godot-pcss-32", 5e-3},
    // These have arc functions, which FXC writes out as polynomials.
    {"far-horizon", 1e-3},
    {"blob", 0.02}};

// In the scenes beside the colonnade more is magnified. A ray, a sample's surface or a disk may be decided
// the other way at a pixel.
constexpr Magnified kElsewhere[] = {{"moments-32", 0.7},
                                    {"moments-16", 0.02},
                                    {"variance-quarter", 0.03},
                                    {"vssm-sat-32", 0.03},
                                    {"mssm-sat-32", 0.02},
                                    {"evsm-mip", 0.04},
                                    {"godot-pcss-8", 1.0},
                                    {"godot-pcss-8-half-diameter", 0.05},
                                    {"godot-pcss-32", 0.07},
                                    {"unreal-smrt-7-8", 1.0 / 7.0 + kRounding},
                                    {"screen-pcss-angular-24-16-edges", 0.5},
                                    {"tiled-pcss", 1e-3},
                                    {"tiled-pcss-half", 1e-3},
                                    {"pcss-bounded-16-16", 1e-4},
                                    {"preset-low", 1e-3},
                                    {"preset-medium", 1e-3},
                                    {"preset-high", 1e-3},
                                    {"preset-ultra", 1e-3},
                                    {"screen-high-trace", 1e-3},
                                    {"screen-high-trace-far-heights-clouds", 1e-3},
                                    {"far-heights-8", 1e-4},
                                    {"far-heights-32", 1e-4},
                                    {"far-heights-64", 1e-4},
                                    {"pcss-angular-24-16-far-horizon", 1e-3},
                                    {"pcss-angular-24-16-far-horizon-clouds", 1e-3}};

// These passes fetch otherwise, by such a share at most. The modules that count are glslang's before
// optimisation: FXC does not read what a path does not need.
struct Fetching {
  const char* pass;
  double share;
};
constexpr Fetching kFetching[] = {
    {"FarShadows", 0.05},       {"ConservativeMask", 0.01}, {"filter", 0.08},  // vssm-sat-32 has this share
    {"FilterUnrealSmrt", 2e-5},                                                // a ray may end a step earlier
    {"MarkSamples", 0.002},  // a sample's surface is decided otherwise
    {"MarkSurfaces", 0.02},  // a comparison of depths decides otherwise
    {"ShadePixels", 5e-4},      {"ShadeSamples", 0.01},     {"MeanOfSamples", 0.001}};

// In the scenes beside the colonnade more is fetched otherwise.
constexpr Fetching kFetchingElsewhere[] = {
    {"FarShadows", 0.2},    {"FarShadowsAlone", 1e-4}, {"ConservativeMask", 0.05},
    {"MarkSurfaces", 0.03}, {"ShadePixels", 1e-3},     {"ResolveAlone", 1e-4},
    {"Upsample", 5e-4},     {"ScreenTrace", 3e-4},     {"FilterGodotPcss", 1e-4}};

constexpr const char* kUsualScene = "colonnade";

double largest_difference(const std::string& technique, const std::string& scene) {
  double largest = kRounding;
  for (const Magnified& one : kMagnified)
    if (technique == one.technique) largest = one.largest;
  if (scene == kUsualScene) return largest;
  for (const Magnified& one : kElsewhere)
    if (technique == one.technique) largest = one.largest;
  return largest;
}

double share_of_fetches(const std::string& pass, const std::string& scene) {
  double share = 0.0;
  for (const Fetching& one : kFetching)
    if (pass == one.pass) share = one.share;
  if (scene == kUsualScene) return share;
  for (const Fetching& one : kFetchingElsewhere)
    if (pass == one.pass) share = one.share;
  return share;
}

// The test takes one scene, or all that fit small pictures: those take a quarter of an hour.
std::vector<std::string> scenes() {
  if (std::getenv("PENUMBRA_EVERY_SCENE") != nullptr)  // NOLINT(concurrency-mt-unsafe)
    return scenes_for_small_pictures();
  return {kUsualScene};
}

class FrontEnds : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    PENUMBRA_NEEDS_FXC();
    if (!shaders::translates_bytecode()) GTEST_SKIP() << "built without vkd3d-shader (libvkd3d-dev)";
  }

  static GraphRunner runner(const Compiler& compiler) {
    const ShadowGraph graph = technique_graph(library_techniques(), library_techniques().find(GetParam()));
    return GraphRunner(test_device(), compile(graph, compiler));
  }

  static GraphResult result(GraphRunner& runner, const std::string& name) {
    const scene::Scene scene = scene::built_in(name);
    CastersOnDevice casters(test_device(), scene);
    casters.add_volumes(test_device(), scene);
    const FrameInputs inputs = ground_at_random();
    const scene::Frame& frame = drawn(name, 3, true);
    const FrameOnDevice on_device(test_device(), frame, &casters, &inputs);
    const CameraImage camera = camera_image(frame);
    // The modules that count are FXC's and glslang's with the same additions: the driver compiles no others.
    return runner.run(on_device, &camera, {.noise_seeds = 0, .timing_repeats = 0, .count_fetches = true});
  }
};

void expect_same_picture(const std::vector<float>& a, const std::vector<float>& b, double largest,
                         double visible_share) {
  ASSERT_EQ(a.size(), b.size());
  double worst = 0.0;
  std::size_t visible = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
    worst = std::max(worst, difference);
    visible += difference > kVisible ? 1 : 0;
  }
  EXPECT_LE(worst, largest);
  if (worst > kVisible) std::cout << "largest difference " << worst << '\n';
  EXPECT_LE(static_cast<double>(visible), visible_share * static_cast<double>(a.size()));
  testing::Test::RecordProperty("largest_difference", std::to_string(worst));
}

void expect_the_same(const GraphResult& by_fxc, const GraphResult& by_glslang, const std::string& technique,
                     const std::string& scene) {
  EXPECT_EQ(by_fxc.unset_uniforms, by_glslang.unset_uniforms);
  expect_same_picture(by_fxc.visibility.front(), by_glslang.visibility.front(),
                      largest_difference(technique, scene),
                      scene == kUsualScene ? kVisibleShare : kVisibleShareElsewhere);
  ASSERT_EQ(by_fxc.passes.size(), by_glslang.passes.size());
  for (std::size_t i = 0; i < by_fxc.passes.size(); ++i) {
    const PassCounts& ours = by_fxc.passes[i];
    const PassCounts& theirs = by_glslang.passes[i];
    const double share = share_of_fetches(ours.pass, scene);
    EXPECT_NEAR(ours.fetches, theirs.fetches, share * theirs.fetches) << ours.pass;
    EXPECT_NEAR(ours.texels_written, theirs.texels_written, share * theirs.texels_written) << ours.pass;
    EXPECT_EQ(ours.invocations, theirs.invocations) << ours.pass;
  }
}

TEST_P(FrontEnds, DrawTheSamePicture) {
  Compiler compiler;
  // One compiler serves all, because techniques share programs.
  static const BytecodeCompiler by_fxc_once = bytecode_by_fxc(fxc::require_fxc());
  compiler.fxc = by_fxc_once;
  GraphRunner by_glslang = runner({});
  GraphRunner by_fxc = runner(compiler);
  for (const std::string& scene : scenes()) {
    SCOPED_TRACE(scene);
    expect_the_same(result(by_fxc, scene), result(by_glslang, scene), GetParam(), scene);
  }
}

std::vector<std::string> all_techniques() {
  std::vector<std::string> names;
  for (const techniques::Technique& technique : library_techniques().techniques)
    names.push_back(technique.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Library, FrontEnds, testing::ValuesIn(all_techniques()),
                         [](const auto& instance) { return as_identifier(instance.param); });

}  // namespace
}  // namespace penumbra::resolve
