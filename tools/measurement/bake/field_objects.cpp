#include "bake/field_objects.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>

#include "bake/baked_files.h"
#include "input/input_error.h"
#include "reference/closest_surface.h"
#include "reference/embree_scene.h"

namespace penumbra::bake {
namespace {

constexpr std::uint16_t kFarOutside = 65535;

std::array<glm::dvec3, 3> corners_of(const scene::Mesh& mesh, std::size_t triangle) {
  std::array<glm::dvec3, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = glm::dvec3(mesh.positions[mesh.indices[3 * triangle + i]]);
  return corners;
}

// Returns whether a ray from a place meets the mesh within so many metres.
bool meets(const reference::EmbreeScene& rays, const glm::dvec3& from, const glm::dvec3& direction,
           double metres) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray{};
  ray.org_x = static_cast<float>(from.x);
  ray.org_y = static_cast<float>(from.y);
  ray.org_z = static_cast<float>(from.z);
  ray.dir_x = static_cast<float>(direction.x);
  ray.dir_y = static_cast<float>(direction.y);
  ray.dir_z = static_cast<float>(direction.z);
  ray.tfar = static_cast<float>(metres);
  ray.mask = ~0U;
  rtcOccluded1(rays.handle(), &context, &ray);
  return ray.tfar < 0.0F;
}

// Returns the share of the surface behind which the mesh ends in less than so many metres. The surface of an
// open mesh has nothing behind it.
double thin_share(const scene::Scene& scene, double metres) {
  const reference::EmbreeScene rays(scene);
  const reference::ClosestSurface surface(rays, scene);
  const double above = 1e-3 * metres;
  double thin = 0.0, all = 0.0;
  for (std::size_t triangle = 0; triangle < scene.mesh.triangle_count(); ++triangle) {
    const std::array<glm::dvec3, 3> corners = corners_of(scene.mesh, triangle);
    const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double area = glm::length(across);
    if (!(area > 0.0)) continue;
    all += area;
    const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    for (const glm::dvec3& corner : corners) {
      const glm::dvec3 place = 0.5 * (middle + corner);
      glm::dvec3 inwards = -across / area;
      if (surface.distance(place + above * inwards) > 0.0) inwards = -inwards;
      const bool solid = surface.open_edges() == 0;
      if (!solid || meets(rays, place + above * inwards, inwards, metres - above)) thin += area / 3.0;
    }
  }
  return all > 0.0 ? thin / all : 0.0;
}

double largest_of(const DistanceField& field) {
  double largest = 0.0;
  for (const float metres : field.metres) largest = std::max(largest, std::abs(static_cast<double>(metres)));
  return largest > 0.0 ? largest : 1.0;
}

// Arranges the boxes in rows along x of at most this width, the deepest boxes first. Returns nothing where
// they are too large.
std::optional<PackedBoxes> in_rows(const std::vector<std::array<int, 3>>& sizes,
                                   const std::vector<std::size_t>& order, int width, int largest) {
  PackedBoxes packed;
  packed.first.resize(sizes.size());
  int x = 0, y = 0, row = 0;
  for (const std::size_t i : order) {
    if (x > 0 && x + sizes[i][0] > width) {
      x = 0;
      y += row;
      row = 0;
    }
    packed.first[i] = {x, y, 0};
    x += sizes[i][0];
    row = std::max(row, sizes[i][1]);
    packed.size = {std::max(packed.size[0], x), y + row, std::max(packed.size[2], sizes[i][2])};
  }
  if (std::max({packed.size[0], packed.size[1], packed.size[2]}) > largest) return std::nullopt;
  return packed;
}

}  // namespace

PackedBoxes packed_boxes(const std::vector<std::array<int, 3>>& sizes, int largest) {
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t one, std::size_t other) { return sizes[one][1] > sizes[other][1]; });
  std::optional<PackedBoxes> best;
  const auto cost = [](const PackedBoxes& packed) {
    return std::pair(std::size_t(packed.size[0]) * std::size_t(packed.size[1]),
                     std::max(packed.size[0], packed.size[1]));
  };
  for (int width = 1; width <= largest; ++width) {
    const std::optional<PackedBoxes> packed = in_rows(sizes, order, width, largest);
    if (packed && (!best || cost(*packed) < cost(*best))) best = packed;
  }
  if (!best) {
    throw InputError("",
                     fmt::format("the fields of {} objects do not fit into a texture of {} texels per side",
                                 sizes.size(), largest),
                     "bake fewer voxels or fewer objects");
  }
  return *best;
}

