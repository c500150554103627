// Shadows of several objects from one texture of distances, against ray tracing.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

#include "bake/made_shapes.h"
#include "bake/ray_traced_share.h"
#include "bake/visibility_kernel.h"
#include "reference/closest_surface.h"

namespace penumbra::bake {
namespace {

struct FieldSceneParameters {
  float light[4];
  float march[4];
  float normal[4];
};

FieldSceneParameters scene_parameters(const SeenDisc& light) {
  FieldSceneParameters all{};
  for (int i = 0; i < 3; ++i) all.light[i] = static_cast<float>(light.towards[i]);
  all.light[3] = static_cast<float>(light.tan_half);
  all.march[0] = 1000.0F;
  all.march[1] = 256.0F;
  return all;
}

class FieldScene : public testing::Test {
 protected:
  FieldScene() : device_({.name = "", .validation = true}), log_(device_.validation_log()) {}
  ~FieldScene() override { EXPECT_THAT(log_->messages(), testing::IsEmpty()); }

  std::vector<float> run(const char* entry, const gpu::Image& image, const std::vector<glm::vec4>& uniforms,
                         const FieldSceneParameters& parameters, const std::vector<glm::vec4>& places) const {
    return run_kernel(device_, "FieldScene.hlsl", entry, {{"_Field", &image}}, parameters, places, 1,
                      uniforms);
  }

  double chance() { return static_cast<double>(bits_()) * 0x1p-32; }
  glm::dvec3 place(double half) {
    const double x = chance(), y = chance(), z = chance();
    return half * (2.0 * glm::dvec3(x, y, z) - 1.0);
  }

  // 256 places across the light, `away` metres behind the middle and up to `reach` beside it, and the share
  // of the light that rays from each reach; those that are wanted.
  struct Penumbra {
    std::vector<glm::vec4> places;
    std::vector<double> exact;
    double rmse(const std::vector<float>& seen) const {
      double sum = 0.0;
      for (std::size_t i = 0; i < seen.size(); ++i)
        sum += std::pow(static_cast<double>(seen[i]) - exact[i], 2.0);
      return std::sqrt(sum / 256.0);
    }
  };
  template <typename Wanted>
  Penumbra penumbra(const reference::EmbreeScene& rays, const SeenDisc& light, const glm::dvec3& middle,
                    double away, double reach, int rays_each, const Wanted& wanted) {
    Penumbra found;
    while (found.places.size() < 256) {
      const glm::dvec3 at = middle - away * light.towards + reach * (2.0 * chance() - 1.0) * light.right() +
                            reach * (2.0 * chance() - 1.0) * light.up();
      const double share = lit_share(rays, at, light, rays_each);
      if (!wanted(at, share)) continue;
      found.places.emplace_back(glm::vec3(at), 1.0F);
      found.exact.push_back(share);
    }
    return found;
  }
  static bool is_partly_lit(const glm::dvec3&, double share) { return share > 0.0 && share < 1.0; }

