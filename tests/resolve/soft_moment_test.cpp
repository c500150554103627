// Compares variance and moment soft shadow mapping on summed-area tables with the papers' steps in C++: sums
// over the texels themselves, other forms of the bounds. The shader's error is followed through the steps:
// the receiver's position and depth and the means move within their rounding, and the answer must lie between
// the least and the most that comes out.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "resolve/graph_runner.h"
#include "resolve/reference_bounds.h"
#include "resolve/run_once.h"
#include "resolve/synthetic_frame.h"
#include "resolve/test_device.h"

namespace penumbra::resolve {
namespace {

using testing_bounds::Real;
using Moments = std::array<Real, 4>;

constexpr int kColumns = 16;
constexpr int kCascade = 1;
constexpr double kReceiver = 0.6555;  // share of the map's range, from the light

// An occluder's edge across a slightly sloped surface that lies partly before and partly behind the
// receivers.
double depth_at(double u, double v, int tile) {
  return u + 0.3 * v > 0.6 ? 0.65 + 0.01 * v : 0.35 + 0.05 * v + 0.02 * tile;
}

struct Box {
  Real left, top, right, bottom;
  Real width() const { return right - left; }
  Real height() const { return bottom - top; }
  Real area() const { return width() * height(); }
};

struct Receiver {
  Real x, y, depth;  // in texels of the tile; the depth is centred
};

// The directions of rounding: of the means of the search and of the filter.
struct Signs {
  int search;
  int filter;
};

class Map {
 public:
  explicit Map(const scene::Frame& frame) : frame_(frame), side(frame.cascades.tile_resolution) {
    const parameters::Cascade& cascade = frame.cascades.cascades.at(kCascade);
    const glm::dmat4 rows = glm::transpose(cascade.world_to_shadow);
    const double per_metre = glm::length(glm::dvec3(rows[0])) * frame.atlas.width;
    texels_per_depth = std::tan(frame.settings.angular_diameter_degrees * std::acos(-1.0) / 360.0) *
                       per_metre / glm::length(glm::dvec3(rows[2]));
    // The plane goes through a receiver: depth along two of its tangents, per texel.
    const glm::dvec3 normal(frame.receivers.normal_ws.front());
    const glm::dvec3 a = glm::normalize(glm::cross(normal, glm::dvec3(0.3, 0.5, 0.8)));
    const glm::dvec3 b = glm::cross(normal, a);
    const auto moved = [&](const glm::dvec3& by) { return cascade.world_to_shadow * glm::dvec4(by, 0.0); };
    const glm::dvec4 along_a = moved(a), along_b = moved(b);
    const double determinant = along_a.x * along_b.y - along_a.y * along_b.x;
    slope_x = -(along_a.z * along_b.y - along_b.z * along_a.y) / determinant / frame.atlas.width;
    slope_y = -(along_b.z * along_a.x - along_a.z * along_b.x) / determinant / frame.atlas.height;
    const glm::dvec4 tile = cascade.offset_scale;
    left_ = static_cast<int>(std::lround(tile.x * frame.atlas.width));
    top_ = static_cast<int>(std::lround(tile.y * frame.atlas.height));
  }
  Real centred(int x, int y) const {
    return 0.5L - frame_.atlas.depth[static_cast<std::size_t>((y + top_) * frame_.atlas.width + x + left_)];
  }
  Box around(const Receiver& at, Real reach) const {
    const Real end = side;
    return {std::max(at.x - reach, Real(0)), std::max(at.y - reach, Real(0)), std::min(at.x + reach, end),
            std::min(at.y + reach, end)};
  }
  Moments mean(const Box& box, const std::function<Moments(Real)>& stored) const {
    Moments sum{};
    for (int y = static_cast<int>(box.top); y < box.bottom; ++y)
      for (int x = static_cast<int>(box.left); x < box.right; ++x) {
        const Real across = std::min(box.right, Real(x + 1)) - std::max(box.left, Real(x));
        const Real down = std::min(box.bottom, Real(y + 1)) - std::max(box.top, Real(y));
        const Moments texel = stored(centred(x, y));
        for (std::size_t k = 0; k < 4; ++k) sum[k] += across * down * texel[k];
      }
    for (Real& moment : sum) moment /= box.area();
    return sum;
  }
  Real plane(const Receiver& at, const Box& box) const {
    const Real depth = at.depth + slope_x * ((box.left + box.right) / 2 - at.x) +
                       slope_y * ((box.top + box.bottom) / 2 - at.y);
    return std::clamp(depth, Real(-0.5), Real(0.5));
  }
  Real spread(Real width, Real height) const {
    return (slope_x * slope_x * std::max(width * width - 1, Real(0)) +
            slope_y * slope_y * std::max(height * height - 1, Real(0))) /
           12;
  }

