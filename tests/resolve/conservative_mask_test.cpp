// Compares the conservative mask with the filter that it saves: what it decides is what the filter gives, bit
// for bit, over the built-in scenes and for groups of random receivers above maps of every kind.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

#include "resolve/drawn_scenes.h"
#include "resolve/graph_runner.h"
#include "resolve/probe_graph.h"
#include "resolve/run_once.h"
#include "resolve/synthetic_frame.h"

namespace penumbra::resolve {
namespace {

using testing_frames::FrameSetup;
using testing_frames::TexelDepth;
using testing_frames::TilePoint;

class ConservativeMask : public testing::TestWithParam<bool> {
 protected:
  static double depth(double distance) { return GetParam() ? 1.0 - distance : distance; }

  static GraphRunner& chain(const std::string& name) {
    static KeptRunners runners;
    return runners.of(name, GetParam(), [&] { return library_graph(name, GetParam()); });
  }

  struct Decided {
    int lit = 0;
    int dark = 0;
    int filtered = 0;
    int partly = 0;  // visibility is between lit and dark
  };

  static void expect_same_picture(const scene::Frame& frame, const std::string& what, Decided& decided) {
    const CameraImage camera = camera_image(frame, RowOrder::top_first);
    const FrameOnDevice on_device(test_device(), frame);
    const GraphResult whole = chain("screen-pcss-angular-24-16").run(on_device, &camera, kCountedOnce);
    const GraphResult masked =
        chain("screen-pcss-angular-24-16-conservative").run(on_device, &camera, kCountedOnce);
    for (std::size_t i = 0; i < whole.fetches.size(); ++i) {
      const float seen = whole.visibility[0][i];
      ASSERT_EQ(masked.visibility[0][i], seen) << what << ", pixel " << i;
      const bool skipped = masked.masked_out[i] != 0;
      ASSERT_EQ(masked.fetches[i], skipped ? 1u : whole.fetches[i] + 1) << what << ", pixel " << i;
      decided.filtered += skipped ? 0 : 1;
      decided.partly += seen > 0.0f && seen < 1.0f ? 1 : 0;
      if (skipped) (seen == 1.0f ? decided.lit : decided.dark) += 1;
    }
  }
};

TEST_P(ConservativeMask, ChangesNoPixelOfAnyScene) {
  Decided all;
  for (const std::string& scene : scenes_for_small_pictures()) {
    for (const auto& [cascades, degrees] : {std::pair(4, 0.53), {4, 2.0}, {4, 5.0}, {1, 2.0}}) {
      Decided here;
      expect_same_picture(under_disc(drawn(scene, cascades, GetParam()), degrees),
                          scene + ", " + std::to_string(degrees) + " degrees", here);
      EXPECT_GT(here.lit + here.dark, 0) << scene << ", " << degrees;
      EXPECT_GT(here.partly, 0) << scene << ", " << degrees;
      all.lit += here.lit;
      all.dark += here.dark;
      all.filtered += here.filtered;
    }
  }
  EXPECT_GT(all.lit, 20000);
  EXPECT_GT(all.dark, 2000);
  EXPECT_GT(all.filtered, 20000);
}

// Pixels of a border between cascades may read the next one, of which a block's planes say nothing.
TEST_P(ConservativeMask, ChangesNoPixelWhereCascadesAreDithered) {
  scene::Frame frame = drawn("trees", 4, GetParam());
  frame.settings.cascade_choices.blend = {0.3, false};
  Decided decided;
  expect_same_picture(frame, "trees", decided);
  EXPECT_GT(decided.lit, 0);
  EXPECT_GT(decided.filtered, 0);
}

// The map has every depth, NaN and infinities among them; walls, roofs and slopes are beside it.
class Surroundings {
 public:
  explicit Surroundings(bool reversed) : reversed_(reversed) {}

  float operator()(double u, double v, int tile) const {
    if (v > 0.9) return rough(u, v, tile);
    if (v > 0.45 && v < 0.55) return stored(0.5 + 0.3 * u + 0.2 * v);
    if (u < 0.4) return stored(v < 0.5 ? 1.0 : 0.8);
    if (u > 0.6) return stored(v < 0.5 ? 0.3 : 0.2 + 0.1 * u);
    const double heights[] = {1.0, 1.0, 0.7, 0.4, 0.2};
    return stored(heights[engine(std::floor(u * 32.0), std::floor(v * 32.0), tile)() % 5u]);
  }

 private:
  static std::minstd_rand engine(double u, double v, int tile) {
    std::minstd_rand engine(static_cast<unsigned>(u) * 977u + static_cast<unsigned>(v) * 31u +
                            static_cast<unsigned>(tile) + 1u);
    engine.discard(3);
    return engine;
  }
  float stored(double distance) const { return static_cast<float>(reversed_ ? 1.0 - distance : distance); }
  static float rough(double u, double v, int tile) {
    std::minstd_rand random = engine(u * 9973.0, v * 7919.0, tile);
    const auto kind = random() % 50u;
    if (kind == 0) return std::numeric_limits<float>::quiet_NaN();
    if (kind == 1) return std::numeric_limits<float>::infinity();
    return std::generate_canonical<float, 24>(random);
  }

