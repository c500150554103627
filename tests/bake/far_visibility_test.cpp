// Compares far shadows as shaders compute them with the exact horizon of the same height field.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "bake/baked_files.h"
#include "bake/horizon_angles.h"
#include "bake/made_fields.h"
#include "bake/visibility_kernel.h"

namespace penumbra::bake {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180.0;
const Area kGround{{-500.0, 200.0}, {1280.0, 1280.0}};

struct Parameters {
  float area[4];
  float sun[4];  // direction towards the sun, and half its diameter
  float heights_and_texels[4];
  float ray[4];
  float channels[4] = {1.0F, 0.0F, 0.0F, 0.0F};
};

struct Sun {
  double elevation = 0.0;  // radians
  double azimuth = 0.0;    // measured from +Z towards +X
  double half_diameter = 0.265 * kDegree;

  glm::dvec3 towards() const {
    return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
            std::cos(elevation) * std::cos(azimuth)};
  }
};

// The exact share of the sun's disc above a straight horizon.
double share_above(double horizon, const Sun& sun) {
  const double edge = std::clamp((horizon - sun.elevation) / sun.half_diameter, -1.0, 1.0);
  return (std::acos(edge) - edge * std::sqrt(1.0 - edge * edge)) / kPi;
}

class FarVisibility : public testing::Test {
 protected:
  explicit FarVisibility(HeightField field = rough_field(129, 129, kGround, 11))
      : device_({.name = "", .validation = true}), log_(device_.validation_log()), field_(std::move(field)) {}
  ~FarVisibility() override { EXPECT_THAT(log_->messages(), testing::IsEmpty()); }

  std::vector<glm::vec4> receivers(int count, std::uint32_t seed) const {
    std::mt19937 bits(seed);
    const auto chance = [&] { return static_cast<double>(bits()) * 0x1p-32; };
    std::vector<glm::vec4> all;
    for (int i = 0; i < count; ++i) {
      const glm::dvec2 at = kGround.corner + kGround.size * glm::dvec2(chance(), chance());
      all.emplace_back(static_cast<float>(at.x), static_cast<float>(field_.height(at)),
                       static_cast<float>(at.y), 1.0F);
    }
    return all;
  }

  std::vector<glm::vec4> texel_centres(const HorizonAngles& angles) const {
    std::vector<glm::vec4> all;
    for (int z = 0; z < angles.depth; ++z)
      for (int x = 0; x < angles.width; ++x) {
        const glm::dvec2 at = angles.centre(x, z);
        all.emplace_back(static_cast<float>(at.x), static_cast<float>(field_.height(at)),
                         static_cast<float>(at.y), 1.0F);
      }
    return all;
  }

  double exact(const glm::vec4& receiver, const Sun& sun, double nearest) const {
    const double slope = search_.steepest({receiver.x, receiver.z}, static_cast<double>(receiver.y),
                                          {std::sin(sun.azimuth), std::cos(sun.azimuth)}, nearest);
    return share_above(std::atan(std::max(slope, 0.0)), sun);
  }

  // The picture holds the angles as the files do, in 16 bits.
  gpu::Image picture(const HorizonAngles& angles, int first) const {
    std::vector<std::uint16_t> samples;
    for (std::size_t i = 0; i < angles.radians[0].size(); ++i)
      for (int channel = 0; channel < 4; ++channel)
        samples.push_back(as_16_bits(
            static_cast<double>(angles.radians[static_cast<std::size_t>(first + channel)][i]) / (kPi / 2.0)));
    gpu::Image image(device_, gpu::Format::rgba16, angles.width, angles.depth);
    image.upload(std::span<const std::uint16_t>(samples));
    return image;
  }

  gpu::Image heights() const {
    std::vector<std::uint16_t> samples;
    for (const float metres : field_.metres)
      samples.push_back(as_16_bits((static_cast<double>(metres) - low_) / (high_ - low_)));
    gpu::Image image(device_, gpu::Format::r16, field_.width, field_.depth);
    image.upload(std::span<const std::uint16_t>(samples));
    return image;
  }

  Parameters parameters(const Sun& sun) const {
    const glm::dvec3 towards = sun.towards();
    const Area& ground = field_.area;
    return {{static_cast<float>(ground.corner.x), static_cast<float>(ground.corner.y),
             static_cast<float>(ground.size.x), static_cast<float>(ground.size.y)},
            {static_cast<float>(towards.x), static_cast<float>(towards.y), static_cast<float>(towards.z),
             static_cast<float>(sun.half_diameter)},
            {static_cast<float>(low_), static_cast<float>(high_), static_cast<float>(field_.width),
             static_cast<float>(field_.depth)},
            {0.0F, 0.0F, 0.0F, 0.0F},
            {1.0F, 0.0F, 0.0F, 0.0F}};
  }

