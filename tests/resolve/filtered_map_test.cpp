// Compares the passes of filtered maps and their filters with the same sums in C++: each map is one double
// sum over the square of a Gaussian, and the filter's answer is computed by other means.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "as_identifier.h"
#include "resolve/graph_runner.h"
#include "resolve/reference_bounds.h"
#include "resolve/run_once.h"
#include "resolve/synthetic_frame.h"
#include "resolve/test_device.h"

namespace penumbra::resolve {
namespace {

using testing_bounds::Real;
using Means = std::array<Real, 4>;

constexpr int kColumns = 16;
constexpr double kReceiver = 0.6555;  // share of the map's range, from the light

// An occluder's edge across a slightly sloped surface that lies partly before and partly behind the
// receivers.
double depth_at(double u, double v, int tile) {
  return u + 0.3 * v > 0.6 ? 0.65 + 0.01 * v : 0.35 + 0.05 * v + 0.02 * tile;
}

// The distance of the shader's means from exact ones, given the exact ones.
using Rounding = std::function<Means(const Means&, const techniques::Technique&)>;

// The receiver's position in the world and its transform are floats.
constexpr Real kDepthError = 1e-6L;
// Two stored blurs, their sums and the filter's first operations have so many roundings of a float.
constexpr Real kRoundings = 4;
const Real kFloat = std::ldexp(Real(1), -24);

// A technique stores this of a depth in [-1/2, 1/2], and concludes this visibility from means.
struct Model {
  std::string technique;
  std::function<Means(Real depth, const techniques::Technique&)> stored;
  std::function<Real(const Means&, Real depth, const techniques::Technique&)> visible;
  Rounding rounding;
  bool interpolates_visibility = false;  // visibility is interpolated between texels, in place of means
};

Real value(const techniques::Technique& technique, const std::string& name) {
  return technique.values.at(name)[0];
}

Means powers(Real x) {
  return {x, x * x, x * x * x, x * x * x * x};
}

Means warped(Real depth, const techniques::Technique& technique) {
  const Real grows = std::exp(value(technique, "positiveExponent") * depth);
  const Real shrinks = -std::exp(-value(technique, "negativeExponent") * depth);
  return {grows, shrinks, grows * grows, shrinks * shrinks};
}

Means exponential(Real depth, const techniques::Technique& technique) {
  return {std::exp(value(technique, "exponent") * depth), 0, 0, 0};
}

Real exponential_light(const Means& mean, Real depth, const techniques::Technique& technique) {
  return std::min(mean[0] * std::exp(-value(technique, "exponent") * depth), Real(1));
}

// Each mean has the rounding of its own size...
Means of_each(const Means& means, const techniques::Technique&) {
  Means errors{};
  for (std::size_t i = 0; i < errors.size(); ++i) errors[i] = kRoundings * kFloat * std::fabs(means[i]);
  return errors;
}

// ... or of the stored values, up to 1, that it is computed from.
Means of_one(const Means&, const techniques::Technique&) {
  const Real error = kRoundings * kFloat;
  return {error, error, error, error};
}

// The map holds depths in steps of 1 / 65535, rounded in both blurs.
Means of_16_bit_depth(const Means& means, const techniques::Technique& technique) {
  return {std::expm1(value(technique, "exponent") / 65535) * means[0], 0, 0, 0};
}

std::vector<Model> models() {
  return {
      {"variance-32", [](Real depth, const techniques::Technique&) { return powers(depth); },
       [](const Means& mean, Real depth, const techniques::Technique&) {
         return testing_bounds::chebyshev(mean[0], mean[1], depth, 1e-9L);
       },
       of_each},
      {"exponential-32", exponential, exponential_light, of_each},
      {"log-exponential-16", exponential, exponential_light, of_16_bit_depth, true},
      {"exponential-variance-32", warped,
       [](const Means& mean, Real depth, const techniques::Technique& technique) {
         const Means receiver = warped(depth, technique);
         const Real u = 16 * value(technique, "precision");
         return std::min(testing_bounds::chebyshev(mean[0], mean[2], receiver[0], u * mean[2]),
                         testing_bounds::chebyshev(mean[1], mean[3], receiver[1], u * mean[3]));
       },
       of_each},
      {"moments-32", [](Real depth, const techniques::Technique&) { return powers(2 * depth); },
       [](const Means& mean, Real depth, const techniques::Technique& technique) {
         return testing_bounds::hamburger(mean, 2 * depth, value(technique, "mix"));
       },
       of_one},
  };
}

struct Interval {
  double least = 1.0;
  double most = 0.0;

  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

struct FilteredMap {
  const scene::ShadowAtlas& atlas;
  int tile;  // side in texels
  const techniques::Technique& technique;
  const Model& model;

