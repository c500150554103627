#include "parameters/verify.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace penumbra::parameters {

namespace {

using Real = long double;
using Vec3 = glm::vec<3, Real>;
using Vec4 = glm::vec<4, Real>;
using Mat4 = glm::mat<4, 4, Real>;

// A tile's size in metres, from which every scale follows.
struct Extent {
  Real half_extent = 0;
  Real range = 0;
};

struct Axes {
  Vec3 right;
  Vec3 up;
  Vec3 forward;
};

struct Interval {
  Real near = 0;
  Real far = 0;
};

Axes light_axes(const Light& light) {
  const Vec3 forward = glm::normalize(Vec3(light.direction));
  const Vec3 hint = std::abs(forward.y) < 0.99L ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  const Vec3 up = glm::normalize(hint - forward * glm::dot(hint, forward));
  return {glm::cross(up, forward), up, forward};
}

Interval split_of(const Camera& camera, const ShadowSettings& settings, int index) {
  const auto splits = effective_splits(settings);
  const Real distance = std::min(settings.distance_metres, camera.far_plane);
  const auto end = [&](int i) {
    return i + 1 == settings.cascades ? distance : distance * Real{splits[static_cast<std::size_t>(i)]};
  };
  return {index == 0 ? Real{camera.near_plane} : end(index - 1), end(index)};
}

// The centre follows from the positions of one near and one far corner: it is the point on the axis
// equidistant from both.
Vec4 split_sphere(const Camera& camera, const Interval& split) {
  const Real tan_y = std::tan(Real{camera.fov_y_degrees} * std::numbers::pi_v<Real> / 360);
  const Vec3 ray(tan_y * Real{camera.aspect}, tan_y, 1);
  const Vec3 near_corner = ray * split.near;
  const Vec3 far_corner = ray * split.far;
  const Real equal = (glm::dot(far_corner, far_corner) - glm::dot(near_corner, near_corner)) /
                     (2 * (split.far - split.near));
  const Real along = std::min(equal, split.far);
  const Vec3 centre = Vec3(camera.position) + glm::normalize(Vec3(camera.forward)) * along;
  return Vec4(centre, glm::length(far_corner - Vec3(0, 0, along)));
}

// Extent of the casters' box along an axis: centre plus or minus the half size's projection.
Interval extent_along(const Bounds& bounds, const Vec3& axis) {
  const Vec3 low(bounds.minimum);
  const Vec3 high(bounds.maximum);
  const Real middle = glm::dot(axis, low + high) / 2;
  const Real reach = glm::dot(glm::abs(axis), high - low) / 2;
  return {middle - reach, middle + reach};
}

struct Box {
  Real x = 0;
  Real y = 0;
  Real half = 0;
  Interval depth;
};

void tighten(const Bounds& bounds, const Axes& axes, Box& box) {
  const Interval x = extent_along(bounds, axes.right);
  const Interval y = extent_along(bounds, axes.up);
  const Interval in_x{std::max(x.near, box.x - box.half), std::min(x.far, box.x + box.half)};
  const Interval in_y{std::max(y.near, box.y - box.half), std::min(y.far, box.y + box.half)};
  const Real width = in_x.far - in_x.near;
  const Real height = in_y.far - in_y.near;
  if (width < 0 || height < 0 || (width == 0 && height == 0)) return;
  box = {(in_x.near + in_x.far) / 2, (in_y.near + in_y.far) / 2, std::max(width, height) / 2, box.depth};
}

Interval depth_of(const ShadowSettings& settings, const Axes& axes, Real centre, Real radius) {
  const Real offset = settings.near_plane_offset_metres;
  if (settings.depth_range_metres) {
    const Real range = *settings.depth_range_metres;
    const Real far = range < 2 * radius ? centre + range / 2 : centre + radius;
    return {far - range, far};
  }
  Real first = centre - radius;
  if (settings.caster_bounds) {
    const Real casters = extent_along(*settings.caster_bounds, axes.forward).near;
    if (casters < centre + radius && (settings.fit_to_bounds || casters < first)) first = casters;
  }
  return {first - offset, centre + radius};
}

Box fit_box(const ShadowSettings& settings, const Axes& axes, const Vec4& sphere, int resolution) {
  const Vec3 centre(sphere);
  const Real along = glm::dot(axes.forward, centre);
  Box box{glm::dot(axes.right, centre), glm::dot(axes.up, centre), sphere.w,
          depth_of(settings, axes, along, sphere.w)};
  if (settings.fit_to_bounds) tighten(*settings.caster_bounds, axes, box);
  const Real texel = 2 * box.half / (resolution - 2 * Real{kSnapMarginTexels});
  box.half = texel * resolution / 2;
  box.x = texel * std::floor(box.x / texel + Real{0.5} + Real{kSnapTieTexels});
  box.y = texel * std::floor(box.y / texel + Real{0.5} + Real{kSnapTieTexels});
  return box;
}

// The matrix is made the other way, from (atlas u, atlas v, stored depth) to the world, and then inverted.
Mat4 world_to_shadow(const CascadeSet& set, const Axes& axes, const Box& box, const Vec4& tile) {
  const Real range = box.depth.far - box.depth.near;
  const Vec3 per_u = axes.right * (2 * box.half / tile.z);
  const Vec3 per_v = axes.up * (2 * box.half / tile.w);
  const Vec3 per_depth = axes.forward * (set.reversed_z ? -range : range);
  const Vec3 tile_corner = axes.right * (box.x - box.half) + axes.up * (box.y - box.half) +
                           axes.forward * (set.reversed_z ? box.depth.far : box.depth.near);
  const Vec3 origin = tile_corner - per_u * tile.x - per_v * tile.y;
  return glm::inverse(Mat4(Vec4(per_u, 0), Vec4(per_v, 0), Vec4(per_depth, 0), Vec4(origin, 1)));
}

Mat4 light_view(const Axes& axes, const Box& box) {
  const Vec3 eye = axes.right * box.x + axes.up * box.y + axes.forward * box.depth.near;
  return glm::inverse(Mat4(Vec4(axes.right, 0), Vec4(axes.up, 0), Vec4(-axes.forward, 0), Vec4(eye, 1)));
}

Mat4 light_projection(const CascadeSet& set, const Box& box) {
  const Real range = box.depth.far - box.depth.near;
  const bool unit = set.clip_depth == ClipDepth::zero_to_one;
  Mat4 projection(1);
  projection[0][0] = projection[1][1] = 1 / box.half;
  projection[2][2] = -(unit ? 1 : 2) / range;
  projection[3][2] = unit ? 0 : -1;
  return projection;
}

Vec4 tile_of(const CascadeSet& set, int index) {
  const Real width = Real{1} * set.tile_resolution / set.atlas_width;
  const Real height = Real{1} * set.tile_resolution / set.atlas_height;
  return {index % 2 == 1 ? width : 0, index >= 2 ? height : 0, width, height};
}

// Collects the fields of one cascade.
class Comparison {
 public:
  void scalar(const char* field, double emitted, Real exact) {
    errors_.push_back({field, ulp_error(static_cast<float>(emitted), exact, 0.0)});
  }

