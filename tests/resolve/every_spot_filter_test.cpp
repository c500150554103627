// Every filter for spot lights must do this, in one slice of an atlas in perspective: the right answer where
// there is one, no NaN, nothing outside [0, 1], nothing learnt from outside the slice.
#include <gmock/gmock.h>

#include <limits>
#include <map>
#include <memory>

#include "resolve/filter_cases.h"
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

std::vector<FilterCase> all_cases() {
  std::vector<FilterCase> cases;
  for (const techniques::Technique& technique : library_techniques().techniques) {
    if (!technique.is_for(techniques::LightKind::spot)) continue;
    cases.push_back({technique.name, true});
    cases.push_back({technique.name, false});
  }
  return cases;
}

class EverySpotFilter : public testing::TestWithParam<FilterCase> {
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

  // The grid of receivers below a map of one depth.
  std::vector<float> below(const SpotSetup& setup, float depth, const UniformValues& more = {}) const {
    return visibility(
        setup, [depth](double, double, int) { return depth; }, grid(kReceiver), more);
  }
};

TEST_P(EverySpotFilter, IsExactlyLitWithoutBlockersAndDarkBehindAWall) {
  for (int slice = 0; slice < 4; ++slice) {
    SpotSetup at = setup();
    at.slice = slice;
    const std::string where = "slice " + std::to_string(slice);
    expect_all(below(at, farthest()), 1.0F, where + ", empty");
    expect_all(below(at, stored(at, kReceiver - 0.05)), 0.0F, where + ", wall");
    expect_all(below(at, nearest()), 0.0F, where + ", wall on the near plane");
  }
}

TEST_P(EverySpotFilter, LightsASurfaceThatIsItsOwnCaster) {
  const SpotSetup at = setup();
  expect_all(below(at, stored(at, kReceiver + 0.001)), 1.0F, "own surface");
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
    expect_in_range(below(at, bad), "a map of " + std::to_string(bad));
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
  const glm::vec4 usual(0.3F, 9.0F, 1.0F, 0.1F);
  for (int field = 0; field < 4; ++field) {
    for (const float odd : {0.0F, -1.0F, 1e-20F, 1e30F, nan, std::numeric_limits<float>::infinity()}) {
      glm::vec4 light = usual;
      light[field] = odd;
      UniformValues told;
      told.set("_PenumbraSpotLight", light);
      const std::string what = "field " + std::to_string(field) + " is " + std::to_string(odd);
      expect_in_range(visibility(at, rough_depth, grid(kReceiver), told), what);
      expect_all(below(at, farthest(), told), 1.0F, what + ", empty");
    }
  }
  for (const float radius : {0.0F, 0.001F, 1.0F}) {
    UniformValues told;
    told.set("_PenumbraSpotLight", glm::vec4(0.3F, 9.0F, 1.0F, radius));
    expect_all(below(at, stored(at, kReceiver - 0.05), told), 0.0F,
               "wall, source of " + std::to_string(radius));
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
      expect_same(seen, before, "slice " + std::to_string(slice));
      before = std::move(seen);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Library, EverySpotFilter, testing::ValuesIn(all_cases()), case_name);

}  // namespace
}  // namespace penumbra::resolve
