// Every filter of the manifests must do this, whatever it is given: the right answer where there is one, no
// NaN, nothing outside [0, 1], nothing learnt from outside the tile.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>

#include "resolve/filter_cases.h"
#include "resolve/kept_runners.h"
#include "resolve/reference_bounds.h"
#include "resolve/run_once.h"
#include "resolve/synthetic_frame.h"

namespace penumbra::resolve {
namespace {

using testing_frames::FrameSetup;
using testing_frames::TexelDepth;
using testing_frames::TilePoint;

constexpr int kColumns = 24;

// A case runs a filter with its parameters, and the maps that it reads. It does not run passes over the
// screen (filter_over_map).
struct FilterAndMaps {
  explicit FilterAndMaps(const techniques::Technique& technique) {
    const techniques::FilterCall& filter = *technique.graph.filter();
    function = filter.file + " " + filter.function;
    if (technique.graph.filter_pass() != nullptr)
      for (const techniques::GraphTexture& texture : technique.graph.textures)
        function += " " + texture.name + " " + texture.format;
    for (const std::string& keyword : technique.keywords) function += " " + keyword;
    values = technique.values;
    if (technique.graph.filter_pass() != nullptr || filter.parameters.empty()) return;
    const techniques::ParameterStruct* fields = library_techniques().find_struct(filter.parameters);
    std::erase_if(values, [&](const auto& value) {
      return std::none_of(fields->fields.begin(), fields->fields.end(),
                          [&](const techniques::ParameterField& field) { return field.name == value.first; });
    });
  }

  std::string function;
  std::map<std::string, std::vector<double>> values;
};

// Every filter with every set of values, once, however many techniques have it. The first set of a filter is
// a case in both directions of depth, the others by turns in one.
std::vector<FilterCase> all_cases() {
  std::vector<FilterCase> cases;
  std::map<std::string, std::vector<std::map<std::string, std::vector<double>>>> seen;
  for (const techniques::Technique& technique : library_techniques().techniques) {
    if (technique.graph.draws(techniques::DrawnCasters::opaque)) continue;  // the frames here have no scene
    if (technique.graph.filter() == nullptr) continue;                      // it reads no shadow map
    const FilterAndMaps filter(technique);
    auto& sets = seen[filter.function];
    if (std::find(sets.begin(), sets.end(), filter.values) != sets.end()) continue;
    sets.push_back(filter.values);
    if (sets.size() % 2 == 1) cases.push_back({technique.name, true});
    if (sets.size() == 1 || sets.size() % 2 == 0) cases.push_back({technique.name, false});
  }
  return cases;
}

double value(const techniques::Technique& technique, const std::string& name) {
  return technique.values.at(name)[0];
}

// Rounding leaves the variance v, for which v / (v + g^2) = bleeding.
double variance_gap(const techniques::Technique& technique, double receiver) {
  const double u = value(technique, "precision");
  const double centred = std::abs(receiver - 0.5);
  const double variance = 16.0 * u * std::max(centred * centred, u);
  return 1.5 * std::sqrt(variance * (1.0 / value(technique, "bleeding") - 1.0));
}

// The gap g has exp(-c g) = bleeding, and the rounding of two blurs to 16 bits.
double exponential_gap(const techniques::Technique& technique, double) {
  return std::log(1.0 / value(technique, "bleeding")) / value(technique, "exponent") + 1e-4;
}

// Rounding leaves the variance 16 u exp(2 c z) of a wall at exp(c z).
double exponential_variance_gap(const techniques::Technique& technique, double) {
  const double variance = 16.0 * value(technique, "precision");
  const double deviations = std::sqrt(variance * (1.0 / value(technique, "bleeding") - 1.0));
  return 1.5 * std::log1p(deviations) / value(technique, "positiveExponent");
}

double moments_gap(const techniques::Technique& technique, double receiver) {
  using testing_bounds::Real;
  const Real z = 2.0 * receiver - 1.0;
  double gap = 0.0;
  const auto bound = [&](Real wall) {
    return testing_bounds::hamburger({wall, wall * wall, wall * wall * wall, wall * wall * wall * wall}, z,
                                     value(technique, "mix"));
  };
  while (gap < receiver && bound(z - 2.0 * gap) > value(technique, "bleeding")) gap += 1e-4;
  return 1.5 * gap;
}

// Godot's receiver moves toward the light by its depth bias before it is compared.
double godot_gap(const techniques::Technique& technique, double) {
  return 1.5 * value(technique, "depthBias");
}

// The variance v is what rounding leaves: v / (v + g^2) = bleeding.
double soft_variance_gap(const techniques::Technique& technique, double) {
  return 1.5 * std::sqrt(value(technique, "smallestVariance") * (1.0 / value(technique, "bleeding") - 1.0));
}

// The smallest variance is relative to the receiver's exponential, so 1 - exp(-c g) stands in place of g.
double exponential_levels_gap(const techniques::Technique& technique, double) {
  const double variance = 16.0 * value(technique, "precision");
  const double deviations = std::sqrt(variance * (1.0 / value(technique, "bleeding") - 1.0));
  return -1.5 * std::log1p(-deviations) / value(technique, "positiveExponent");
}

// None of these casters blend: whatever filters do with those, without them they are filters of the map.
const CastersOnDevice& opaque_casters() {
  static KeptOnDevice<std::optional<CastersOnDevice>> casters;
  if (!*casters) {
    scene::Scene scene;
    scene.mesh.positions = {{0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}};
    scene.mesh.normals.assign(3, {0.0F, 1.0F, 0.0F});
    scene.mesh.indices = {0, 1, 2};
    casters->emplace(test_device(), scene);
  }
  return **casters;
}

class EveryFilter : public testing::TestWithParam<FilterCase> {
 protected:
  FrameSetup setup(int cascades = 4, int cascade = 1) const {
    FrameSetup setup;
    setup.shadows.cascades = cascades;
    setup.shadows.resolution = 256;
    setup.shadows.reversed_z = GetParam().reversed_z;
    setup.light.angular_diameter_degrees = 2.0;
    setup.cascade = cascade;
    return setup;
  }