  void vector(const char* field, const glm::dvec4& emitted, const Vec4& exact) {
    errors_.push_back({field, worst_of(emitted, exact)});
  }

  void matrix(const char* field, const glm::dmat4& emitted, const Mat4& exact) {
    const glm::dmat4 rows = glm::transpose(emitted);
    const Mat4 exact_rows = glm::transpose(exact);
    double worst = 0.0;
    for (int row = 0; row < 4; ++row) worst = std::max(worst, worst_of(rows[row], exact_rows[row]));
    errors_.push_back({field, worst});
  }

  CascadeErrors take() { return std::move(errors_); }

 private:
  static double worst_of(const glm::dvec4& emitted, const Vec4& exact) {
    double scale = 0.0;
    for (int i = 0; i < 4; ++i) scale = std::max(scale, std::abs(static_cast<double>(exact[i])));
    double worst = 0.0;
    for (int i = 0; i < 4; ++i) {
      worst = std::max(worst, ulp_error(static_cast<float>(emitted[i]), exact[i], scale));
    }
    return worst;
  }

  CascadeErrors errors_;
};

void compare_scales(const ShadowSettings& settings, const CascadeSet& set, const Cascade& cascade,
                    const Extent& exact, Comparison& compare) {
  const Real tan_half = std::tan(Real{set.angular_diameter_degrees} * std::numbers::pi_v<Real> / 360);
  const Real side = 2 * exact.half_extent;
  const Real texel = side / set.tile_resolution;
  const Real radius = tan_half * exact.range;  // metres, for a gap as long as the whole depth range
  compare.scalar("uv_per_metre", cascade.uv_per_metre, 1 / side);
  compare.scalar("depth_per_metre", cascade.depth_per_metre, 1 / exact.range);
  compare.scalar("depth_to_radial", cascade.depth_to_radial, radius / side);
  if (cascade.radial_to_depth) compare.scalar("radial_to_depth", *cascade.radial_to_depth, side / radius);
  compare.scalar("depth_to_radial_hdrp", cascade.depth_to_radial_hdrp, radius / exact.half_extent);
  compare.scalar("texel_size_metres", cascade.texel_size_metres, texel);
  compare.scalar("max_penumbra_texels", cascade.max_penumbra_texels, radius / texel);
  const Real kernel = Real{kernel_radius_texels(settings.soft_quality)} * texel;
  compare.scalar("bias.depth", cascade.depth_bias_metres, -kernel * Real{settings.depth_bias});
  compare.scalar("bias.normal", cascade.normal_bias_metres, -kernel * Real{settings.normal_bias});
}

}  // namespace

