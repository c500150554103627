// The objects of a scene, and their fields in one texture.
#include "bake/scene_objects.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "bake/baked_files.h"
#include "bake/field_objects.h"
#include "bake/made_shapes.h"
#include "bake/ray_traced_share.h"
#include "input/input_error_matcher.h"
#include "reference/scratch_folder.h"
#include "scene/image_file.h"

namespace penumbra::bake {
namespace {

using testing::HasSubstr;

scene::Scene ground(double half) {
  const auto at = static_cast<float>(half);
  return mesh_of({{-at, 0.0F, -at}, {at, 0.0F, -at}, {-at, 0.0F, at}, {at, 0.0F, at}}, {0, 2, 1, 1, 2, 3});
}

std::size_t triangles_of(const SceneObjects& found) {
  std::set<std::uint32_t> all;
  std::size_t count = 0;
  for (const SceneObject& object : found.objects) {
    all.insert(object.triangles.begin(), object.triangles.end());
    count += object.triangles.size();
  }
  EXPECT_EQ(all.size(), count) << "a triangle is of two objects";
  return count;
}

TEST(SceneObjects, ArePartsThatHangTogetherWithoutTheGround) {
  const SceneObjects found = objects_of(joined({ground(10.0), moved(box({1.0F, 1.0F, 1.0F}), {3.0, 1.0, 0.0}),
                                                moved(torus(1.0, 0.3, 24, 12), {-3.0, 1.0, 0.0})}),
                                        16);
  ASSERT_EQ(found.objects.size(), 2U);
  EXPECT_EQ(found.parts, 2U);
  EXPECT_EQ(found.ground_triangles, 2U);
  EXPECT_EQ(found.flat_triangles, 0U);
  EXPECT_EQ(found.objects[0].triangles.size(), 12U);
  EXPECT_EQ(found.objects[1].triangles.size(), 2U * 24U * 12U);
  EXPECT_EQ(found.objects[0].box.minimum, glm::dvec3(2.0, 0.0, -1.0));
  EXPECT_EQ(triangles_of(found), 12U + 2U * 24U * 12U);
}

// Every triangle has vertices of its own, and positions differ by rounding.
TEST(SceneObjects, VerticesAtOnePositionAreOne) {
  const scene::Scene whole = moved(sphere(1.0, 24, 16), {20.0, 3.0, 0.0});
  scene::Scene loose = mesh_of({}, {});
  std::mt19937 bits(1);
  for (const std::uint32_t index : whole.mesh.indices) {
    glm::vec3 position = whole.mesh.positions[index];
    for (int axis = 0; axis < 3; ++axis)
      if (bits() % 2 == 0) position[axis] = std::nextafter(position[axis], 100.0F);
    loose.mesh.indices.push_back(static_cast<std::uint32_t>(loose.mesh.positions.size()));
    loose.mesh.positions.push_back(position);
    loose.mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
  }
  const SceneObjects found = objects_of(loose, 16);
  ASSERT_EQ(found.objects.size(), 1U);
  EXPECT_EQ(found.parts, 1U);
  EXPECT_EQ(bake_distance_field(scene_of(loose, found.objects[0]), {8, 0.2}).open_edges, 0U);
}

// A roof is level, too; so are small things that lie on the ground.
TEST(SceneObjects, OnlyWideLevelSheetsAreGround) {
  const scene::Scene scene =
      joined({ground(10.0), moved(ground(2.0), {0.0, 3.0, 0.0}), moved(ground(0.5), {4.0, 0.01, 0.0}),
              moved(box({5.0F, 0.002F, 5.0F}), {0.0, 0.1, 0.0})});
  const SceneObjects found = objects_of(scene, 16);
  EXPECT_EQ(found.objects.size(), 2U);
  EXPECT_EQ(found.ground_triangles, 2U + 12U);
}

TEST(SceneObjects, ManyPartsShareObjectsAndNoneIsLeftOut) {
  std::vector<scene::Scene> all{ground(50.0)};
  std::mt19937 bits(4);
  const auto chance = [&] { return static_cast<double>(bits()) * 0x1p-32; };
  for (int i = 0; i < 3000; ++i)
    all.push_back(moved(box({0.1F, 0.1F, 0.1F}), {80.0 * chance() - 40.0, 0.2, 80.0 * chance() - 40.0}));
  const scene::Scene scene = joined(all);
  for (const int most : {1, 5, 16}) {
    const SceneObjects found = objects_of(scene, most);
    EXPECT_EQ(found.objects.size(), static_cast<std::size_t>(most));
    EXPECT_EQ(found.parts, 3000U);
    EXPECT_EQ(triangles_of(found), 36'000U);
    for (std::size_t i = 1; i < found.objects.size(); ++i)
      EXPECT_GE(found.objects[i - 1].triangles.size() * 20, found.objects[i].triangles.size());
  }
}

// Two heaps far apart are the two objects.
TEST(SceneObjects, PartsBesideOneAnotherShareAnObject) {
  std::vector<scene::Scene> all;
  for (int i = 0; i < 10; ++i)
    all.push_back(moved(box({0.1F, 0.1F, 0.1F}), {i < 4 ? 0.3 * i : 100.0 + 0.3 * i, 0.0, 0.0}));
  const SceneObjects found = objects_of(joined(all), 2);
  ASSERT_EQ(found.objects.size(), 2U);
  EXPECT_EQ(found.objects[0].parts, 6U);
  EXPECT_EQ(found.objects[1].parts, 4U);
}

TEST(SceneObjects, SaysWhatHasNone) {
  const auto refuse = [](const scene::Scene& scene, int most, const auto& says) {
    expect_input_error([&] { objects_of(scene, most); }, says);
  };
  const scene::Scene whole = box({1.0F, 1.0F, 1.0F});
  refuse(whole, 0, HasSubstr("not 0"));
  refuse(whole, 17, HasSubstr("not 17"));
  refuse(mesh_of({}, {}), 16, HasSubstr("no triangles"));
  refuse(ground(3.0), 16, HasSubstr("level ground alone"));
  refuse(mesh_of(std::vector<glm::vec3>(3, glm::vec3(1.0F)), {0, 1, 2}), 16, HasSubstr("has an area"));
  for (const float broken : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
    scene::Scene scene = whole;
    scene.mesh.positions[3].y = broken;
    refuse(scene, 16, HasSubstr("vertex 3"));
  }
  scene::Scene outside = whole;
  outside.mesh.indices[5] = 8;
  refuse(outside, 16, testing::AllOf(HasSubstr("index 8"), HasSubstr("8 vertices")));
}

TEST(SceneObjects, TrianglesWithoutAreaJoinNothing) {
  scene::Scene scene = joined({box({1.0F, 1.0F, 1.0F}), moved(box({1.0F, 1.0F, 1.0F}), {5.0, 0.0, 0.0})});
  scene.mesh.indices.insert(scene.mesh.indices.end(), {0, 0, 1, 2, 2, 2});
  const SceneObjects found = objects_of(scene, 16);
  EXPECT_EQ(found.objects.size(), 2U);
  EXPECT_EQ(found.flat_triangles, 2U);
}

TEST(PackedBoxes, DoNotOverlap) {
  std::mt19937 bits(2);
  for (int round = 0; round < 60; ++round) {
    std::vector<std::array<int, 3>> sizes;
    for (std::size_t i = 0; i <= bits() % 16; ++i)
      sizes.push_back({static_cast<int>(1 + bits() % 64), static_cast<int>(1 + bits() % 64),
                       static_cast<int>(1 + bits() % 64)});
    const PackedBoxes packed = packed_boxes(sizes, 512);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_GE(packed.first[i][axis], 0);
        EXPECT_LE(packed.first[i][axis] + sizes[i][axis], packed.size[axis]);
      }
      for (std::size_t j = 0; j < i; ++j) {
        bool apart = false;
        for (std::size_t axis = 0; axis < 3; ++axis)
          apart = apart || packed.first[i][axis] + sizes[i][axis] <= packed.first[j][axis] ||
                  packed.first[j][axis] + sizes[j][axis] <= packed.first[i][axis];
        EXPECT_TRUE(apart) << i << " and " << j;
      }
    }
  }
  const std::vector<std::array<int, 3>> equal(16, {64, 64, 64});
  EXPECT_EQ(packed_boxes(equal, 2048).size, (std::array{256, 256, 64}));
  expect_input_error([&] { packed_boxes(equal, 255); }, HasSubstr("16 objects do not fit"));
}

scene::Scene two_objects() {
  return joined({ground(10.0), moved(box({1.0F, 1.0F, 1.0F}), {3.0, 1.0, 0.0}),
                 moved(torus(1.0, 0.3, 24, 12), {-3.0, 1.0, 0.0})});
}

TEST(ObjectFields, AreThoseOfTheObjectsAlone) {
  const ObjectFields fields = bake_object_fields(two_objects(), {16, {16, 0.1}});
  ASSERT_EQ(fields.objects.size(), 2U);
  EXPECT_EQ(fields.objects[0].field.metres,
            bake_distance_field(moved(box({1.0F, 1.0F, 1.0F}), {3.0, 1.0, 0.0}), {16, 0.1}).metres);
  const std::vector<std::uint16_t> texels = fields.texels();
  for (const ObjectField& object : fields.objects) {
    EXPECT_EQ(object.field.open_edges, 0U);
    EXPECT_EQ(object.parts, 1U);
    for (int z = 0; z < object.field.voxels[2]; ++z) {
      const std::size_t place = (static_cast<std::size_t>(object.first[2] + z) * fields.voxels[1] +
                                 static_cast<std::size_t>(object.first[1] + 2)) *
                                    fields.voxels[0] +
                                static_cast<std::size_t>(object.first[0] + 3);
      EXPECT_NEAR((texels[place] / 32767.5 - 1.0) * object.largest_metres, object.field.at(3, 2, z),
                  object.largest_metres / 65535.0);
    }
  }
}

// With a margin of less than a voxel, the texture would know nothing where the surface is.
TEST(ObjectFields, HaveAVoxelAroundTheObject) {
  const ObjectFields fields = bake_object_fields(two_objects(), {16, {8, 0.0}});
  const DistanceField& field = fields.objects[0].field;
  const double voxel = (field.box.maximum.x - field.box.minimum.x) / field.voxels[0];
  EXPECT_LE(field.box.minimum.x, 2.0 - voxel * (1.0 - 1e-9));
}

TEST(ObjectFields, WhatIsThinnerThanTwoVoxelsIsTold) {
  // 32 voxels over 2.4 m: two are 0.15 m.
  const auto thin = [](const scene::Scene& scene) {
    return bake_object_fields(scene, {16, {32, 0.1}}).objects[0].thin_share;
  };
  EXPECT_EQ(thin(box({1.0F, 1.0F, 1.0F})), 0.0);
  EXPECT_EQ(thin(sphere(1.0, 32, 16)), 0.0);
  EXPECT_EQ(thin(box({1.0F, 0.08F, 0.08F})), 0.0);
  EXPECT_NEAR(thin(box({1.0F, 0.07F, 1.0F})), 8.0 / (8.0 + 8.0 * 0.14), 1e-6);
  EXPECT_EQ(thin(mesh_of({{0.0F, 0.0F, 0.0F}, {1.0F, 1.0F, 0.0F}, {0.0F, 0.0F, 1.0F}}, {0, 2, 1})), 1.0);
}

TEST(ObjectFields, AnInterruptedBakeGoesOn) {
  const reference::ScratchFolder folder;
  const platform::CacheStore store(folder.path());
  BakeOptions options;
  options.store = &store;
  options.jobs = 1;
  int blocks = 0;
  options.cancelled = [&] { return ++blocks > 20; };
  EXPECT_THROW(bake_object_fields(two_objects(), {16, {16, 0.1}}, options), platform::Interrupted);
  std::vector<double> told;
  options.cancelled = [] { return false; };
  options.progress = [&](double done, double total) {
    EXPECT_EQ(total, 16.0 + 16.0);
    told.push_back(done);
  };
  const ObjectFields fields = bake_object_fields(two_objects(), {16, {16, 0.1}}, options);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.front(), 16.0) << "the first object is kept";
  EXPECT_EQ(told.back(), 32.0);
  EXPECT_EQ(fields.texels(), bake_object_fields(two_objects(), {16, {16, 0.1}}).texels());
}