  float nearest() const { return testing_frames::nearest_depth(GetParam().reversed_z); }
  float farthest() const { return testing_frames::farthest_depth(GetParam().reversed_z); }
  // Stored depth at `distance` from the light's end of the tile, 0 .. 1.
  double depth(double distance) const { return GetParam().reversed_z ? 1.0 - distance : distance; }

  // The receivers form a grid over the whole tile, its edges and corners included, at one depth.
  static std::vector<TilePoint> grid(double depth) {
    std::vector<TilePoint> points;
    for (int y = 0; y < kColumns; ++y) {
      for (int x = 0; x < kColumns; ++x) {
        points.emplace_back(x / (kColumns - 1.0), y / (kColumns - 1.0), depth);
      }
    }
    return points;
  }

  const techniques::Technique& technique() const { return library_techniques().find(GetParam().technique); }

  // The filter alone, with the passes over the map that it needs.
  ShadowGraph filter_over_map() const {
    if (technique().graph.filter_pass() != nullptr)
      return technique_graph(library_techniques(), technique(), Taps::as_listed, GetParam().reversed_z);
    return filter_graph(
        technique_shader(library_techniques(), technique(), Taps::as_listed, GetParam().reversed_z));
  }

  // The smallest distance of a wall from the receiver, in the map's range, at which it is told from it. Raw
  // depths tell any gap beyond a bias of the receiver, a filtered map one whose bound the reduction of
  // bleeding makes dark.
  double smallest_gap(double receiver) const {
    const std::map<std::string, double (*)(const techniques::Technique&, double)> gaps{
        {"variance", variance_gap},
        {"exponential", exponential_gap},
        {"log-exponential", exponential_gap},
        {"exponential-variance", exponential_variance_gap},
        {"moments", moments_gap},
        {"godot-pcss", godot_gap},
        {"vssm", soft_variance_gap},
        {"mssm", moments_gap},
        {"evsm-mip", exponential_levels_gap}};
    const auto found = gaps.find(technique().family);
    return found == gaps.end() ? 0.0 : found->second(technique(), receiver);
  }

  // Unreal's rays start, and Filament's taps are compared, on the receiver's plane without a bound: a plane
  // along the light's rays passes the near plane within a texel, and what is there lies behind it.
  bool passes_the_near_plane() const {
    return technique().family == "unreal-smrt" || technique().family.starts_with("filament-");
  }

  // Weights between two mip levels need not add up to 1 on every device. All other filters are exact.
  float lit_error() const { return technique().family == "evsm-mip" ? 1e-6F : 0.0F; }

