// Shadows through distance fields, against a sphere's own shadow under a disc light.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

#include "bake/baked_files.h"
#include "bake/distance_field.h"
#include "bake/visibility_kernel.h"

namespace penumbra::bake {
namespace {

struct FieldParameters {
  float corner[4];
  float size[4];
  float light[4];
  float march[4];
};

// The field of a sphere about the origin comes from its equation, so that the march is tested.
DistanceField field_of_sphere(double radius, int voxels, double half_box) {
  DistanceField field{{voxels, voxels, voxels}, {glm::dvec3(-half_box), glm::dvec3(half_box)}, {}, 0};
  for (int z = 0; z < voxels; ++z)
    for (int y = 0; y < voxels; ++y)
      for (int x = 0; x < voxels; ++x)
        field.metres.push_back(static_cast<float>(glm::length(field.centre(x, y, z)) - radius));
  return field;
}

// The share of a disc of radius `light` that one of radius `blocker` at a distance leaves free; both angles
// are small.
double free_share(double light, double blocker, double apart) {
  if (apart >= light + blocker) return 1.0;
  if (apart <= std::abs(light - blocker))
    return blocker >= light ? 0.0 : 1.0 - blocker * blocker / (light * light);
  const auto segment = [](double radius, double edge) {
    return radius * radius * std::acos(edge / radius) - edge * std::sqrt(radius * radius - edge * edge);
  };
  const double edge = (apart * apart + light * light - blocker * blocker) / (2.0 * apart);
  const double lens = segment(light, edge) + segment(blocker, apart - edge);
  return 1.0 - lens / (std::acos(-1.0) * light * light);
}

class FieldVisibility : public testing::Test {
 protected:
  FieldVisibility() : device_({.name = "", .validation = true}), log_(device_.validation_log()) {}
  ~FieldVisibility() override { EXPECT_THAT(log_->messages(), testing::IsEmpty()); }

  gpu::Image texture(const DistanceField& field) const {
    std::vector<std::uint16_t> samples;
    const double most = largest(field);
    for (const float metres : field.metres)
      samples.push_back(as_16_bits(0.5 + 0.5 * static_cast<double>(metres) / most));
    gpu::ImageShape shape;
    shape.format = gpu::Format::r16;
    shape.width = field.voxels[0];
    shape.height = field.voxels[1];
    shape.depth = field.voxels[2];
    gpu::Image image(device_, shape);
    image.upload(std::span<const std::uint16_t>(samples));
    return image;
  }

  static double largest(const DistanceField& field) {
    double most = 0.0;
    for (const float metres : field.metres) most = std::max(most, std::abs(static_cast<double>(metres)));
    return most;
  }

  static FieldParameters parameters(const DistanceField& field, double tan_half, int steps) {
    const glm::dvec3 size = field.box.maximum - field.box.minimum;
    FieldParameters all{};
    for (int axis = 0; axis < 3; ++axis) {
      all.corner[axis] = static_cast<float>(field.box.minimum[axis]);
      all.size[axis] = static_cast<float>(size[axis]);
    }
    all.corner[3] = static_cast<float>(largest(field));
    all.size[3] = static_cast<float>(size.x / field.voxels[0]);
    all.light[1] = 1.0F;
    all.light[3] = static_cast<float>(tan_half);
    all.march[0] = 1000.0F;
    all.march[1] = static_cast<float>(steps);
    return all;
  }

  std::vector<float> run(const char* entry, const DistanceField& field, const FieldParameters& parameters,
                         const std::vector<glm::vec4>& receivers) const {
    const gpu::Image image = texture(field);
    return run_kernel(device_, "FieldVisibility.hlsl", entry, {{"_Field", &image}}, parameters, receivers);
  }

  // The receivers lie on a line under the sphere, from its middle outwards.
  static std::vector<glm::vec4> line(double below, double reach, int count) {
    std::vector<glm::vec4> all;
    for (int i = 0; i < count; ++i)
      all.emplace_back(static_cast<float>(reach * i / count), static_cast<float>(-below), 0.0F, 1.0F);
    return all;
  }

  gpu::Device device_;
  std::shared_ptr<const gpu::ValidationLog> log_;
};

TEST_F(FieldVisibility, AHardShadowIsTheSpheresOwnToAVoxel) {
  const DistanceField field = field_of_sphere(1.0, 48, 1.5);
  const std::vector<glm::vec4> places = line(4.0, 2.0, 512);
  const std::vector<float> seen = run("Hard", field, parameters(field, 0.0, 256), places);
  const double voxel = 3.0 / 48.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double x = static_cast<double>(places[i].x);
    if (x < 1.0 - voxel) {
      ASSERT_EQ(seen[i], 0.0F) << x;
    }
    if (x > 1.0 + voxel) {
      ASSERT_EQ(seen[i], 1.0F) << x;
    }
  }
}

// The error over the penumbra falls as the light gets smaller against the sphere, because the sphere's edge
// gets straighter.
TEST_F(FieldVisibility, ASoftShadowIsThatOfTheDiscLight) {
  const DistanceField field = field_of_sphere(1.0, 96, 1.5);
  const double below = 6.0;
  for (const double tan_half : {0.01, 0.03, 0.08}) {
    const double width = below * tan_half;
    std::vector<glm::vec4> places;
    constexpr int kPlaces = 512;
    for (int i = 0; i < kPlaces; ++i)
      places.emplace_back(static_cast<float>(1.0 + 1.2 * width * (2.0 * i / kPlaces - 1.0)),
                          static_cast<float>(-below), 0.0F, 1.0F);
    const std::vector<float> seen = run("Soft", field, parameters(field, tan_half, 256), places);
    double sum = 0.0, worst = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const double x = static_cast<double>(places[i].x);
      const double distance = std::sqrt(below * below + x * x);
      const double exact = free_share(std::atan(tan_half), std::asin(1.0 / distance), std::atan(x / below));
      const double error = static_cast<double>(seen[i]) - exact;
      sum += error * error;
      worst = std::max(worst, std::abs(error));
    }
    const double rmse = std::sqrt(sum / kPlaces);
    RecordProperty("rmse_" + std::to_string(tan_half), std::to_string(rmse));
    RecordProperty("worst_" + std::to_string(tan_half), std::to_string(worst));
    EXPECT_LT(rmse, 0.02) << tan_half;
    EXPECT_LT(worst, 0.04) << tan_half;
  }
}