  std::vector<float> run(const std::string& entry, const std::map<std::string, const gpu::Image*>& images,
                         const Parameters& parameters, std::vector<glm::vec4> receivers) {
    return run_kernel(device_, "FarVisibility.hlsl", entry, images, parameters, std::move(receivers));
  }

  std::vector<float> by_angles(const HorizonAngles& angles, const Sun& sun,
                               const std::vector<glm::vec4>& receivers) {
    const gpu::Image first = picture(angles, 0), second = picture(angles, 4);
    return run("Angles", {{"_First", &first}, {"_Second", &second}}, parameters(sun), receivers);
  }

  // The image holds the heights as a terrain of Unity does: up to 32766 of 65535, in one channel of 16 bits
  // or two of 8.
  gpu::Image terrain(bool in_two_channels) const {
    std::vector<std::uint16_t> words;
    std::vector<std::uint8_t> bytes;
    for (const float metres : field_.metres) {
      const auto word = static_cast<std::uint16_t>(
          std::lround((static_cast<double>(metres) - low_) / (high_ - low_) * kTerrainTop));
      words.push_back(word);
      bytes.push_back(static_cast<std::uint8_t>(word & 0xFF));
      bytes.push_back(static_cast<std::uint8_t>(word >> 8));
    }
    gpu::Image image(device_, in_two_channels ? gpu::Format::rg8 : gpu::Format::r16, field_.width,
                     field_.depth);
    if (in_two_channels)
      image.upload(std::span<const std::uint8_t>(bytes));
    else
      image.upload(std::span<const std::uint16_t>(words));
    return image;
  }

  std::vector<float> by_trace(int steps, double nearest, const Sun& sun,
                              const std::vector<glm::vec4>& receivers) {
    return by_trace(heights(), {1.0, 0.0}, steps, nearest, sun, receivers);
  }

  std::vector<float> by_trace(const gpu::Image& image, glm::dvec2 channels, int steps, double nearest,
                              const Sun& sun, const std::vector<glm::vec4>& receivers) {
    Parameters all = parameters(sun);
    all.ray[0] = static_cast<float>(nearest);
    all.ray[1] = static_cast<float>(steps);
    all.ray[2] = 0.5F;
    all.channels[0] = static_cast<float>(channels.x);
    all.channels[1] = static_cast<float>(channels.y);
    return run("Trace", {{"_Heights", &image}}, all, receivers);
  }

  double rmse(const std::vector<float>& seen, const std::vector<glm::vec4>& receivers, const Sun& sun,
              double nearest) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const double error = static_cast<double>(seen[i]) - exact(receivers[i], sun, nearest);
      sum += error * error;
    }
    return std::sqrt(sum / static_cast<double>(seen.size()));
  }

  static constexpr double kTerrainTop = 32766.0;

  gpu::Device device_;
  std::shared_ptr<const gpu::ValidationLog> log_;
  const HeightField field_;
  const HorizonSearch search_{field_};
  const double low_ = *std::min_element(field_.metres.begin(), field_.metres.end());
  const double high_ = *std::max_element(field_.metres.begin(), field_.metres.end());
};

// Nothing is interpolated at the centres of texels, in the directions that were baked: the sun's disc is 0.5
// degrees and a step of 16 bits 0.0014.
TEST_F(FarVisibility, ByAnglesIsExactWhereTheyWereBaked) {
  const HorizonAngles angles = bake_horizon_angles(field_, {48, 48, 30.0});
  const std::vector<glm::vec4> centres = texel_centres(angles);
  int shadowed = 0, partly = 0;
  for (int number = 0; number < horizon_directions; ++number) {
    const Sun sun{9.0 * kDegree, number * kPi / 4.0};
    const std::vector<float> seen = by_angles(angles, sun, centres);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const double wanted = exact(centres[i], sun, 30.0);
      ASSERT_NEAR(seen[i], wanted, 0.02) << number << " " << i;
      shadowed += wanted < 0.01 ? 1 : 0;
      partly += wanted > 0.01 && wanted < 0.99 ? 1 : 0;
    }
  }
  EXPECT_GT(shadowed, 1000);
  EXPECT_GT(partly, 100);
}

TEST_F(FarVisibility, ByAnglesIsNearerTheMoreTexelsThereAre) {
  const Sun sun{12.0 * kDegree, 0.7};
  const std::vector<glm::vec4> places = receivers(4096, 3);
  double before = 1.0;
  for (const int texels : {16, 64, 256}) {
    const double error =
        rmse(by_angles(bake_horizon_angles(field_, {texels, texels, 30.0}), sun, places), places, sun, 30.0);
    EXPECT_LT(error, before) << texels;
    RecordProperty("rmse_" + std::to_string(texels), std::to_string(error));
    before = error;
  }
}