  gpu::Device device_;
  std::shared_ptr<const gpu::ValidationLog> log_;
  std::mt19937 bits_{7};
};

const SeenDisc kOblique{glm::normalize(glm::dvec3(0.36, 0.8, 0.48)), 0.05};

scene::Scene three_objects() {
  return joined({moved(box({0.5F, 0.4F, 0.3F}), {1.5, 0.0, 0.0}),
                 moved(torus(0.5, 0.18, 48, 24), {-1.2, 0.4, 0.3}), sphere(0.4, 48, 32)});
}

TEST_F(FieldScene, TexelsOfOtherObjectsHaveNoWeight) {
  const ObjectFields fields = bake_object_fields(three_objects(), {16, {16, 0.1}});
  ASSERT_EQ(fields.objects.size(), 3U);
  const std::vector<std::uint16_t> texels = fields.texels();
  const std::vector<glm::vec4> uniforms = field_uniforms(fields);
  for (std::size_t i = 0; i < 3; ++i) {
    const ObjectField& object = fields.objects[i];
    std::vector<glm::vec4> one = uniforms;
    one[0].w = 1.0F;
    for (std::size_t row = 0; row < 6; ++row) one[1 + row] = uniforms[1 + 6 * i + row];
    const glm::dvec3 middle = 0.5 * (object.field.box.minimum + object.field.box.maximum);
    std::vector<glm::vec4> places;
    for (int j = 0; j < 4096; ++j)
      places.emplace_back(glm::vec3(middle - 1.5 * kOblique.towards + place(1.2)), 1.0F);
    for (const char* entry : {"Hard", "Cone", "Soft", "Distance"}) {
      std::vector<std::vector<float>> answers;
      for (const int poison : {-1, 0, 65535}) {
        std::vector<std::uint16_t> other = texels;
        std::size_t at = 0;
        for (int z = 0; z < fields.voxels[2]; ++z)
          for (int y = 0; y < fields.voxels[1]; ++y)
            for (int x = 0; x < fields.voxels[0]; ++x, ++at) {
              const std::array<int, 3> voxel{x, y, z};
              bool own = true;
              for (std::size_t axis = 0; axis < 3; ++axis)
                own = own && voxel[axis] >= object.first[axis] &&
                      voxel[axis] < object.first[axis] + object.field.voxels[axis];
              if (!own && poison >= 0) other[at] = static_cast<std::uint16_t>(poison);
            }
        answers.push_back(
            run(entry, texture_of(device_, fields.voxels, other), one, scene_parameters(kOblique), places));
      }
      EXPECT_EQ(answers[0], answers[1]) << entry << " of object " << i << " beside 0";
      EXPECT_EQ(answers[0], answers[2]) << entry << " of object " << i << " beside 1";
    }
  }
}

// The march may take a step of that length anywhere.
TEST_F(FieldScene, OutsideOfTheBoxTheDistanceIsKnownFromBelow) {
  for (const scene::Scene& shape : {sphere(1.0, 64, 48), box({1.0F, 0.3F, 0.6F}), torus(1.0, 0.3, 64, 32)}) {
    const ObjectFields fields = bake_object_fields(shape, {1, {32, 0.05}});
    const gpu::Image image = texture_of(device_, fields.voxels, fields.texels());
    const reference::EmbreeScene rays(shape);
    const reference::ClosestSurface surface(rays, shape);
    const parameters::Bounds& bounds = fields.objects[0].field.box;
    std::vector<glm::vec4> places;
    while (places.size() < 20'000) {
      const glm::dvec3 at = place(places.size() % 2 == 0 ? 1.6 : 4.0);
      const bool inside =
          glm::all(glm::greaterThan(at, bounds.minimum)) && glm::all(glm::lessThan(at, bounds.maximum));
      if (!inside) places.emplace_back(glm::vec3(at), 1.0F);
    }
    const std::vector<float> seen =
        run("Distance", image, field_uniforms(fields), scene_parameters(kOblique), places);
    const double voxel = (bounds.maximum.x - bounds.minimum.x) / fields.objects[0].field.voxels[0];
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double exact = surface.distance(glm::dvec3(places[i]));
      // Distances between voxels are interpolated: those of a convex function are never too small, and too
      // large by less than this.
      ASSERT_LE(seen[i], exact + 0.13 * voxel) << glm::length(glm::dvec3(places[i]));
      ASSERT_GE(seen[i], exact / std::sqrt(2.0) - voxel) << glm::length(glm::dvec3(places[i]));
    }
  }
}

TEST_F(FieldScene, AHardShadowIsThatOfRaysButForAVoxelBesideItsEdge) {
  const scene::Scene scene = three_objects();
  const ObjectFields fields = bake_object_fields(scene, {16, {48, 0.1}});
  const gpu::Image image = texture_of(device_, fields.voxels, fields.texels());
  const reference::EmbreeScene rays(scene);
  std::vector<glm::vec4> places;
  for (int i = 0; i < 4096; ++i) {
    const double right = 2.5 * (2.0 * chance() - 1.0), up = 1.5 * (2.0 * chance() - 1.0);
    places.emplace_back(glm::vec3(-3.0 * kOblique.towards + right * kOblique.right() + up * kOblique.up()),
                        1.0F);
  }
  const std::vector<float> seen =
      run("Hard", image, field_uniforms(fields), scene_parameters(kOblique), places);
  const double voxel = 1.4 / 48.0;
  int decided = 0, dark = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    bool lit = true, blocked = true;  // answers of rays in a circle of a voxel and a half
    for (int k = 0; k < 24; ++k) {
      const double angle = k * kHalfTurn / 12.0;
      const glm::dvec3 beside =
          1.5 * voxel * (std::cos(angle) * kOblique.right() + std::sin(angle) * kOblique.up());
      const bool free = is_lit(rays, glm::dvec3(places[i]) + beside, kOblique.towards);
      lit = lit && free;
      blocked = blocked && !free;
    }
    if (!lit && !blocked) continue;
    ASSERT_EQ(seen[i], lit ? 1.0F : 0.0F) << i;
    ++decided;
    dark += blocked ? 1 : 0;
  }
  EXPECT_GT(decided, 3000);
  EXPECT_GT(dark, 300);
}

