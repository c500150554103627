#include "parameters/cascades.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "input/input_error.h"
#include "parameters/half_angle.h"
#include "parameters/light_axes.h"
#include "parameters/settings_check.h"
#include "parameters/split_tiles.h"

namespace penumbra::parameters {

namespace {

// The smallest sphere around the part of the view frustum between two distances. Its centre lies on the view
// axis; c is where the near and the far corners are equally far, unless that is beyond the far plane, where
// the far corners alone decide:
//        ______
//     __/      |      k = tan(half the diagonal angle of view)
//   _/    c    |      |near corner - c|^2 = (c - n)^2 + k^2 n^2
//    \__  .    |      |far corner  - c|^2 = (f - c)^2 + k^2 f^2
//       \______|
// The radius depends on the lens and the split alone, so turning the camera never changes a texel's size.
SplitSphere sphere_around(const Camera& camera, double near_distance, double far_distance) {
  const double tan_half = parameters::tan_half(camera.fov_y_degrees);
  const double k2 = tan_half * tan_half * (1.0 + camera.aspect * camera.aspect);
  const double middle = 0.5 * (near_distance + far_distance) * (1.0 + k2);
  const double c = std::min(middle, far_distance);
  const double radius = std::sqrt((far_distance - c) * (far_distance - c) + k2 * far_distance * far_distance);
  return {camera.position + glm::normalize(camera.forward) * c, radius};
}

struct LightBounds {
  glm::dvec3 minimum;
  glm::dvec3 maximum;
};

LightBounds into_light(const LightAxes& axes, const Bounds& world) {
  LightBounds result{glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 point((corner & 1) != 0 ? world.maximum.x : world.minimum.x,
                           (corner & 2) != 0 ? world.maximum.y : world.minimum.y,
                           (corner & 4) != 0 ? world.maximum.z : world.minimum.z);
    result.minimum = glm::min(result.minimum, axes.into(point));
    result.maximum = glm::max(result.maximum, axes.into(point));
  }
  return result;
}

// Shrinks the square to the casters' shadow: everything beside all casters, seen along the light, is lit.
void tighten_to(const LightBounds& casters, TileBox& box) {
  const glm::dvec2 low = glm::max(glm::dvec2(casters.minimum), box.centre - box.half_extent);
  const glm::dvec2 high = glm::min(glm::dvec2(casters.maximum), box.centre + box.half_extent);
  const glm::dvec2 size = high - low;
  const double side = std::max(size.x, size.y);
  if (size.x < 0.0 || size.y < 0.0 || side <= 0.0) return;  // no caster meets this cascade
  box.centre = 0.5 * (low + high);
  box.half_extent = 0.5 * side;
}

void place_depth(const ShadowSettings& settings, const LightBounds* casters, double centre, double radius,
                 TileBox& box) {
  box.far_depth = centre + radius;
  box.near_depth = centre - radius - settings.near_plane_offset_metres;
  if (settings.depth_range_metres) {
    // A range longer than the sphere reaches toward the light, where casters are; a shorter one keeps the
    // sphere's middle.
    const double range = *settings.depth_range_metres;
    box.far_depth = centre + std::min(radius, 0.5 * range);
    box.near_depth = box.far_depth - range;
  } else if (casters != nullptr && casters->minimum.z < box.far_depth) {
    const double first =
        settings.fit_to_bounds ? casters->minimum.z : std::min(casters->minimum.z, centre - radius);
    box.near_depth = first - settings.near_plane_offset_metres;
  }
}

// Moves the square to whole texels of light space, so that a moving camera moves the map by whole texels and
// edges stand still. A margin on each side keeps the square's content inside after rounding: h = r + m texel
// and texel = 2 h / n give h = r n / (n - 2 m).
void snap(int tile_resolution, TileBox& box) {
  box.half_extent *= tile_resolution / (tile_resolution - 2.0 * box.margin_texels);
  const double texel = 2.0 * box.half_extent / tile_resolution;
  box.centre = glm::floor(box.centre / texel + (0.5 + kSnapTieTexels)) * texel;
}

TileBox fit_tile(const LightAxes& axes, const ShadowSettings& settings, const SplitSphere& sphere) {
  const glm::dvec3 centre = axes.into(sphere.centre);
  TileBox box{glm::dvec2(centre), sphere.radius, 0.0, 0.0};
  std::optional<LightBounds> casters;
  if (settings.caster_bounds) casters = into_light(axes, *settings.caster_bounds);
  if (casters && settings.fit_to_bounds) tighten_to(*casters, box);
  place_depth(settings, casters ? &*casters : nullptr, centre.z, sphere.radius, box);
  return box;
}

glm::dmat4 from_rows(const glm::dvec4& x, const glm::dvec4& y, const glm::dvec4& z) {
  glm::dmat4 matrix(1.0);
  for (int column = 0; column < 4; ++column) {
    matrix[column] = {x[column], y[column], z[column], column == 3 ? 1.0 : 0.0};
  }
  return matrix;
}

// The eye stands in the middle of the near plane, so the projection holds nothing but the box's size.
void place_matrices(const LightAxes& axes, const TileBox& box, const CascadeSet& set, Cascade& cascade) {
  const glm::dvec3 eye(box.centre, box.near_depth);
  const double range = box.far_depth - box.near_depth;
  const double per_half = 1.0 / box.half_extent;
  cascade.view = from_rows(glm::dvec4(axes.right, -eye.x), glm::dvec4(axes.up, -eye.y),
                           glm::dvec4(-axes.forward, eye.z));
  cascade.projection = set.clip_depth == ClipDepth::zero_to_one
                           ? from_rows({per_half, 0, 0, 0}, {0, per_half, 0, 0}, {0, 0, -1 / range, 0})
                           : from_rows({per_half, 0, 0, 0}, {0, per_half, 0, 0}, {0, 0, -2 / range, -1});

  // The formulas are tile = 0.5 + (x - eye) / (2 h) and atlas = offset + scale * tile; depth grows away from
  // the light or, when reversed, toward it. They are written out so that no product of matrices rounds in
  // between.
  const glm::dvec2 scale(cascade.offset_scale.z, cascade.offset_scale.w);
  const glm::dvec2 offset(cascade.offset_scale.x, cascade.offset_scale.y);
  const glm::dvec2 uv = scale * (0.5 * per_half);
  const glm::dvec2 constant = offset + 0.5 * scale - uv * glm::dvec2(eye);
  const double sign = set.reversed_z ? -1.0 : 1.0;
  const glm::dvec4 depth(axes.forward * (sign / range),
                         set.reversed_z ? box.far_depth / range : -box.near_depth / range);
  cascade.world_to_shadow =
      from_rows(glm::dvec4(axes.right * uv.x, constant.x), glm::dvec4(axes.up * uv.y, constant.y), depth);
}

std::string describe_depth_range(const ShadowSettings& settings, double largest_diameter) {
  if (settings.depth_range_metres) {
    std::string text = fmt::format("depth_range_metres ({} m)", *settings.depth_range_metres);
    if (*settings.depth_range_metres < largest_diameter) {
      text += fmt::format(
          ", shorter than the largest split sphere ({:.6g} m): receivers outside the range are unshadowed",
          largest_diameter);
    }
    return text;
  }
  if (settings.caster_bounds) return "caster_bounds: from the nearest caster to the split sphere's far side";
  return "split sphere's diameter plus the near-plane offset (no depth_range_metres or caster_bounds given)";
}

}  // namespace

std::array<double, 3> effective_splits(const ShadowSettings& settings) {
  if (settings.splits != std::array<double, 3>{}) return settings.splits;
  if (settings.cascades == 2) return {0.25, 0.0, 0.0};
  if (settings.cascades == 3) return {0.1, 0.3, 0.0};
  return {0.067, 0.2, 0.467};
}

double kernel_radius_texels(SoftQuality quality) {
  switch (quality) {
    case SoftQuality::off:
      return 1.0;
    case SoftQuality::low:
      return 1.5;
    case SoftQuality::medium:
      return 2.5;
    case SoftQuality::high:
      return 3.5;
  }
  return 2.5;
}

glm::dvec2 bias_of_projection(const glm::dmat4& projection, int tile_resolution,
                              const ShadowSettings& settings) {
  const double texel = 2.0 / projection[0][0] / tile_resolution;
  const double kernel = kernel_radius_texels(settings.soft_quality) * texel;
  return {0.0 - settings.depth_bias * kernel, 0.0 - settings.normal_bias * kernel};
}

AtlasLayout atlas_layout(int resolution, int cascades) {
  // URP looks for tiles in the square map first and halves the height of two cascades afterwards.
  AtlasLayout layout{resolution, cascades == 2 ? resolution / 2 : resolution, resolution};
  while (resolution / layout.tile_resolution * resolution / layout.tile_resolution < cascades) {
    layout.tile_resolution /= 2;
  }
  return layout;
}

glm::dvec4 tile_rectangle(const AtlasLayout& layout, int cascade) {
  const double width = static_cast<double>(layout.tile_resolution) / layout.width;
  const double height = static_cast<double>(layout.tile_resolution) / layout.height;
  return {(cascade % 2) * width, (cascade / 2) * height, width, height};  // NOLINT(bugprone-integer-division)
}

void derive_scales(const CascadeSet& set, const ShadowSettings& settings, Cascade& cascade) {
  const glm::dmat4& m = cascade.world_to_shadow;
  const double tan_half = parameters::tan_half(set.angular_diameter_degrees);
  const double row0 = glm::length(glm::dvec3(m[0][0], m[1][0], m[2][0]));
  const double row2 = glm::length(glm::dvec3(m[0][2], m[1][2], m[2][2]));
  cascade.uv_per_metre = row0 / cascade.offset_scale.z;
  cascade.depth_per_metre = row2;
  cascade.depth_to_radial = tan_half * cascade.uv_per_metre / row2;
  cascade.radial_to_depth.reset();
  if (tan_half > 0.0) cascade.radial_to_depth = row2 / (tan_half * cascade.uv_per_metre);
  cascade.depth_to_radial_hdrp = 2.0 * cascade.depth_to_radial;
  cascade.texel_size_metres = 1.0 / (cascade.uv_per_metre * set.tile_resolution);
  cascade.max_penumbra_texels = cascade.depth_to_radial * set.tile_resolution;
  const double kernel = kernel_radius_texels(settings.soft_quality) * cascade.texel_size_metres;
  cascade.depth_bias_metres = 0.0 - settings.depth_bias * kernel;
  cascade.normal_bias_metres = 0.0 - settings.normal_bias * kernel;
}

std::string why_not_emittable(const Cascade& cascade) {
  const auto holds = [](double value) { return std::abs(value) <= std::numeric_limits<float>::max(); };
  for (const glm::dmat4* matrix : {&cascade.view, &cascade.projection, &cascade.world_to_shadow}) {
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) {
        if (!holds((*matrix)[column][row])) return "its matrices overflow 32-bit floats";
      }
    }
  }
  for (const double scale :
       {cascade.uv_per_metre, cascade.depth_per_metre, cascade.depth_to_radial_hdrp,
        cascade.radial_to_depth.value_or(0.0), cascade.texel_size_metres, cascade.max_penumbra_texels,
        cascade.depth_bias_metres, cascade.normal_bias_metres, cascade.split_sphere.w}) {
    if (!holds(scale)) return "its scales overflow 32-bit floats";
  }
  return {};
}

