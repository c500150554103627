// Tests the border between two cascades: dithered pixels read one of both, mixed ones both with the weight
// that CascadeSelection.hlsl documents, worked out here from the spheres.
#include <gmock/gmock.h>

#include <cmath>

#include "reference/same_map_estimate.h"
#include "resolve/drawn_scenes.h"
#include "resolve/graph_runner.h"
#include "resolve/run_once.h"

namespace penumbra::resolve {
namespace {

constexpr double kBorder = 0.25;

std::vector<float> visibility(const scene::Frame& frame, scene::CascadeBlend blend) {
  scene::Frame blended = frame;
  blended.settings.cascade_choices.blend = blend;
  const techniques::TechniqueList& list = library_techniques();
  static KeptOnDevice<std::unique_ptr<GraphRunner>> runner;
  if (*runner == nullptr)
    *runner = std::make_unique<GraphRunner>(
        test_device(), compile(technique_shader(list, list.find("tent-5-plane"), Taps::as_listed, true)));
  return (*runner)->run(FrameOnDevice(test_device(), blended), kOnce).visibility.front();
}

struct Place {
  int cascade = -1;
  double weight = 0.0;  // weight of the next one
};

Place place_of(const scene::Frame& frame, std::size_t pixel) {
  Place place;
  const glm::dvec3 position(frame.receivers.position_ws[pixel]);
  if (frame.receivers.position_ws[pixel].w == 0.0F) return place;
  place.cascade = reference::select_cascade(frame.cascades, position);
  const auto next = static_cast<std::size_t>(place.cascade + 1);
  if (place.cascade < 0 || next == frame.cascades.cascades.size()) return place;
  const auto share = [&](std::size_t cascade) {
    const glm::dvec4& sphere = frame.cascades.cascades[cascade].split_sphere;
    const double distance = glm::distance(position, glm::dvec3(sphere)) / sphere.w;
    return distance * distance;
  };
  const double begin = (1.0 - kBorder) * (1.0 - kBorder);
  if (share(next) < 1.0) place.weight = std::clamp((share(next - 1) - begin) / (1.0 - begin), 0.0, 1.0);
  return place;
}

TEST(CascadeBlend, DitheredPixelsReadTheNextCascadeAsOftenAsTheirWeightSays) {
  const scene::Frame& frame = drawn("trees", 4, true);
  const std::vector<float> plain = visibility(frame, {});
  const std::vector<float> dithered = visibility(frame, {kBorder, false});
  double expected = 0.0;
  double changed = 0.0;
  int in_border = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const double weight = place_of(frame, i).weight;
    if (weight == 0.0) {
      EXPECT_EQ(dithered[i], plain[i]) << "pixel " << i;
    }
    if (weight == 0.0 || plain[i] == 0.0F || plain[i] == 1.0F) continue;
    ++in_border;
    expected += weight;
    changed += dithered[i] != plain[i] ? 1.0 : 0.0;
  }
  ASSERT_GT(in_border, 200);
  EXPECT_NEAR(changed / in_border, expected / in_border, 0.05);
}

TEST(CascadeBlend, MixedPixelsAreTheWeightedMeanOfBothCascades) {
  const scene::Frame& frame = drawn("trees", 4, true);
  const std::vector<float> plain = visibility(frame, {});
  const std::vector<float> dithered = visibility(frame, {kBorder, false});
  const std::vector<float> mixed = visibility(frame, {kBorder, true});
  int between = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const double weight = place_of(frame, i).weight;
    if (weight == 0.0) {
      EXPECT_EQ(mixed[i], plain[i]) << "pixel " << i;
    }
    if (dithered[i] == plain[i]) continue;  // otherwise the dithered one is the next cascade's
    ++between;
    const double expected = (1.0 - weight) * plain[i] + weight * dithered[i];
    // The position is a float, and with it the weight.
    EXPECT_NEAR(mixed[i], expected, 1e-4) << "pixel " << i << ", weight " << weight;
  }
  EXPECT_GT(between, 120);
}

TEST(CascadeBlend, OneCascadeHasNoBorder) {
  const scene::Frame& frame = drawn("trees", 1, true);
  EXPECT_EQ(visibility(frame, {kBorder, true}), visibility(frame, {}));
}

}  // namespace
}  // namespace penumbra::resolve