TEST(ObjectFields, RefuseTooFewAndTooManyVoxels) {
  const auto refuse = [](const ObjectFieldsOptions& options, const auto& says) {
    expect_input_error([&] { bake_object_fields(two_objects(), options); }, says);
  };
  refuse({16, {7, 0.1}}, HasSubstr("not 7"));
  refuse({16, {513, 0.1}}, HasSubstr("not 513"));
  refuse({0, {16, 0.1}}, HasSubstr("not 0"));
  refuse({16, {16, -1.0}}, HasSubstr("margin of -1"));
}

TEST(ObjectFields, AreOneFile) {
  const ObjectFields fields = bake_object_fields(two_objects(), {16, {16, 0.1}});
  const BakedFiles files = baked_files(fields, "objects");
  const nlohmann::json json = nlohmann::json::parse(files.json);
  EXPECT_EQ(json["kind"], "distance-field-objects");
  EXPECT_EQ(json["ground_triangles"], 2);
  ASSERT_EQ(json["objects"].size(), 2U);
  const nlohmann::json& first = json["objects"][0];
  EXPECT_EQ(first["first_voxel"], nlohmann::json(fields.objects[0].first));
  EXPECT_EQ(first["triangles"], 12);
  EXPECT_EQ(first["too_thin"], 0.0);
  EXPECT_DOUBLE_EQ(first["distances_metres"][1], fields.objects[0].largest_metres);
  const scene::HeightImage sheet =
      scene::decode_height_image(files.pictures.at("objects.png"), "objects.png", {});
  EXPECT_EQ(sheet.width, json["columns"].get<int>() * fields.voxels[0]);
  EXPECT_EQ(sheet.height, json["rows"].get<int>() * fields.voxels[1]);
}

}  // namespace
}  // namespace penumbra::bake
