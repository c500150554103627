// Every filter for spot lights must do this, in one slice of an atlas in perspective: the right answer where
// there is one, no NaN, nothing outside [0, 1], nothing learnt from outside the slice.
#include <gmock/gmock.h>

#include <bit>
#include <limits>
#include <map>
#include <memory>

#include "as_identifier.h"
#include "resolve/kept_runners.h"
#include "resolve/run_once.h"
#include "resolve/spot_frame.h"

namespace penumbra::resolve {
namespace {

using testing_frames::grid;
using testing_frames::kColumns;
using testing_frames::kReceiver;
using testing_frames::lamp;
using testing_frames::positions;
using testing_frames::SpotPoint;
using testing_frames::SpotSetup;
using testing_frames::TexelDepth;
using testing_frames::world_position;

struct Case {
  std::string technique;
  bool reversed_z;
};

void PrintTo(const Case& value, std::ostream* stream) {
  *stream << value.technique << (value.reversed_z ? ", reversed Z" : ", conventional Z");
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const techniques::Technique& technique : library_techniques().techniques) {
    if (!technique.is_for(techniques::LightKind::spot)) continue;
    cases.push_back({technique.name, true});
    cases.push_back({technique.name, false});
  }
  return cases;
}

class EverySpotFilter : public testing::TestWithParam<Case> {
 protected:
  SpotSetup setup() const { return lamp(GetParam().reversed_z); }
  float nearest() const { return testing_frames::nearest_depth(GetParam().reversed_z); }
  float farthest() const { return testing_frames::farthest_depth(GetParam().reversed_z); }
  const techniques::Technique& technique() const { return library_techniques().find(GetParam().technique); }

  static float stored(const SpotSetup& setup, double metres) {
    return static_cast<float>(setup.shadow().stored_depth(metres));
  }

  std::vector<float> visibility(const SpotSetup& setup, const scene::Frame& frame,
                                const UniformValues& more = {}) const {
    static KeptRunners passes;
    const ShadowGraph graph = testing_frames::spot_graph(technique(), GetParam().reversed_z);
    GraphRunner& pass = passes.of(GetParam().technique, GetParam().reversed_z, [&] { return graph; });
    UniformValues all = graph.parameters;
    all.merge(slice_uniforms(setup));
    all.merge(more);
    pass.set_parameters(all);
    const FrameOnDevice on_device(test_device(), frame);
    return pass.run(on_device, kOnce).visibility.front();
  }

  std::vector<float> visibility(const SpotSetup& setup, const TexelDepth& map,
                                const std::vector<SpotPoint>& points, const UniformValues& more = {}) const {
    return visibility(setup, testing_frames::make_spot_frame(setup, map, positions(setup, points), kColumns),
                      more);
  }

  static void expect_all(const std::vector<float>& seen, float wanted, const std::string& what) {
    for (std::size_t i = 0; i < seen.size(); ++i)
      ASSERT_EQ(seen[i], wanted) << what << ": receiver " << i % kColumns << ", " << i / kColumns;
  }

  static void expect_in_range(const std::vector<float>& seen, const std::string& what) {
    for (std::size_t i = 0; i < seen.size(); ++i)
      ASSERT_TRUE(seen[i] >= 0.0F && seen[i] <= 1.0F)
          << what << ": " << seen[i] << " at receiver " << i % kColumns << ", " << i / kColumns;
  }