 private:
  const scene::Frame& frame_;
  int left_ = 0, top_ = 0;

 public:
  int side;
  Real texels_per_depth = 0, slope_x = 0, slope_y = 0;
};

Box whole(const Box& box) {
  return {std::floor(box.left + 0.5L), std::floor(box.top + 0.5L), std::floor(box.right + 0.5L),
          std::floor(box.bottom + 0.5L)};
}

const Real kBoxOfDisc = std::sqrt(Real(3)) / 2;
constexpr Real kNegligible = 0.004L;
constexpr Real kSettled = 0.7L;
const Real kFloat = std::ldexp(Real(1), -24);

struct Blockers {
  Real share = 0, gap_sum = 0, visible = 0;
};

Real value(const techniques::Technique& technique, const std::string& name) {
  return technique.values.at(name)[0];
}

Real reduced(Real bound, const techniques::Technique& technique) {
  const Real bleeding = value(technique, "bleeding");
  return std::clamp((bound - bleeding) / (1 - bleeding), Real(0), Real(1));
}

// The steps of variance soft shadow mapping.
class VarianceModel {
 public:
  VarianceModel(const Map& map, const techniques::Technique& technique) : map_(map), technique_(technique) {}

  Real visibility(const Receiver& at, const Signs& signs) const {
    const Real floor = value(technique_, "minFilterTexels");
    const Real search = std::max((at.depth + 0.5L) * map_.texels_per_depth, floor);
    Real radius = search;
    for (int i = 0; i < value(technique_, "searches"); ++i) {
      const Real searched = radius;
      const Blockers found =
          judged(at, whole(map_.around(at, std::min(searched * kBoxOfDisc, Real(511)))), signs.search);
      if (!(found.share > kNegligible)) return 1;
      radius = std::min(std::max(found.gap_sum / found.share * map_.texels_per_depth, floor), searched);
      if (radius > kSettled * searched) break;
    }
    return reduced(judged(at, map_.around(at, radius * kBoxOfDisc), signs.filter).visible, technique_);
  }

 private:
  static Moments powers(Real z) { return {z, z * z, 0, 0}; }
  Blockers bounded(const Receiver& at, const Box& box, int sign, bool* divide = nullptr) const {
    const Moments mean = map_.mean(box, powers);
    const Real smallest = value(technique_, "smallestVariance") + map_.spread(2, 2);
    const Real first = mean[0] + ((sign & 1) != 0 ? kFloat : -kFloat);
    const Real second =
        mean[1] + ((sign & 2) != 0 ? kFloat : -kFloat) - map_.spread(box.width(), box.height());
    const Real depth = map_.plane(at, box);
    Blockers blockers;
    blockers.visible = testing_bounds::chebyshev(first, second, depth, smallest);
    blockers.share = 1 - blockers.visible;
    blockers.gap_sum = std::max(depth - first, Real(0));
    if (divide != nullptr)
      *divide = depth <= first && testing_bounds::chebyshev(-first, second, -depth, smallest) > kNegligible;
    return blockers;
  }
  // The area is judged by its mean, or, where that lies behind, in nine cells of whole texels.
  Blockers judged(const Receiver& at, const Box& box, int sign) const {
    bool divide = false;
    Blockers blockers = bounded(at, box, sign, &divide);
    if (!divide) return blockers;
    const Box all = whole(box);
    const auto edge = [](Real low, Real high, int k) { return low + std::floor(k * (high - low) / 3); };
    blockers = {};
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) {
        const Box cell{edge(all.left, all.right, column), edge(all.top, all.bottom, row),
                       edge(all.left, all.right, column + 1), edge(all.top, all.bottom, row + 1)};
        if (cell.area() <= 0) continue;
        const Blockers own = bounded(at, cell, sign);
        blockers.share += cell.area() / all.area() * own.share;
        blockers.gap_sum += cell.area() / all.area() * own.gap_sum;
        blockers.visible += cell.area() / all.area() * own.visible;
      }
    return blockers;
  }

  const Map& map_;
  const techniques::Technique& technique_;
};

// The steps of moment soft shadow mapping.
class MomentModel {
 public:
  MomentModel(const Map& map, const techniques::Technique& technique) : map_(map), technique_(technique) {}