// The library is compared with these marches: the least of distance / length along the ray, in radii of the
// disc, is known for a sphere. Quilez's first is dark where it is 0 or less; his later one is its smoothstep
// over [-1, 1].
TEST_F(FieldVisibility, PublishedMarchesAreTheirFormulasOfASphere) {
  const DistanceField field = field_of_sphere(1.0, 96, 1.5);
  const gpu::Image image = texture(field);
  const double below = 6.0;
  for (const double tan_half : {0.02, 0.08}) {
    std::vector<glm::vec4> places;
    constexpr int kPlaces = 512;
    for (int i = 0; i < kPlaces; ++i)
      places.emplace_back(static_cast<float>(1.0 + 1.5 * below * tan_half * (2.0 * i / kPlaces - 1.0)),
                          static_cast<float>(-below), 0.0F, 1.0F);
    const auto run_march = [&](const char* entry) {
      return run_kernel(device_, "FieldMarches.hlsl", entry, {{"_Field", &image}},
                        parameters(field, tan_half, 256), places, 2);
    };
    const std::vector<float> first = run_march("Quilez"), later = run_march("QuilezInner");
    int inner = 0, outer = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double x = static_cast<double>(places[i].x);
      double least = 1.0;
      for (double t = below - 1.5; t < below + 1.5; t += 1e-3)
        least = std::min(least, (std::hypot(x, t - below) - 1.0) / (tan_half * t));
      const double bounded = std::max(least, -1.0);
      // The nearest place may lie in the middle of a step, which is as long as the distance.
      const double step = std::max(x - 1.0, 0.0);
      const double slack = 0.01 + 0.25 * step * step / (2.0 * x) / (tan_half * (below - step));
      ASSERT_NEAR(first[2 * i], std::max(least, 0.0), slack) << x;
      ASSERT_NEAR(later[2 * i], 0.25 * (1.0 + bounded) * (1.0 + bounded) * (2.0 - bounded), slack) << x;
      inner += bounded > -0.9 && bounded < -0.1 ? 1 : 0;
      outer += bounded > 0.1 && bounded < 0.9 ? 1 : 0;
    }
    EXPECT_GT(inner, 100) << tan_half;
    EXPECT_GT(outer, 100) << tan_half;
  }
}

TEST_F(FieldVisibility, WhatTheRayDoesNotReachCastsNothing) {
  const DistanceField field = field_of_sphere(1.0, 24, 1.5);
  for (const char* entry : {"Hard", "Soft"}) {
    FieldParameters away = parameters(field, 0.01, 64);
    const std::vector<glm::vec4> below = line(4.0, 0.5, 64);
    EXPECT_THAT(run(entry, field, away, below), testing::Each(0.0F)) << entry;
    away.march[0] = 2.0F;  // it ends before the box
    EXPECT_THAT(run(entry, field, away, below), testing::Each(1.0F)) << entry;
    away.march[0] = 1000.0F;
    away.light[1] = -1.0F;  // behind
    EXPECT_THAT(run(entry, field, away, below), testing::Each(1.0F)) << entry;
    EXPECT_THAT(run(entry, field, parameters(field, 0.01, 64), line(-4.0, 0.5, 64)), testing::Each(1.0F))
        << entry << " above";
  }
}

TEST_F(FieldVisibility, StaysInRangeWhateverItIsGiven) {
  const DistanceField field = field_of_sphere(1.0, 12, 1.5);
  const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
  const std::vector<float> odd{nan, infinity, -infinity, 0.0F, -0.0F, 1e30F, -1e30F, 1e-30F, 1.0F};
  std::mt19937 bits(12);
  const auto one = [&] { return odd[bits() % odd.size()]; };
  std::vector<glm::vec4> places = line(4.0, 2.0, 32);
  for (int i = 0; i < 96; ++i) places.emplace_back(one(), one(), one(), 1.0F);
  for (int round = 0; round < 40; ++round) {
    FieldParameters all = parameters(field, 0.02, 32);
    if (round > 0)
      for (float& value : all.light) value = one();
    if (round % 2 == 1)
      for (float& value : all.march) value = one();
    if (round % 3 == 1)
      for (float& value : all.corner) value = one();
    if (round % 5 == 1)
      for (float& value : all.size) value = one();
    for (const char* entry : {"Hard", "Soft"})
      for (const float seen : run(entry, field, all, places))
        ASSERT_TRUE(seen >= 0.0F && seen <= 1.0F) << entry << " " << round;
  }
}

}  // namespace
}  // namespace penumbra::bake