TEST_F(FarVisibility, ByTraceConvergesToTheExactHorizon) {
  const Sun sun{12.0 * kDegree, 0.7};
  const std::vector<glm::vec4> places = receivers(4096, 5);
  double before = 1.0;
  for (const int steps : {4, 16, 64, 256}) {
    const double error = rmse(by_trace(steps, 30.0, sun, places), places, sun, 30.0);
    EXPECT_LT(error, before) << steps;
    RecordProperty("rmse_" + std::to_string(steps), std::to_string(error));
    before = error;
  }
  EXPECT_LT(before, 0.05);
}

// A plain with a ridge at 6 km that reaches over the rays for about 400 m, and a mountain beside them that
// makes the rays 12 km long. There 64 steps are 270 m apart; in proportion to the distance they would be 600
// m.
class FarRidge : public FarVisibility {
 protected:
  FarRidge()
      : FarVisibility(made_field(241, 241, {{0.0, 0.0}, {12'000.0, 12'000.0}}, [](glm::dvec2 at) {
          const double across = (at.y - 6000.0) / 400.0;
          return at.x > 11'900.0 ? 1000.0 : 650.0 * std::exp(-across * across);
        })) {}
};

TEST_F(FarRidge, LiesBetweenNoTwoOf64Steps) {
  const Sun sun{5.0 * kDegree, 0.0};
  std::vector<glm::vec4> places;
  for (int i = 0; i < 400; ++i)
    places.emplace_back(1000.0F + 10.0F * static_cast<float>(i), 0.0F, static_cast<float>(i), 1.0F);
  const std::vector<float> seen = by_trace(64, 20.0, sun, places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    ASSERT_LT(exact(places[i], sun, 20.0), 0.01) << i;
    ASSERT_LT(seen[i], 0.5F) << i;
  }
  // The ridge hides the sun.
  EXPECT_THAT(by_trace(64, 20.0, {12.0 * kDegree, 0.0}, places), testing::Each(1.0F));
}

// A terrain of Unity holds the same heights with 15 bits; half of its range is not used.
TEST_F(FarVisibility, ByTraceReadsATerrainsHeights) {
  const Sun sun{12.0 * kDegree, 0.7};
  const std::vector<glm::vec4> places = receivers(4096, 5);
  const std::vector<float> baked = by_trace(32, 30.0, sun, places);
  const double scale = 65535.0 / kTerrainTop;
  const glm::dvec2 one_channel{scale, 0.0}, two_channels{scale / 257.0, scale * 256.0 / 257.0};
  // The slack is a step of 15 bits at 30 metres.
  const double step = (high_ - low_) / kTerrainTop;
  for (const bool two : {false, true}) {
    const std::vector<float> seen =
        by_trace(terrain(two), two ? two_channels : one_channel, 32, 30.0, sun, places);
    const double slack = std::atan(step / 30.0) / sun.half_diameter + 1e-3;
    int shadowed = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      ASSERT_NEAR(seen[i], baked[i], slack) << two << " " << i;
      shadowed += seen[i] < 0.5F ? 1 : 0;
    }
    EXPECT_GT(shadowed, 100);
  }
}

// The search finds nothing that is not there: ground that is marched is never steeper than the exact horizon.
TEST_F(FarVisibility, ByTraceNeverFindsShadowThatIsNone) {
  for (const double elevation : {3.0, 12.0, 40.0}) {
    const Sun sun{elevation * kDegree, 4.1};
    const std::vector<glm::vec4> places = receivers(2048, 9);
    const std::vector<float> seen = by_trace(16, 30.0, sun, places);
    // The slack is that of heights of 16 bits, at 30 metres.
    const double slack = std::atan((high_ - low_) / 65535.0 / 30.0) / sun.half_diameter + 1e-3;
    for (std::size_t i = 0; i < seen.size(); ++i)
      ASSERT_GE(seen[i], exact(places[i], sun, 29.0) - slack) << elevation << " " << i;
  }
}

TEST_F(FarVisibility, LevelGroundIsLitAndASunBelowItShinesOnNothing) {
  const HeightField level = made_field(8, 8, kGround, [](glm::dvec2) { return 3.0; });
  const HorizonAngles angles = bake_horizon_angles(level, {8, 8, 0.0});
  const std::vector<glm::vec4> places = receivers(256, 1);
  EXPECT_THAT(by_angles(angles, {5.0 * kDegree, 1.0}, places), testing::Each(1.0F));
  EXPECT_THAT(by_angles(angles, {-1.0 * kDegree, 1.0}, places), testing::Each(0.0F));
  EXPECT_THAT(by_trace(8, 30.0, {-1.0 * kDegree, 1.0}, places), testing::Each(0.0F));
}