double ulp_error(float emitted, long double exact, double scale) {
  const double floor = std::ldexp(scale, -24);
  const auto at = static_cast<float>(std::max(std::abs(static_cast<double>(emitted)), floor));
  const float spacing = std::nextafter(at, HUGE_VALF) - at;
  return static_cast<double>(std::abs(static_cast<long double>(emitted) - exact) / spacing);
}

double worst_ulp(const CascadeErrors& errors) {
  double worst = 0.0;
  for (const FieldError& error : errors) worst = std::max(worst, error.ulp);
  return worst;
}

std::vector<CascadeErrors> verify_fit(const Camera& camera, const Light& light,
                                      const ShadowSettings& settings, const CascadeSet& set) {
  const Axes axes = light_axes(light);
  std::vector<CascadeErrors> result;
  for (const Cascade& cascade : set.cascades) {
    const Vec4 sphere = split_sphere(camera, split_of(camera, settings, cascade.index));
    const Vec4 tile = tile_of(set, cascade.index);
    const Box box = fit_box(settings, axes, sphere, set.tile_resolution);
    const Extent exact{.half_extent = box.half, .range = box.depth.far - box.depth.near};
    Comparison compare;
    compare.matrix("view", cascade.view, light_view(axes, box));
    compare.matrix("projection", cascade.projection, light_projection(set, box));
    compare.matrix("world_to_shadow", cascade.world_to_shadow, world_to_shadow(set, axes, box, tile));
    compare.vector("offset_scale", cascade.offset_scale, tile);
    // Centre and radius are both in metres, but not of one scale, so each is compared by itself.
    compare.vector("split_sphere.centre", glm::dvec4(glm::dvec3(cascade.split_sphere), 0.0),
                   Vec4(Vec3(sphere), 0));
    compare.scalar("split_sphere.radius", cascade.split_sphere.w, sphere.w);
    compare_scales(settings, set, cascade, exact, compare);
    result.push_back(compare.take());
  }
  return result;
}

std::vector<CascadeErrors> verify_dump(const ShadowSettings& settings, const CascadeSet& set) {
  std::vector<CascadeErrors> result;
  for (const Cascade& cascade : set.cascades) {
    const Vec4 tile = tile_of(set, cascade.index);
    // Columns of the inverse: metres per unit of atlas UV and of depth.
    const Mat4 back = glm::inverse(Mat4(cascade.world_to_shadow));
    const Extent exact{.half_extent = glm::length(Vec3(back[0])) * tile.z / 2,
                       .range = glm::length(Vec3(back[2]))};
    Comparison compare;
    compare.vector("offset_scale", cascade.offset_scale, tile);
    compare_scales(settings, set, cascade, exact, compare);
    result.push_back(compare.take());
  }
  return result;
}

}  // namespace penumbra::parameters
