// Tests the adapter for HDRP's own PCSS, on stand-ins for HDRP's files: what it hands to HDRP, and that the
// answer comes back.
#include <gmock/gmock.h>

#include <cmath>

#include "input/input_error_matcher.h"
#include "parameters/shader_uniforms.h"
#include "platform/data_directory.h"
#include "resolve/graph_runner.h"
#include "resolve/synthetic_frame.h"
#include "resolve/test_device.h"

namespace penumbra::resolve {
namespace {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::Gt;
using testing::Lt;
using testing_frames::FrameSetup;
using testing_frames::TilePoint;

constexpr int kTexels = 1024;
constexpr int kBlockerSamples = 24;
constexpr int kFilterSamples = 16;
constexpr double kReceiverDepth = 0.5;

// The adapter on the HDRP stand-in without further keywords: version 14.
Adapter adapter_on_hdrp_14() {
  const std::filesystem::path root = platform::data_directory();
  const std::filesystem::path stand_ins = root / "tools" / "programs" / "shaders" / "unity";
  Adapter hdrp;
  hdrp.name = "hdrp-pcss";
  hdrp.file = root / "tools" / "measurement" / "resolve" / "adapters" / "HdrpPcss.hlsl";
  hdrp.package_roots = {{"com.penumbra.shadows", root}};
  for (const char* package :
       {"com.unity.render-pipelines.core", "com.unity.render-pipelines.high-definition"}) {
    hdrp.package_roots.push_back({package, stand_ins / package});
  }
  return hdrp;
}

Adapter adapter_with_normal_bias(const std::vector<std::string>& keywords = {}) {
  Adapter hdrp = adapter_on_hdrp_14();
  hdrp.keywords = keywords;
  hdrp.keywords.push_back("STAND_IN_HDRP_17");
  return hdrp;
}

// Receivers stay where they are.
Adapter adapter(const std::vector<std::string>& keywords = {}) {
  Adapter hdrp = adapter_with_normal_bias(keywords);
  hdrp.keywords.push_back("HDRP_NO_NORMAL_BIAS");
  return hdrp;
}

FrameSetup four_cascades(double degrees, int cascade = 0) {
  FrameSetup setup;
  setup.light.angular_diameter_degrees = degrees;
  setup.shadows.cascades = 4;
  setup.shadows.resolution = kTexels;
  setup.cascade = cascade;
  return setup;
}

parameters::Cascade chosen(const FrameSetup& setup) {
  return parameters::fit_cascades(setup.camera, setup.light, setup.shadows)
      .cascades.at(static_cast<std::size_t>(setup.cascade));
}

// A caster stands left of the tile's middle, some metres over the receivers, which stand at the given tile U.
// There is nothing else.
scene::Frame half_plane(const FrameSetup& setup, double metres_above, const std::vector<double>& us) {
  const auto caster = static_cast<float>(kReceiverDepth + metres_above * chosen(setup).depth_per_metre);
  const auto map = [=](double u, double, int tile) {
    return tile == setup.cascade && u < 0.5 ? caster : testing_frames::farthest_depth(true);
  };
  std::vector<TilePoint> receivers;
  for (const double u : us) receivers.emplace_back(u, 0.25, kReceiverDepth);
  return testing_frames::make_frame(setup, map, receivers, static_cast<int>(receivers.size()));
}

GraphResult run(const Adapter& hdrp, const scene::Frame& frame, int seeds = 1) {
  const FrameOnDevice on_device(test_device(), frame);
  return GraphRunner(test_device(), compile(adapter_shader(hdrp)))
      .run(on_device, {.noise_seeds = seeds, .timing_repeats = 0, .count_fetches = true});
}

TEST(HdrpAdapter, LitIsOneAndShadowedIsZeroInEveryCascadeAndFetchesAreCounted) {
  for (int cascade = 0; cascade < 4; ++cascade) {
    const scene::Frame frame = half_plane(four_cascades(0.53, cascade), 1.0, {0.1, 0.9});
    const GraphResult result = run(adapter(), frame);
    EXPECT_THAT(result.visibility.at(0), ElementsAre(0.0f, 1.0f)) << cascade;
    EXPECT_THAT(result.fetches, ElementsAre(kBlockerSamples + kFilterSamples, kBlockerSamples)) << cascade;
    EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());
  }
}

// HDRP takes m00 / m22 for the radius in tiles, twice what the light's disc makes.
TEST(HdrpAdapter, ThePenumbraIsTwiceAsWideAsTheLightMakesItUntilItsCap) {
  constexpr double kMetresAbove = 4.0;
  constexpr double kWidestRadius = 0.56;  // HDRP's default
  for (const double degrees : {2.0, 4.0, 20.0}) {
    const FrameSetup setup = four_cascades(degrees);
    const parameters::Cascade cascade = chosen(setup);
    const double geometric = parameters::tan_half_of(degrees) * kMetresAbove;
    const double radius = std::min(2.0 * geometric, kWidestRadius) * cascade.uv_per_metre;
    const double outside = radius + 2.0 * setup.shadows.cascades / kTexels;
    const GraphResult result =
        run(adapter(), half_plane(setup, kMetresAbove,
                                  {0.5 - outside, 0.5 - 0.8 * radius, 0.5 + 0.8 * radius, 0.5 + outside}));
    EXPECT_THAT(result.visibility.at(0),
                ElementsAre(0.0f, AllOf(Gt(0.0f), Lt(0.5f)), AllOf(Gt(0.5f), Lt(1.0f)), 1.0f))
        << degrees;
  }
}

TEST(HdrpAdapter, TheShaderDataIsWhatHdrpPacks) {
  constexpr int kNumbers = 12;
  const FrameSetup setup = four_cascades(2.0);
  const scene::Frame frame = testing_frames::make_frame(
      setup, [](double, double, int) { return 0.0f; },
      std::vector<TilePoint>(4 * kNumbers, TilePoint(0.5, 0.5, kReceiverDepth)), kNumbers);
  const GraphResult result = run(adapter_with_normal_bias({"STAND_IN_TELLS_DATA"}), frame);

  parameters::SoftShadowParameters defaults;
  defaults.angular_diameter_degrees = 2.0;
  defaults.blocker_clump = 2.0;
  defaults.min_filter_texels = 1.5;
  defaults.max_penumbra_metres = 0.56;
  defaults.max_sampling_metres = 0.5;
  for (std::size_t i = 0; i < frame.cascades.cascades.size(); ++i) {
    const parameters::Cascade& cascade = frame.cascades.cascades[i];
    const parameters::HdrpVectors packed = parameters::hdrp_vectors(cascade, defaults);
    const double expected[kNumbers] = {packed.params0.x,
                                       packed.params0.y,
                                       packed.params0.z,
                                       packed.params0.w,
                                       packed.params1.x,
                                       packed.params1.y,
                                       packed.params1.z,
                                       packed.params1.w,
                                       kBlockerSamples,
                                       kFilterSamples,
                                       std::sqrt(2.0) * cascade.texel_size_metres,
                                       0.75};
    for (std::size_t k = 0; k < kNumbers; ++k) {
      const auto told = static_cast<double>(result.visibility.at(0).at(i * kNumbers + k));
      EXPECT_NEAR(told, expected[k], 1e-5 * std::abs(expected[k])) << "cascade " << i << ", number " << k;
    }
  }
}

TEST(HdrpAdapter, TheNormalBiasMovesTheReceiver) {
  // Caster and receiver are a third of a texel apart along the light, which is the receivers' normal.
  const FrameSetup setup = four_cascades(2.0);
  const scene::Frame frame = half_plane(setup, chosen(setup).texel_size_metres / 3.0, {0.1});
  EXPECT_THAT(run(adapter(), frame).visibility.at(0), ElementsAre(0.0f));
  EXPECT_THAT(run(adapter_with_normal_bias(), frame).visibility.at(0), ElementsAre(1.0f));
}

TEST(HdrpAdapter, TheFrameOfTheNoiseReachesHdrp) {
  const GraphResult result = run(adapter(), half_plane(four_cascades(4.0), 4.0, {0.49, 0.5, 0.51}), 2);
  EXPECT_NE(result.visibility.at(0), result.visibility.at(1));
}

TEST(HdrpAdapter, OutsideAllSpheresIsLitWithoutAskingHdrp) {
  constexpr double kMetresFromCentre = 100.0;
  scene::Frame frame = half_plane(four_cascades(2.0), 1.0, {0.1});
  glm::dvec4& sphere = frame.cascades.cascades.at(0).split_sphere;
  const glm::dvec3 receiver(frame.receivers.position_ws.at(0));
  const auto with_radius = [&](double metres) {
    sphere = glm::dvec4(receiver + glm::dvec3(kMetresFromCentre, 0.0, 0.0), metres);
    return run(adapter(), frame);
  };
  EXPECT_THAT(with_radius(1.1 * kMetresFromCentre).visibility.at(0), ElementsAre(0.0f));
  const GraphResult outside = with_radius(0.9 * kMetresFromCentre);
  EXPECT_THAT(outside.visibility.at(0), ElementsAre(1.0f));
  EXPECT_THAT(outside.fetches, Each(0u));
}

TEST(HdrpAdapter, ConventionalDepthIsRefused) {
  expect_input_error([&] { compile(adapter_shader(adapter(), false)); },
                     HasSubstrs("HdrpPcss.hlsl", "--reversed-z true"));
}

TEST(HdrpAdapter, AnOlderHdrpIsRefusedWithTheVersionItTakes) {
  expect_input_error([&] { compile(adapter_shader(adapter_on_hdrp_14())); },
                     HasSubstrs("dirLightPCSSParams0", "HDRP has it since 17"));
}

}  // namespace
}  // namespace penumbra::resolve