  std::vector<float> visibility(const scene::Frame& frame, const UniformValues& parameters = {}) const {
    // Pipelines are kept: building one costs more than running it.
    static KeptRunners passes;
    GraphRunner& pass =
        passes.of(GetParam().technique, GetParam().reversed_z, [&] { return filter_over_map(); });
    const FrameOnDevice on_device(test_device(), frame, &opaque_casters());
    UniformValues all = filter_over_map().parameters;
    // The parameters of filters for spot lights are set, too: every_spot_filter_test.cpp has maps in
    // perspective.
    all.set("_PenumbraSpotLight", glm::vec4(0.3F, 9.0F, 1.0F, 0.1F));
    all.merge(parameters);
    pass.set_parameters(all);
    return pass.run(on_device, kOnce).visibility.front();
  }

  std::vector<float> visibility(const FrameSetup& setup, const TexelDepth& map,
                                const std::vector<TilePoint>& receivers,
                                const UniformValues& parameters = {}) const {
    return visibility(testing_frames::make_frame(setup, map, receivers, kColumns), parameters);
  }

  // The grid of receivers at a distance from the light's end of the tile, below a map of one depth.
  std::vector<float> below(float map, const FrameSetup& setup, double receiver,
                           const UniformValues& parameters = {}) const {
    return visibility(
        setup, [map](double, double, int) { return map; }, grid(depth(receiver)), parameters);
  }

  void expect(const std::vector<float>& seen, float wanted, const std::string& what) const {
    expect_all(seen, wanted, what, lit_error());
  }

  // In range over a rough map, lit over an empty one and dark behind a wall that stands before the receivers
  // by the gap at least.
  void expect_right(const FrameSetup& setup, double gap, const std::string& what,
                    const UniformValues& parameters = {}) const {
    expect_in_range(visibility(setup, rough_depth, grid(depth(0.6)), parameters), what);
    expect(below(farthest(), setup, 0.6, parameters), 1.0f, what + ", empty map");
    const auto wall = static_cast<float>(depth(0.6 - std::max(gap, smallest_gap(0.6))));
    expect(below(wall, setup, 0.6, parameters), 0.0f, what + ", wall");
  }