TEST_F(FarVisibility, BesideTheMapAllIsLit) {
  const HorizonAngles angles = bake_horizon_angles(field_, {16, 16, 30.0});
  const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
  const std::vector<glm::vec4> beside{{-501.0F, 0.0F, 300.0F, 1.0F},
                                      {0.0F, 0.0F, 1e9F, 1.0F},
                                      {nan, 0.0F, 300.0F, 1.0F},
                                      {0.0F, 0.0F, infinity, 1.0F}};
  const Sun sun{2.0 * kDegree, 2.0};
  EXPECT_THAT(by_angles(angles, sun, beside), testing::Each(1.0F));
  EXPECT_THAT(by_trace(8, 30.0, sun, beside), testing::Each(1.0F));
}

// A formula makes the layer: on each receiver lies the shadow of the cloud between it and the sun.
TEST_F(FarVisibility, CloudsAreThoseOnTheWayToTheSun) {
  const auto transmittance = [](double u, double v) {
    return 0.5 + 0.4 * std::sin(9.0 * u + 1.0) * std::cos(7.0 * v);
  };
  constexpr int kTexels = 256;
  std::vector<std::uint16_t> samples;
  for (int y = 0; y < kTexels; ++y)
    for (int x = 0; x < kTexels; ++x)
      samples.push_back(as_16_bits(transmittance((x + 0.5) / kTexels, (y + 0.5) / kTexels)));
  gpu::Image map(device_, gpu::Format::r16, kTexels, kTexels);
  map.upload(std::span<const std::uint16_t>(samples));
  constexpr double kHeight = 1500.0, kBorder = 0.1;
  const std::vector<glm::vec4> places = receivers(2048, 21);
  int shadowed = 0, faded = 0, beside = 0;
  for (const Sun& sun : {Sun{80.0 * kDegree, 0.3}, Sun{60.0 * kDegree, 4.0}, Sun{35.0 * kDegree, 2.0}}) {
    Parameters all = parameters(sun);
    all.heights_and_texels[0] = static_cast<float>(kHeight);
    all.heights_and_texels[1] = static_cast<float>(kBorder);
    const std::vector<float> seen = run("Clouds", {{"_Clouds", &map}}, all, places);
    const glm::dvec3 towards = sun.towards();
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const double way = (kHeight - static_cast<double>(places[i].y)) / towards.y;
      const glm::dvec2 uv =
          (glm::dvec2(places[i].x, places[i].z) + way * glm::dvec2(towards.x, towards.z) - kGround.corner) /
          kGround.size;
      const double least = std::min({uv.x, 1.0 - uv.x, uv.y, 1.0 - uv.y});
      const double weight = least < 0.0 ? 0.0 : std::min(least / kBorder, 1.0);
      const double wanted = 1.0 + weight * (std::pow(transmittance(uv.x, uv.y), 1.0 / towards.y) - 1.0);
      ASSERT_NEAR(seen[i], wanted, 2e-3) << i;
      (weight == 1.0 ? shadowed : weight > 0.0 ? faded : beside) += 1;
    }
  }
  EXPECT_GT(shadowed, 300);
  EXPECT_GT(faded, 300);
  EXPECT_GT(beside, 300);
}

TEST_F(FarVisibility, StaysInRangeWhateverItIsGiven) {
  const HorizonAngles angles = bake_horizon_angles(field_, {16, 16, 30.0});
  const gpu::Image first = picture(angles, 0), second = picture(angles, 4), ground = heights();
  const gpu::Image& clouds = ground;
  const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
  const std::vector<float> odd{nan, infinity, -infinity, 0.0F, -0.0F, 1e30F, -1e30F, 1e-30F, 1.0F};
  std::vector<glm::vec4> places = receivers(60, 2);
  for (const float value : odd) places.emplace_back(0.0F, value, 500.0F, 1.0F);
  std::mt19937 bits(77);
  const auto one = [&] { return odd[bits() % odd.size()]; };
  for (int round = 0; round < 60; ++round) {
    Parameters all = parameters({0.2, 1.0});
    for (float& value : all.sun) value = one();
    if (round % 2 == 0)
      for (float& value : all.ray) value = one();
    if (round % 3 == 0)
      for (float& value : all.heights_and_texels) value = one();
    if (round % 5 == 0)
      for (float& value : all.area) value = one();
    if (round % 7 == 0)
      for (float& value : all.channels) value = one();
    for (const float seen : run("Angles", {{"_First", &first}, {"_Second", &second}}, all, places))
      ASSERT_TRUE(seen >= 0.0F && seen <= 1.0F) << round;
    for (const float seen : run("Clouds", {{"_Clouds", &clouds}}, all, places))
      ASSERT_TRUE(seen >= 0.0F && seen <= 1.0F) << round;
    for (const float seen : run("Trace", {{"_Heights", &ground}}, all, places))
      ASSERT_TRUE(seen >= 0.0F && seen <= 1.0F) << round;
  }
}

}  // namespace
}  // namespace penumbra::bake