// The object is turned, moved and twice as large: the rows say so, and rays meet a mesh that is.
TEST_F(FieldScene, AnObjectMayBeTurnedMovedAndScaled) {
  const scene::Scene shape = torus(0.5, 0.2, 64, 32);
  const ObjectFields fields = bake_object_fields(shape, {1, {48, 0.1}});
  const gpu::Image image = texture_of(device_, fields.voxels, fields.texels());
  const double scale = 2.0;
  const glm::dvec3 offset(30.0, -4.0, 7.0);
  const glm::dvec3 x = glm::normalize(glm::dvec3(0.5, 0.7, -0.3));
  const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(0.0, 0.2, 1.0)));
  const glm::dvec3 z = glm::cross(x, y);
  scene::Scene world = shape;
  for (glm::vec3& position : world.mesh.positions) {
    const glm::dvec3 at(position);
    position = glm::vec3(offset + scale * (at.x * x + at.y * y + at.z * z));
  }
  std::vector<glm::vec4> uniforms = field_uniforms(fields);
  int row = 1;
  for (const glm::dvec3& axis : {x, y, z})
    uniforms[static_cast<std::size_t>(row++)] =
        glm::vec4(glm::vec3(axis / scale), static_cast<float>(-glm::dot(axis, offset) / scale));
  const reference::EmbreeScene rays(world);
  const Penumbra in = penumbra(rays, kOblique, offset, 4.0, 1.5, 512, is_partly_lit);
  EXPECT_LT(in.rmse(run("Soft", image, uniforms, scene_parameters(kOblique), in.places)), 0.03);
}

// The bounds are by light and shape, over places in the penumbra; Documentation~/other-shadows.md has more
// of them.
TEST_F(FieldScene, ASoftShadowIsNearThatOfRays) {
  struct Case {
    scene::Scene shape;
    double tan_half, cone, soft;
  };
  for (const Case& one :
       {Case{sphere(0.5, 64, 48), 0.05, 0.025, 0.015}, Case{sphere(0.5, 64, 48), 0.25, 0.12, 0.045},
        Case{torus(0.5, 0.15, 64, 32), 0.1, 0.13, 0.035}, Case{box({0.5F, 0.3F, 0.2F}), 0.1, 0.1, 0.04},
        Case{box({0.5F, 0.04F, 0.4F}), 0.1, 0.2, 0.07}}) {
    const ObjectFields fields = bake_object_fields(one.shape, {1, {64, 0.1}});
    const gpu::Image image = texture_of(device_, fields.voxels, fields.texels());
    const reference::EmbreeScene rays(one.shape);
    const SeenDisc light{kOblique.towards, one.tan_half};
    const Penumbra in =
        penumbra(rays, light, glm::dvec3(0.0), 2.0, 0.7 + 2.0 * one.tan_half, 256, is_partly_lit);
    const auto rmse = [&](const char* entry) {
      return in.rmse(run(entry, image, field_uniforms(fields), scene_parameters(light), in.places));
    };
    EXPECT_LT(rmse("Cone"), one.cone) << one.tan_half;
    EXPECT_LT(rmse("Soft"), one.soft) << one.tan_half;
  }
}

// From these places the way to the light's middle misses the box, and with it all that the texture knows.
TEST_F(FieldScene, APenumbraReachesBeyondTheBox) {
  for (const scene::Scene& shape : {sphere(0.5, 64, 48), box({0.5F, 0.3F, 0.2F})}) {
    const ObjectFields fields = bake_object_fields(shape, {1, {64, 0.0}});
    const gpu::Image image = texture_of(device_, fields.voxels, fields.texels());
    const reference::EmbreeScene rays(shape);
    const glm::dvec3 half = fields.objects[0].field.box.maximum;
    const scene::Scene around = box(glm::vec3(half));
    const reference::EmbreeScene box_rays(around);
    const SeenDisc light{kOblique.towards, 0.2};
    const Penumbra in =
        penumbra(rays, light, glm::dvec3(0.0), 2.0, 1.2, 256, [&](const glm::dvec3& at, double share) {
          return share <= 0.98 && is_lit(box_rays, at, light.towards);
        });
    EXPECT_LT(in.rmse(run("Soft", image, field_uniforms(fields), scene_parameters(light), in.places)), 0.06);
  }
}