  // Sets the field of whatever parameter struct the technique has, if it has it.
  UniformValues with_counts(int count) const {
    techniques::Technique technique = library_techniques().find(GetParam().technique);
    for (const techniques::ParameterStruct* fields : library_techniques().structs_of(technique))
      for (const techniques::ParameterField& field : fields->fields)
        if (field.type == "int" && field.name.find("amples") != std::string::npos)
          technique.values[field.name] = {static_cast<double>(count)};
    return parameter_uniforms(library_techniques(), technique);
  }
};

TEST_P(EveryFilter, IsExactlyLitWithoutBlockers) {
  for (int cascades = 1; cascades <= 4; ++cascades)
    for (int cascade = 0; cascade < cascades; ++cascade)
      expect(below(farthest(), setup(cascades, cascade), 0.5), 1.0f,
             "cascade " + std::to_string(cascade) + " of " + std::to_string(cascades));
}

TEST_P(EveryFilter, IsExactlyDarkBehindAWall) {
  // The wall stands just in front, so that its penumbra is narrow and the tile's edge is far away in it.
  const double gap = std::max(0.01, smallest_gap(0.5));
  expect(below(static_cast<float>(depth(0.5 - gap)), setup(), 0.5), 0.0f, "near wall");
  expect(below(nearest(), setup(), 0.5), 0.0f, "wall at the near plane");
}

TEST_P(EveryFilter, LightsASurfaceThatIsItsOwnCaster) {
  // A plane facing the light casts its own depth; a hair of bias, as the caster pass gives, lights it.
  expect(below(static_cast<float>(depth(0.5001)), setup(), 0.5), 1.0f, "own surface");
}

TEST_P(EveryFilter, StaysInRangeAtDepthZeroAndOne) {
  for (const double receiver : {0.0, 1.0})
    expect_in_range(visibility(setup(), rough_depth, grid(receiver)), "depth " + std::to_string(receiver));
  expect(below(farthest(), setup(), 0.0), 1.0f, "receiver at the near plane");
}

TEST_P(EveryFilter, StaysRightWithOneSampleAndWithSixtyFour) {
  for (const int count : {1, 64})
    expect_right(setup(), 0.01, std::to_string(count) + " samples", with_counts(count));
}

TEST_P(EveryFilter, StaysInRangeWithCountsThatMakeNoSense) {
  for (const int count : {0, -5, 1000000})
    expect_in_range(visibility(setup(), rough_depth, grid(depth(0.6)), with_counts(count)),
                    std::to_string(count) + " samples");
}

TEST_P(EveryFilter, StaysRightAtAngularDiameterZeroAndThirty) {
  for (const double degrees : {0.0, 30.0}) {
    FrameSetup wide = setup();
    wide.light.angular_diameter_degrees = degrees;
    expect_right(wide, 0.001, std::to_string(degrees));
  }
}

TEST_P(EveryFilter, StaysRightWithTheSunTwoDegreesUp) {
  FrameSetup low = setup();
  low.light.direction = {std::cos(0.035), -std::sin(0.035), 0.0};
  scene::Frame frame = testing_frames::make_frame(low, rough_depth, grid(depth(0.6)), kColumns);
  for (glm::vec4& normal : frame.receivers.normal_ws) normal = {0.0f, 1.0f, 0.0f, 0.0f};
  expect_in_range(visibility(frame), "rough map");
  frame.atlas =
      testing_frames::make_atlas(frame.cascades, [this](double, double, int) { return farthest(); });
  expect(visibility(frame), 1.0f, "empty map");
  frame.atlas = testing_frames::make_atlas(frame.cascades, [this](double, double, int) { return nearest(); });
  if (passes_the_near_plane())
    expect_in_range(visibility(frame), "wall at the near plane");
  else
    expect(visibility(frame), 0.0f, "wall at the near plane");
}

TEST_P(EveryFilter, StaysRightAHundredKilometresFromTheOrigin) {
  FrameSetup far = setup();
  far.camera.position = {1e5, 1.7, -1e5};
  // A quarter of the depth range is metres: far more than the centimetre that positions are rounded by here.
  expect_right(far, 0.25, "far away");
}

TEST_P(EveryFilter, StaysInRangeWithNormalsThatMakeNoSense) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  scene::Frame frame = testing_frames::make_frame(setup(), rough_depth, grid(depth(0.6)), kColumns);
  for (const glm::vec3 bad : {glm::vec3(0.0f), glm::vec3(nan), glm::vec3(infinity), glm::vec3(1e-30f)}) {
    for (glm::vec4& normal : frame.receivers.normal_ws) normal = glm::vec4(bad, 0.0f);
    expect_in_range(visibility(frame), "normal");
  }
}

TEST_P(EveryFilter, StaysInRangeWithPositionsThatMakeNoSense) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  scene::Frame frame = testing_frames::make_frame(setup(), rough_depth, grid(depth(0.6)), kColumns);
  for (const float bad : {nan, infinity, -infinity, 1e30f}) {
    for (glm::vec4& position : frame.receivers.position_ws) position = {bad, bad, bad, 1.0f};
    expect_in_range(visibility(frame), "position " + std::to_string(bad));
  }
}

TEST_P(EveryFilter, StaysInRangeWithNaNAndInfiniteTexels) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, -nan, infinity, -infinity, -3.0f, 5.0f, 1e-45f}) {
    const auto map = [bad](double u, double v, int tile) {
      return rough_depth(u, v, tile) < 0.3f ? bad : rough_depth(v, u, tile);
    };
    expect_in_range(visibility(setup(), map, grid(depth(0.6))), "texels of " + std::to_string(bad));
    expect_in_range(below(bad, setup(), 0.6), "a map of " + std::to_string(bad));
  }
}

TEST_P(EveryFilter, LearnsNothingFromOutsideItsTile) {
  for (int cascade = 0; cascade < 4; ++cascade) {
    std::vector<float> before;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float poison : {0.0f, 1.0f, nan}) {
      const auto map = [=](double u, double v, int tile) {
        return tile == cascade ? rough_depth(u, v, tile) : poison;
      };
      std::vector<float> seen = visibility(setup(4, cascade), map, grid(depth(0.6)));
      expect_same(seen, before, "cascade " + std::to_string(cascade));
      before = std::move(seen);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Library, EveryFilter, testing::ValuesIn(all_cases()), case_name);

}  // namespace
}  // namespace penumbra::resolve