  Real visibility(const Receiver& at, const Signs& signs) const {
    const Real floor = value(technique_, "minFilterTexels"), mix = value(technique_, "mix");
    const Real search = std::max((at.depth + 0.5L) * map_.texels_per_depth, floor);
    Real radius = search;
    for (int i = 0; i < value(technique_, "searches"); ++i) {
      const Real searched = radius;
      const Box area = whole(map_.around(at, std::min(searched * kBoxOfDisc, Real(127))));
      const testing_bounds::Nearer found =
          testing_bounds::nearer(means(area, signs.search), middle(at, area), mix);
      if (!(found.share > kNegligible)) return 1;
      const Real gap = found.gap_sum / found.share / 2;
      radius = std::min(std::max(gap * map_.texels_per_depth, floor), searched);
      if (radius > kSettled * searched) break;
    }
    const Box box = map_.around(at, std::min(radius * kBoxOfDisc, Real(127)));
    const Real bound = testing_bounds::hamburger(means(box, signs.filter), middle(at, box), mix);
    return reduced(bound / (1 - 2 * mix), technique_);
  }

 private:
  Real middle(const Receiver& at, const Box& box) const { return 2 * map_.plane(at, box); }
  // The means as they are stored: in steps of 1 / 65535.
  Moments means(const Box& box, int sign) const {
    const auto stored = [](Real depth) {
      const Real z = 2 * depth, cube = z * z * z;
      const auto rounded = [](Real x) { return std::floor(x * 65535 + 0.5L) / 65535; };
      return Moments{rounded(0.5L + 1.5L * z - 2 * cube), rounded(4 * z * z - 4 * z * z * z * z),
                     rounded(0.5L + std::sqrt(Real(3)) * (z / 2 - 2 * cube / 9)), rounded(z * z * z * z)};
    };
    Moments s = map_.mean(box, stored);
    for (std::size_t k = 0; k < 4; ++k) s[k] += ((sign >> k & 1) != 0 ? kFloat : -kFloat);
    // The system ((3/2, -2), (sqrt(3)/2, -2 sqrt(3)/9)) is solved.
    const Real a = s[0] - 0.5L, c = s[2] - 0.5L, root = std::sqrt(Real(3));
    const Real determinant = 1.5L * (-2 * root / 9) + 2 * root / 2;
    return {(-2 * root / 9 * a + 2 * c) / determinant, s[1] / 4 + s[3],
            (1.5L * c - root / 2 * a) / determinant, s[3]};
  }

  const Map& map_;
  const techniques::Technique& technique_;
};

struct Interval {
  double least = 1.0;
  double most = 0.0;
};

// The receiver's position and its transform are floats.
constexpr Real kDepthError = 1e-6L;
constexpr Real kTexelError = 2e-4L;

template <typename Model>
Interval within_rounding(const Model& model, const Receiver& at, int signs) {
  Interval interval;
  for (const Real dx : {-kTexelError, Real(0), kTexelError})
    for (const Real dy : {-kTexelError, Real(0), kTexelError})
      for (const Real dz : {-kDepthError, Real(0), kDepthError})
        for (int sign = 0; sign < signs; ++sign) {
          const auto visible = static_cast<double>(
              model.visibility({at.x + dx, at.y + dy, at.depth + dz}, {sign, (sign * 7 + 3) % signs}));
          interval.least = std::min(interval.least, visible);
          interval.most = std::max(interval.most, visible);
        }
  return interval;
}

using testing_frames::TilePoint;

// A row and column of receivers before the occluder; the tile's neighbours hold `outside`, or occluders too.
scene::Frame frame_of(double degrees, const std::function<TilePoint(int column, int row)>& receiver,
                      std::optional<float> outside = std::nullopt) {
  testing_frames::FrameSetup setup;
  setup.shadows.resolution = 64;
  setup.shadows.cascades = 4;
  setup.shadows.reversed_z = true;
  setup.light.angular_diameter_degrees = degrees;
  setup.cascade = kCascade;
  std::vector<TilePoint> receivers;
  for (int i = 0; i < kColumns * kColumns; ++i) receivers.push_back(receiver(i % kColumns, i / kColumns));
  return testing_frames::make_frame(
      setup,
      [outside](double u, double v, int tile) {
        return outside && tile != kCascade ? *outside : static_cast<float>(1.0 - depth_at(u, v, tile));
      },
      receivers, kColumns);
}

template <typename Model>
void expect_model(const std::string& name, const glm::dvec3& tilt, int signs) {
  // The places lie between texels, the tile's borders included.
  const auto place = [](int column, int row) {
    return TilePoint((column * 2 + 0.7) / 32.0, (row * 2 + 0.3) / 32.0, 1.0 - kReceiver);
  };
  scene::Frame frame = frame_of(9.0, place);
  for (glm::vec4& normal : frame.receivers.normal_ws)
    normal = glm::vec4(glm::normalize(glm::vec3(normal) + glm::vec3(tilt)), 0.0f);
  const techniques::TechniqueList& list = library_techniques();
  const techniques::Technique& technique = list.find(name);
  GraphRunner runner(test_device(), compile(technique_graph(list, technique)));
  const GraphResult result = runner.run(FrameOnDevice(test_device(), frame), kOnce);
  EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());