  // The map has structure at every scale.
  static float rough_depth(double u, double v, int tile) {
    const auto bits = static_cast<std::uint32_t>(u * 9973.0) * 2654435761U +
                      static_cast<std::uint32_t>(v * 7919.0) * 2246822519U + static_cast<std::uint32_t>(tile);
    return static_cast<float>((bits ^ (bits >> 15)) % 1000) / 999.0F;
  }
};

TEST_P(EverySpotFilter, IsExactlyLitWithoutBlockersAndDarkBehindAWall) {
  for (int slice = 0; slice < 4; ++slice) {
    SpotSetup at = setup();
    at.slice = slice;
    const std::string where = "slice " + std::to_string(slice);
    expect_all(visibility(
                   at, [this](double, double, int) { return farthest(); }, grid(kReceiver)),
               1.0F, where + ", empty");
    const float wall = stored(at, kReceiver - 0.05);
    expect_all(visibility(
                   at, [wall](double, double, int) { return wall; }, grid(kReceiver)),
               0.0F, where + ", wall");
    expect_all(visibility(
                   at, [this](double, double, int) { return nearest(); }, grid(kReceiver)),
               0.0F, where + ", wall on the near plane");
  }
}

TEST_P(EverySpotFilter, LightsASurfaceThatIsItsOwnCaster) {
  const SpotSetup at = setup();
  const float own = stored(at, kReceiver + 0.001);
  expect_all(visibility(
                 at, [own](double, double, int) { return own; }, grid(kReceiver)),
             1.0F, "own surface");
}

TEST_P(EverySpotFilter, LightsWhatItsMapDoesNotCover) {
  const SpotSetup at = setup();
  const auto wall = [this](double, double, int) { return nearest(); };
  const parameters::SpotShadow shadow = at.shadow();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<glm::dvec3> outside;
  for (const double metres :
       {-4.0, -0.01, 0.0, 0.1, 9.5, 1e6})  // behind, before the near plane, beyond the range
    outside.push_back(at.light.position + metres * shadow.light.direction);
  for (const SpotPoint& beside : {SpotPoint(-0.01, 0.5, 3.0), SpotPoint(1.01, 0.5, 3.0),
                                  SpotPoint(0.5, -2.0, 3.0), SpotPoint(0.5, 1.5, 3.0)})
    outside.push_back(world_position(shadow, beside));
  outside.emplace_back(nan, nan, nan);
  outside.emplace_back(std::numeric_limits<float>::infinity());
  scene::Frame frame = testing_frames::make_spot_frame(at, wall, outside, static_cast<int>(outside.size()));
  expect_all(visibility(at, frame), 1.0F, "outside");
}

TEST_P(EverySpotFilter, StaysInRangeWhateverIsInTheMap) {
  const SpotSetup at = setup();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, -nan, infinity, -infinity, -3.0F, 5.0F, 1e-45F, 0.0F, 1.0F}) {
    const auto some = [bad](double u, double v, int tile) {
      return rough_depth(u, v, tile) < 0.3F ? bad : rough_depth(v, u, tile);
    };
    expect_in_range(visibility(at, some, grid(kReceiver)), "texels of " + std::to_string(bad));
    const auto all = [bad](double, double, int) { return bad; };
    expect_in_range(visibility(at, all, grid(kReceiver)), "a map of " + std::to_string(bad));
  }
}

TEST_P(EverySpotFilter, StaysInRangeAtBothPlanesAndWithNormalsThatMakeNoSense) {
  const SpotSetup at = setup();
  for (const double metres : {0.3, 0.3000001, 8.999999, 9.0})
    expect_in_range(visibility(at, rough_depth, grid(metres)), std::to_string(metres) + " m");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  scene::Frame frame =
      testing_frames::make_spot_frame(at, rough_depth, positions(at, grid(kReceiver)), kColumns);
  for (const glm::vec3 bad : {glm::vec3(0.0F), glm::vec3(nan), glm::vec3(1e30F), glm::vec3(1e-30F)}) {
    for (glm::vec4& normal : frame.receivers.normal_ws) normal = glm::vec4(bad, 0.0F);
    expect_in_range(visibility(at, frame), "normal");
  }
}

TEST_P(EverySpotFilter, StaysRightWithSourcesAndPlanesOfAnySize) {
  const SpotSetup at = setup();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float wall = stored(at, kReceiver - 0.05);
  const glm::vec4 usual(0.3F, 9.0F, 1.0F, 0.1F);
  for (int field = 0; field < 4; ++field) {
    for (const float odd : {0.0F, -1.0F, 1e-20F, 1e30F, nan, std::numeric_limits<float>::infinity()}) {
      glm::vec4 light = usual;
      light[field] = odd;
      UniformValues told;
      told.set("_PenumbraSpotLight", light);
      const std::string what = "field " + std::to_string(field) + " is " + std::to_string(odd);
      expect_in_range(visibility(at, rough_depth, grid(kReceiver), told), what);
      expect_all(visibility(
                     at, [this](double, double, int) { return farthest(); }, grid(kReceiver), told),
                 1.0F, what + ", empty");
    }
  }
  for (const float radius : {0.0F, 0.001F, 1.0F}) {
    UniformValues told;
    told.set("_PenumbraSpotLight", glm::vec4(0.3F, 9.0F, 1.0F, radius));
    expect_all(visibility(
                   at, [wall](double, double, int) { return wall; }, grid(kReceiver), told),
               0.0F, "wall, source of " + std::to_string(radius));
  }
}

TEST_P(EverySpotFilter, LearnsNothingFromOutsideItsSlice) {
  for (int slice = 0; slice < 4; ++slice) {
    SpotSetup at = setup();
    at.slice = slice;
    std::vector<float> before;
    for (const float poison : {0.0F, 1.0F, std::numeric_limits<float>::quiet_NaN()}) {
      const auto map = [=](double u, double v, int tile) {
        return tile == slice ? rough_depth(u, v, tile) : poison;
      };
      std::vector<float> seen = visibility(at, map, grid(kReceiver));
      for (std::size_t i = 0; i < before.size(); ++i)
        ASSERT_EQ(std::bit_cast<std::uint32_t>(seen[i]), std::bit_cast<std::uint32_t>(before[i]))
            << "slice " << slice << ", texels outside " << poison << ", receiver " << i;
      before = std::move(seen);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Library, EverySpotFilter, testing::ValuesIn(all_cases()), [](const auto& instance) {
  return as_identifier(instance.param.technique +
                       (instance.param.reversed_z ? "_reversed" : "_conventional"));
});

}  // namespace
}  // namespace penumbra::resolve