// The objects leave free no more than the darkest of them alone does, and no less than all of them together
// cover.
TEST_F(FieldScene, SeveralObjectsLeaveFreeWhatEachOfThemDoes) {
  const ObjectFields fields = bake_object_fields(three_objects(), {16, {32, 0.1}});
  const gpu::Image image = texture_of(device_, fields.voxels, fields.texels());
  const std::vector<glm::vec4> uniforms = field_uniforms(fields);
  const FieldSceneParameters parameters = scene_parameters({kOblique.towards, 0.2});
  std::vector<glm::vec4> places;
  for (int i = 0; i < 2048; ++i) places.emplace_back(glm::vec3(-3.0 * kOblique.towards + place(2.0)), 1.0F);
  for (const char* entry : {"Hard", "Cone", "Soft"}) {
    std::vector<float> least(places.size(), 1.0F), covered(places.size(), 0.0F);
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<glm::vec4> one = uniforms;
      one[0].w = 1.0F;
      for (std::size_t row = 0; row < 6; ++row) one[1 + row] = uniforms[1 + 6 * i + row];
      const std::vector<float> alone = run(entry, image, one, parameters, places);
      for (std::size_t j = 0; j < places.size(); ++j) {
        least[j] = std::min(least[j], alone[j]);
        covered[j] += 1.0F - alone[j];
      }
    }
    const std::vector<float> all = run(entry, image, uniforms, parameters, places);
    int several = 0;
    for (std::size_t j = 0; j < places.size(); ++j) {
      ASSERT_LE(all[j], least[j] + 1e-5F) << entry;
      ASSERT_GE(all[j], 1.0F - covered[j] - 1e-5F) << entry;
      several += all[j] < least[j] - 1e-3F ? 1 : 0;
    }
    if (std::string(entry) != "Hard") {
      EXPECT_GT(several, 20) << entry;
    }
  }
}

TEST_F(FieldScene, NoObjectCastsNothing) {
  const ObjectFields fields = bake_object_fields(sphere(0.5, 16, 8), {1, {8, 0.1}});
  const gpu::Image image = texture_of(device_, fields.voxels, fields.texels());
  std::vector<glm::vec4> uniforms = field_uniforms(fields);
  const std::vector<glm::vec4> below{{glm::vec3(-2.0 * kOblique.towards), 1.0F}};
  for (const char* entry : {"Hard", "Cone", "Soft"}) {
    EXPECT_THAT(run(entry, image, uniforms, scene_parameters(kOblique), below), testing::Each(0.0F)) << entry;
    std::vector<glm::vec4> none = uniforms;
    none[0].w = 0.0F;
    EXPECT_THAT(run(entry, image, none, scene_parameters(kOblique), below), testing::Each(1.0F)) << entry;
    none = uniforms;
    none[2].y = std::nanf("");
    EXPECT_THAT(run(entry, image, none, scene_parameters(kOblique), below), testing::Each(1.0F)) << entry;
  }
}

TEST_F(FieldScene, StaysInRangeWhateverItIsGiven) {
  const ObjectFields fields = bake_object_fields(three_objects(), {16, {8, 0.1}});
  const gpu::Image image = texture_of(device_, fields.voxels, fields.texels());
  const std::vector<glm::vec4> uniforms = field_uniforms(fields);
  const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
  const std::vector<float> odd{nan,    infinity, -infinity, 0.0F, -0.0F, 1e30F,
                               -1e30F, 1e-30F,   1e-42F,    1.0F, -1.0F};
  const auto one = [&] { return odd[bits_() % odd.size()]; };
  std::vector<glm::vec4> places;
  for (int i = 0; i < 64; ++i) places.emplace_back(glm::vec3(place(3.0)), 1.0F);
  for (int i = 0; i < 64; ++i) places.emplace_back(one(), one(), one(), 1.0F);
  for (int round = 0; round < 60; ++round) {
    FieldSceneParameters all = scene_parameters(kOblique);
    std::vector<glm::vec4> changed = uniforms;
    if (round % 2 == 1)
      for (float& value : all.light) value = one();
    if (round % 3 == 1)
      for (float& value : all.march) value = one();
    if (round % 4 == 1)
      for (float& value : all.normal) value = one();
    if (round % 5 != 0) {
      for (int i = 0; i < 8; ++i) changed[bits_() % 19][static_cast<int>(bits_() % 4)] = one();
    }
    if (round % 7 == 1) changed[0] = glm::vec4(one(), one(), one(), one());
    for (const char* entry : {"Hard", "Cone", "Soft"})
      for (const float seen : run(entry, image, changed, all, places))
        ASSERT_TRUE(seen >= 0.0F && seen <= 1.0F) << entry << " " << round << ": " << seen;
  }
}

}  // namespace
}  // namespace penumbra::bake