std::vector<SplitTile> split_tiles(const Camera& camera, const Light& light, const ShadowSettings& settings) {
  if (const auto problem = find_problem(camera, light, settings)) {
    throw InputError("", problem->key.substr(1) + " " + problem->problem, problem->remedy);
  }
  const LightAxes axes = axes_of(light.direction);
  const auto splits = effective_splits(settings);
  const double distance = std::min(settings.distance_metres, camera.far_plane);
  std::vector<SplitTile> tiles;
  double begin = camera.near_plane;
  for (int i = 0; i < settings.cascades; ++i) {
    const bool last = i + 1 == settings.cascades;
    const double end = last ? distance : splits[static_cast<std::size_t>(i)] * distance;
    const SplitSphere sphere = sphere_around(camera, begin, end);
    tiles.push_back({sphere, fit_tile(axes, settings, sphere), axes});
    begin = end;
  }
  return tiles;
}

CascadeSet placed(const std::vector<SplitTile>& tiles, const Light& light, const ShadowSettings& settings) {
  const AtlasLayout layout = atlas_layout(settings.resolution, settings.cascades);
  CascadeSet set{.reversed_z = settings.reversed_z,
                 .clip_depth = settings.clip_depth,
                 .angular_diameter_degrees = light.angular_diameter_degrees,
                 .light_direction = axes_of(light.direction).forward,
                 .atlas_width = layout.width,
                 .atlas_height = layout.height,
                 .tile_resolution = layout.tile_resolution,
                 .depth_range_source = {},
                 .cascades = {}};
  double largest_diameter = 0.0;
  for (const SplitTile& tile : tiles) {
    Cascade cascade;
    cascade.index = static_cast<int>(set.cascades.size());
    cascade.offset_scale = tile_rectangle(layout, cascade.index);
    cascade.split_sphere = glm::dvec4(tile.sphere.centre, tile.sphere.radius);
    TileBox box = tile.box;
    snap(layout.tile_resolution, box);
    place_matrices(tile.axes, box, set, cascade);
    derive_scales(set, settings, cascade);
    if (const std::string why = why_not_emittable(cascade); !why.empty()) {
      throw InputError("", fmt::format("cascade {} cannot be represented: {}", cascade.index, why),
                       "the caster bounds, the angle of view or the light's diameter are extreme");
    }
    set.cascades.push_back(cascade);
    largest_diameter = std::max(largest_diameter, 2.0 * tile.sphere.radius);
  }
  set.depth_range_source = describe_depth_range(settings, largest_diameter);
  return set;
}

CascadeSet fit_cascades(const Camera& camera, const Light& light, const ShadowSettings& settings) {
  return placed(split_tiles(camera, light, settings), light, settings);
}

}  // namespace penumbra::parameters