  bool reversed_;
};

// The groups are of four: a receiver, and three around it whose depths and planes are, or are not, those of
// its plane. The decision is compared with the filter at each: 1 is lit, 0.75 dark, 0.5 not decided, 0 wrong.
constexpr const char* kGroupOfFour = R"(
    const float3 kind = frac(receiver.shadowCoord * float3(12289.0, 6151.0, 3079.0));
    PcssAngularParameters parameters;
    parameters.blockerSamples = 24;
    parameters.filterSamples = 16;
    parameters.blockerClump = 0.0;
    parameters.minFilterTexels = kind.x > 0.5 ? 1.25 : 0.25;
    parameters.maxPenumbraMetres = kind.y > 0.5 ? 0.5 : 100.0;
    parameters.maxSamplingMetres = frac(4.0 * kind.x) > 0.5 ? 0.2 : 1000.0;
    ShadowReceiver each[4];
    ReceiverGroup group = GroupOf(PrepareQuads(receiver, tile));
    each[0] = receiver;
    for (int i = 1; i < 4; ++i)
    {
        const float3 random = frac(receiver.shadowCoord * float3(9973.0, 7919.0, 6101.0) * float(i)) - 0.5;
        const float2 away = 16.0 * random.xy * tile.atlasTexelSize.xy;
        each[i] = receiver;
        each[i].rotation = receiver.rotation.yx;
        each[i].shadowCoord.xy += away;
        each[i].shadowCoord.z += dot(receiver.depthGradient, away);
        if (kind.z > 0.5)
        {
            each[i].shadowCoord.z += 0.002 * random.z;
            each[i].depthGradient += 0.4 * random.yx;
        }
        group = JoinGroup(group, PrepareQuads(each[i], tile));
    }
    const float decided = DecideAngular(_PenumbraDepthPlanesTexture, group, ConeScalesOf(tile), parameters, true);
    if (decided < 0.0) return 0.5;
    for (int k = 0; k < 4; ++k)
    {
        const float filtered = FilterPcssAngular(TEXTURE2D_SHADOW_ARGS(_ShadowMap, sampler_ShadowMap), sampler_PointClamp,
                                                 each[k], tile, parameters);
        if (filtered != decided) return 0.0;
    }
    return decided > 0.5 ? 1.0 : 0.75;
)";

TEST_P(ConservativeMask, DecidesRightForAMillionReceivers) {
  constexpr int kSide = 250;
  ShadowGraph graph = probe_graph("single-loop-32-planes", kGroupOfFour, GetParam());
  graph.filter->body.insert(graph.filter->body.find("#include \"Core/ShadowStructs.hlsl\""),
                            "#include \"Filters/Decisions/GroupDecision.hlsl\"\n");
  GraphRunner runner(test_device(), compile(graph));
  std::minstd_rand engine(77);
  const auto random = [&](double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 32>(engine);
  };
  int lit = 0, dark = 0, open = 0;
  for (const int cascade : {0, 1, 2, 3}) {
    FrameSetup setup;
    setup.shadows.cascades = 4;
    setup.shadows.resolution =
        cascade == 3 ? 2048 : 512;  // the last cascade's planes have large terms; it has the widest discs
    setup.shadows.reversed_z = GetParam();
    setup.light.angular_diameter_degrees = cascade == 3 ? 30.0 : random(0.5, 12.0);
    setup.cascade = cascade;
    std::vector<TilePoint> receivers;
    for (int i = 0; i < kSide * kSide; ++i)
      receivers.emplace_back(random(0.0, 1.0), random(0.0, 1.0), random(0.0, 1.0));
    scene::Frame frame = testing_frames::make_frame(setup, Surroundings(GetParam()), receivers, kSide);
    for (glm::vec4& normal : frame.receivers.normal_ws) {
      const double tilt = std::pow(10.0, random(-3.0, 1.5));
      const glm::dvec3 aside(random(-1.0, 1.0), random(-1.0, 1.0), random(-1.0, 1.0));
      normal = glm::vec4(glm::vec3(glm::normalize(glm::dvec3(normal) + tilt * aside)), 0.0f);
    }
    const GraphResult result = runner.run(FrameOnDevice(test_device(), frame), kCountedOnce);
    for (std::size_t i = 0; i < receivers.size(); ++i) {
      const float answer = result.visibility[0][i];
      ASSERT_NE(answer, 0.0f) << "cascade " << cascade << ", group " << i;
      lit += answer == 1.0f ? 1 : 0;
      dark += answer == 0.75f ? 1 : 0;
      open += answer == 0.5f ? 1 : 0;
    }
  }
  EXPECT_EQ(lit + dark + open, 4 * kSide * kSide);
  EXPECT_GT(lit, 25000);
  EXPECT_GT(dark, 5000);
  EXPECT_GT(open, 25000);
}

INSTANTIATE_TEST_SUITE_P(BothDirections, ConservativeMask, testing::Bool(), direction_name);

}  // namespace
}  // namespace penumbra::resolve