std::vector<std::uint16_t> ObjectFields::texels() const {
  const std::size_t width = static_cast<std::size_t>(voxels[0]), height = static_cast<std::size_t>(voxels[1]);
  std::vector<std::uint16_t> all(width * height * static_cast<std::size_t>(voxels[2]), kFarOutside);
  for (const ObjectField& object : objects) {
    for (int z = 0; z < object.field.voxels[2]; ++z)
      for (int y = 0; y < object.field.voxels[1]; ++y)
        for (int x = 0; x < object.field.voxels[0]; ++x) {
          const std::size_t place = (static_cast<std::size_t>(object.first[2] + z) * height +
                                     static_cast<std::size_t>(object.first[1] + y)) *
                                        width +
                                    static_cast<std::size_t>(object.first[0] + x);
          all[place] =
              as_16_bits(0.5 + 0.5 * static_cast<double>(object.field.at(x, y, z)) / object.largest_metres);
        }
  }
  return all;
}

glm::vec4 ObjectFields::atlas() const {
  return {glm::vec3(voxels[0], voxels[1], voxels[2]), static_cast<float>(objects.size())};
}

std::vector<glm::vec4> ObjectFields::rows(const glm::dvec3& origin) const {
  std::vector<glm::vec4> all;
  for (const ObjectField& object : objects) {
    const glm::dvec3 size = object.field.box.maximum - object.field.box.minimum;
    all.emplace_back(1.0F, 0.0F, 0.0F, static_cast<float>(-origin.x));
    all.emplace_back(0.0F, 1.0F, 0.0F, static_cast<float>(-origin.y));
    all.emplace_back(0.0F, 0.0F, 1.0F, static_cast<float>(-origin.z));
    all.emplace_back(glm::vec3(object.field.box.minimum), static_cast<float>(object.largest_metres));
    all.emplace_back(glm::vec3(size), static_cast<float>(size.x / object.field.voxels[0]));
    all.emplace_back(glm::vec3(object.first[0], object.first[1], object.first[2]), 0.0F);
  }
  return all;
}

ObjectFields bake_object_fields(const scene::Scene& scene, const ObjectFieldsOptions& options,
                                const BakeOptions& run) {
  if (options.each.voxels < least_voxels_of_objects) {
    throw InputError("", fmt::format("the fields of objects have {} voxels per side at least, not {}",
                                     least_voxels_of_objects, options.each.voxels));
  }
  const SceneObjects found = objects_of(scene, options.objects);
  DistanceFieldOptions each = options.each;
  if (each.margin >= 0.0) each.margin = std::max(each.margin, 1.0 / (each.voxels - 2));
  std::vector<scene::Scene> scenes;
  std::vector<std::array<int, 3>> sizes;
  int slices = 0, done_before = 0;
  for (const SceneObject& object : found.objects) {
    scenes.push_back(scene_of(scene, object));
    sizes.push_back(placed_field(scenes.back(), each).voxels);
    slices += sizes.back()[2];
  }
  const PackedBoxes packed = packed_boxes(sizes, largest_field_texture);
  ObjectFields fields;
  fields.voxels = packed.size;
  fields.ground_triangles = found.ground_triangles;
  fields.flat_triangles = found.flat_triangles;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    BakeOptions own = run;
    if (run.progress) own.progress = [&](double done, double) { run.progress(done_before + done, slices); };
    ObjectField object;
    object.field = bake_distance_field(scenes[i], each, own);
    done_before += sizes[i][2];
    object.first = packed.first[i];
    object.largest_metres = largest_of(object.field);
    object.triangles = found.objects[i].triangles.size();
    object.parts = found.objects[i].parts;
    const double voxel = (object.field.box.maximum.x - object.field.box.minimum.x) / object.field.voxels[0];
    object.thin_share = thin_share(scenes[i], 2.0 * voxel);
    fields.objects.push_back(std::move(object));
  }
  return fields;
}

}  // namespace penumbra::bake