  Real centred(int x, int y) const {
    // The map's depths are reversed.
    return 0.5 - static_cast<double>(atlas.depth[static_cast<std::size_t>(y * atlas.width + x)]);
  }
  Means blurred(int x, int y) const {
    const Real deviation = value(technique, "deviation");
    const int reach = static_cast<int>(std::ceil(2.5L * deviation));
    const auto inside = [&](int i, int of) {
      return std::clamp(i, of / tile * tile, of / tile * tile + tile - 1);
    };
    Means sum{};
    Real weights = 0;
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) {
        const Real weight = std::exp(-0.5L * (dx * dx + dy * dy) / (deviation * deviation));
        const Means stored = model.stored(centred(inside(x + dx, x), inside(y + dy, y)), technique);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * stored[i];
        weights += weight;
      }
    for (Real& mean : sum) mean /= weights;
    return sum;
  }
  double visible(const Means& means, Real depth) const {
    const Real light = model.visible(means, depth, technique);
    const Real bleeding = value(technique, "bleeding");
    return static_cast<double>(std::clamp((light - bleeding) / (1 - bleeding), Real(0), Real(1)));
  }
  // The visibilities of all means and depths within their errors, by the corners of that box.
  Interval visible(const Means& means) const {
    const Means errors = model.rounding(means, technique);
    Interval interval;
    for (unsigned corner = 0; corner < 32; ++corner) {
      Means moved = means;
      for (unsigned i = 0; i < moved.size(); ++i)
        moved[i] += (corner >> i & 1u) != 0 ? errors[i] : -errors[i];
      const Real depth = kReceiver - 0.5L + ((corner & 16u) != 0 ? kDepthError : -kDepthError);
      interval.add(visible(moved, depth));
    }
    return interval;
  }
  Interval between(const Means& here, const Means& beside, Real fraction) const {
    if (model.interpolates_visibility) {
      const Interval first = visible(here), second = visible(beside);
      const double f = static_cast<double>(fraction);
      return {(1.0 - f) * first.least + f * second.least, (1.0 - f) * first.most + f * second.most};
    }
    Means mixed{};
    for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i] = (1 - fraction) * here[i] + fraction * beside[i];
    return visible(mixed);
  }
  // The visibility at a texel's centre, which a device may take for a position 1/128 of a texel beside it:
  // positions have 8 fractional bits, rounded either way. At the tile's border, the filter moves it inward by
  // 1/64 (TileBounds.hlsl).
  Interval visibility(int x, int y) const {
    const Means here = blurred(x, y);
    Interval interval = visible(here);
    for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
      const auto inside = [&](int i, int by) { return (i + by) / tile == i / tile && i + by >= 0; };
      if (!inside(x, step.x) || !inside(y, step.y)) continue;
      const bool inward = (step.x == 0 || (x - step.x) / tile != x / tile || x < step.x) &&
                          (step.y == 0 || (y - step.y) / tile != y / tile || y < step.y);
      const Interval beside = between(here, blurred(x + step.x, y + step.y), Real(inward ? 6 : 2) / 256);
      interval.add(beside.least);
      interval.add(beside.most);
    }
    return interval;
  }
};

class FilteredMaps : public testing::TestWithParam<Model> {};

void PrintTo(const Model& model, std::ostream* stream) {
  *stream << model.technique;
}

TEST_P(FilteredMaps, GiveTheLightOfTheBlurredDepths) {
  testing_frames::FrameSetup setup;
  setup.shadows.resolution = 64;
  setup.shadows.cascades = 4;
  setup.shadows.reversed_z = true;
  setup.cascade = 3;
  std::vector<testing_frames::TilePoint> receivers;
  // The places are centres of texels, the tile's first and last included.
  for (int i = 0; i < kColumns * kColumns; ++i)
    receivers.emplace_back((i % kColumns * 2 + (i % kColumns < 8 ? 0.5 : 1.5)) / 32.0,
                           (i / kColumns * 2 + (i / kColumns < 8 ? 0.5 : 1.5)) / 32.0, 1.0 - kReceiver);
  const scene::Frame frame = testing_frames::make_frame(
      setup, [](double u, double v, int tile) { return static_cast<float>(1.0 - depth_at(u, v, tile)); },
      receivers, kColumns);
  const techniques::TechniqueList& list = library_techniques();
  const techniques::Technique& technique = list.find(GetParam().technique);
  GraphRunner runner(test_device(), compile(technique_graph(list, technique)));
  const GraphResult result = runner.run(FrameOnDevice(test_device(), frame), kCountedOnce);

  const FilteredMap map{frame.atlas, frame.cascades.tile_resolution, technique, GetParam()};
  const glm::dvec4 tile = frame.cascades.cascades[3].offset_scale;
  int between = 0;
  double widths = 0.0;
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    const int x = static_cast<int>((tile.x + receivers[i].x * tile.z) * frame.atlas.width);
    const int y = static_cast<int>((tile.y + receivers[i].y * tile.w) * frame.atlas.height);
    const auto [least, most] = map.visibility(x, y);
    EXPECT_GE(result.visibility[0][i], least - 1e-5) << x << ", " << y;
    EXPECT_LE(result.visibility[0][i], most + 1e-5) << x << ", " << y;
    between += least > 0.05 && most < 0.95 ? 1 : 0;
    widths += most - least;
  }
  EXPECT_LT(widths / static_cast<double>(receivers.size()), 0.05) << "the intervals say something";
  EXPECT_GT(between, 10) << "penumbra receivers";
  EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());

  // There are nine taps for each texel, in rows and columns.
  const double texels = static_cast<double>(frame.atlas.width) * frame.atlas.height / (kColumns * kColumns);
  ASSERT_EQ(result.passes.size(), 3U);
  EXPECT_DOUBLE_EQ(result.passes[0].fetches, 9.0 * texels);
  EXPECT_DOUBLE_EQ(result.passes[1].fetches, 9.0 * texels);
  EXPECT_DOUBLE_EQ(result.passes[1].texels_written, texels);
  EXPECT_DOUBLE_EQ(result.passes[2].fetches, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Library, FilteredMaps, testing::ValuesIn(models()),
                         [](const auto& instance) { return as_identifier(instance.param.technique); });

}  // namespace
}  // namespace penumbra::resolve