  const Map map(frame);
  const Model model(map, technique);
  int between = 0;
  double widths = 0.0;
  for (std::size_t i = 0; i < result.visibility[0].size(); ++i) {
    const TilePoint of = place(static_cast<int>(i) % kColumns, static_cast<int>(i) / kColumns);
    const Receiver at{Real(of.x) * map.side, Real(of.y) * map.side, kReceiver - 0.5L};
    const auto [least, most] = within_rounding(model, at, signs);
    EXPECT_GE(result.visibility[0][i], least - 1e-4) << at.x << ", " << at.y;
    EXPECT_LE(result.visibility[0][i], most + 1e-4) << at.x << ", " << at.y;
    between += least > 0.05 && most < 0.95 ? 1 : 0;
    widths += most - least;
  }
  EXPECT_LT(widths / (kColumns * kColumns), 0.02) << "the intervals say something";
  EXPECT_GT(between, 10) << "penumbra receivers";
}

// The tilt is known by the receiver's plane alone.
TEST(SoftShadows, OfSumsGiveTheLightOfThePapersSteps) {
  for (const glm::dvec3 tilt : {glm::dvec3(0, 0, 0), {0.02, 0, 0.01}}) {
    SCOPED_TRACE(tilt.x);
    expect_model<VarianceModel>("vssm-sat-32", tilt, 4);
    expect_model<MomentModel>("mssm-sat-32", tilt, 16);
  }
}

// Lit receivers search once; behind a wall the first search settles where its penumbra is as wide as it can
// be.
TEST(SoftShadows, FetchByWhatTheyFind) {
  struct Cost {
    const char* technique;
    unsigned lit, dark;
  };
  for (const Cost& cost : {Cost{"vssm-sat-32", 4, 20}, Cost{"mssm-sat-32", 4, 20}, Cost{"vssm-mip-32", 4, 8},
                           Cost{"vssm-mip-16", 4, 8}, Cost{"mssm-mip-16", 4, 8}, Cost{"evsm-mip", 6, 6}}) {
    const techniques::TechniqueList& list = library_techniques();
    GraphRunner runner(test_device(), compile(technique_graph(list, list.find(cost.technique))));
    for (const bool wall : {false, true}) {
      testing_frames::FrameSetup setup;
      setup.shadows.resolution = 64;
      setup.shadows.reversed_z = true;
      const std::vector<testing_frames::TilePoint> receivers(64, {0.4, 0.6, 0.5});
      const scene::Frame frame = testing_frames::make_frame(
          setup, [wall](double, double, int) { return wall ? 1.0f : 0.0f; }, receivers, 8);
      const GraphResult result = runner.run(FrameOnDevice(test_device(), frame), kCountedOnce);
      EXPECT_THAT(result.fetches, testing::Each(wall ? cost.dark : cost.lit)) << cost.technique;
      EXPECT_THAT(result.visibility[0], testing::Each(testing::FloatNear(wall ? 0.0f : 1.0f, 1e-6F)))
          << cost.technique;
    }
  }
}

// The kernels are as wide as the tile, whose mip levels have a few texels for it: at its borders, too,
// nothing else counts.
TEST(SoftShadows, LearnNothingFromOutsideTheTileWithTheWidestKernels) {
  const techniques::TechniqueList& list = library_techniques();
  for (const char* name :
       {"vssm-sat-32", "mssm-sat-32", "vssm-mip-32", "vssm-mip-16", "mssm-mip-16", "evsm-mip"}) {
    GraphRunner runner(test_device(), compile(technique_graph(list, list.find(name))));
    for (const double degrees : {5.0, 30.0}) {
      std::vector<float> before;
      for (const float poison : {0.0f, 1.0f, std::numeric_limits<float>::quiet_NaN()}) {
        const auto place = [](int column, int row) {
          return TilePoint(column / (kColumns - 1.0), row / (kColumns - 1.0), 1.0 - kReceiver);
        };
        const scene::Frame frame = frame_of(degrees, place, poison);
        const GraphResult result = runner.run(FrameOnDevice(test_device(), frame), kOnce);
        if (before.empty()) before = result.visibility[0];
        for (std::size_t i = 0; i < before.size(); ++i)
          ASSERT_EQ(result.visibility[0][i], before[i])
              << name << " at " << degrees << " degrees, texels outside " << poison << ", receiver " << i;
      }
    }
  }
}

}  // namespace
}  // namespace penumbra::resolve
