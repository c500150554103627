#include "parameters/matrices_input.h"

#include <fmt/format.h>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "input/input_error.h"
#include "input/located_json.h"
#include "input/nearest_name.h"
#include "parameters/matrix_row.h"
#include "parameters/setting_keys.h"
#include "parameters/settings_input.h"

namespace penumbra::parameters {
namespace {

// Matrices are dumped as floats, often with six or seven digits.
constexpr double kRounding = 2e-5;

std::string why_not_affine(const glm::dmat4& m) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(m[column][row])) {
        return fmt::format("is not finite in row {}, column {}", row, column);
      }
    }
  }
  const glm::dvec4 last(m[0][3], m[1][3], m[2][3], m[3][3]);
  if (last == glm::dvec4(0, 0, 0, 1)) return {};
  const glm::dvec4 transposed_last = m[3];
  if (transposed_last == glm::dvec4(0, 0, 0, 1)) {
    return "is affine only in the other matrix order: matrix_order is wrong";
  }
  return fmt::format("is a perspective projection: its last row is {} {} {} {}, not 0 0 0 1", last.x, last.y,
                     last.z, last.w);
}

std::string why_not_perpendicular(const glm::dmat4& m) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const glm::dvec3 a = matrix_row(m, i);
    const glm::dvec3 b = matrix_row(m, j);
    const double cosine = glm::dot(a, b) / (glm::length(a) * glm::length(b));
    if (std::abs(cosine) > kRounding) {
      return fmt::format("is sheared: the angle between rows {} and {} is {:.6g} degrees, not 90",
                         std::min(i, j), std::max(i, j),
                         std::acos(std::clamp(cosine, -1.0, 1.0)) * 57.29577951308232);
    }
  }
  return {};
}

std::string why_singular(const glm::dmat4& m) {
  double lengths = 1.0;
  for (int row = 0; row < 3; ++row) {
    const double length = glm::length(matrix_row(m, row));
    if (!(length > 0.0)) return fmt::format("is singular: row {} is zero", row);
    lengths *= length;
  }
  const double volume = std::abs(glm::determinant(glm::dmat3(m))) / lengths;
  if (!(volume > 1e-9)) return "is singular: its rows lie in one plane";
  return {};
}

// The matrix may have rotation (or reflection) and translation only.
std::string why_not_rigid(const glm::dmat4& matrix) {
  if (std::string why = why_not_affine(matrix); !why.empty()) return why;
  if (std::string why = why_singular(matrix); !why.empty()) return why;
  for (int row = 0; row < 3; ++row) {
    const double length = glm::length(matrix_row(matrix, row));
    if (std::abs(length - 1.0) > kRounding) {
      return fmt::format("is scaled: row {} has length {:.9g}, not 1", row, length);
    }
  }
  return why_not_perpendicular(matrix);
}

// The matrix must be orthographic and seen along the light: affine, invertible, rows perpendicular, and the
// first two of equal length once each is divided by its tile's size in the atlas.
std::string why_not_light_projection(const glm::dmat4& matrix, const glm::dvec2& tile_size) {
  if (std::string why = why_not_affine(matrix); !why.empty()) return why;
  if (std::string why = why_singular(matrix); !why.empty()) return why;
  if (std::string why = why_not_perpendicular(matrix); !why.empty()) return why;
  const double x = glm::length(matrix_row(matrix, 0)) / tile_size.x;
  const double y = glm::length(matrix_row(matrix, 1)) / tile_size.y;
  if (std::abs(x - y) > kRounding * std::max(x, y)) {
    return fmt::format("is stretched: a metre is {:.9g} of the tile across and {:.9g} of it up", x, y);
  }
  return {};
}

// Returns row-major numbers as a matrix; column-major ones are transposed.
glm::dmat4 matrix_from(const double* numbers, bool row_major) {
  glm::dmat4 matrix(1.0);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      matrix[column][row] = row_major ? numbers[row * 4 + column] : numbers[column * 4 + row];
    }
  }
  return matrix;
}

void require(JsonObject& object, const char* key, const char* why) {
  if (!object.has(key)) object.fail(key, fmt::format("'{}' is missing", key), why);
}

bool read_row_major(JsonObject& root) {
  require(root, "matrix_order", "state the order: \"row-major\" or \"column-major\"");
  const std::string order = root.text("matrix_order", "");
  if (order != "row-major" && order != "column-major") {
    root.fail("matrix_order", fmt::format("unknown order '{}'", order),
              unknown_name_remedy(order, {"row-major", "column-major"}));
  }
  return order == "row-major";
}

// Reads one cascade; the set's own fields are known by now.
class CascadeReader {
 public:
  CascadeReader(const CascadeSet& set, bool row_major, std::optional<glm::dvec3> light_direction)
      : set_(set), row_major_(row_major), light_direction_(light_direction) {}

  Cascade read(JsonObject object, int index, const glm::dvec4& tile) const {
    Cascade cascade;
    cascade.index = index;
    cascade.offset_scale = tile;
    const bool pair = object.has("view") || object.has("projection");
    const bool shadow = object.has("world_to_shadow");
    if (!pair && !shadow) {
      object.fail("view", "the cascade has no matrix", "give view and projection, or world_to_shadow");
    }
    if (pair) read_pair(object, cascade);
    if (shadow) read_shadow(object, cascade, pair);
    check_direction(object, cascade, shadow ? "world_to_shadow" : "projection");
    if (!pair) derive_pair(cascade);
    read_sphere(object, cascade);
    object.finish();
    return cascade;
  }

 private:
  glm::dmat4 matrix(JsonObject& object, const char* key) const {
    require(object, key, "view and projection must be given together");
    return matrix_from(object.numbers(key, 16).data(), row_major_);
  }

  void read_pair(JsonObject& object, Cascade& cascade) const {
    cascade.view = matrix(object, "view");
    cascade.projection = matrix(object, "projection");
    if (const auto why = why_not_rigid(cascade.view); !why.empty()) {
      object.fail("view", "the view matrix " + why);
    }
    if (const auto why = why_not_light_projection(cascade.projection, {1, 1}); !why.empty()) {
      object.fail("projection", "the projection matrix " + why);
    }
    if (cascade.projection[2][2] > 0.0) {
      object.fail("projection", "the projection matrix is already reversed: m22 is positive",
                  "dump the matrix of ComputeDirectionalShadowMatricesAndCullingPrimitives itself, before "
                  "GL.GetGPUProjectionMatrix; reversed_z says what the device does with it");
    }
    cascade.world_to_shadow = transform(cascade, set_.clip_depth, set_.reversed_z);
  }

  glm::dmat4 transform(const Cascade& cascade, ClipDepth clip_depth, bool reversed) const {
    return shadow_transform(cascade.view, cascade.projection, clip_depth, reversed, cascade.offset_scale);
  }

  void read_shadow(JsonObject& object, Cascade& cascade, bool compare) const {
    const glm::dmat4 given = matrix(object, "world_to_shadow");
    const glm::dvec2 tile(cascade.offset_scale.z, cascade.offset_scale.w);
    if (const auto why = why_not_light_projection(given, tile); !why.empty()) {
      object.fail("world_to_shadow", "the shadow matrix " + why);
    }
    if (compare && !agree(given, cascade.world_to_shadow)) fail_disagreement(object, cascade, given);
    cascade.world_to_shadow = given;
  }

  // The matrices are equal within float rounding of products whose terms are as long as the eye is far.
  static bool agree(const glm::dmat4& a, const glm::dmat4& b) {
    for (int row = 0; row < 3; ++row) {
      const double scale = glm::length(matrix_row(b, row));
      const double reach = 1.0 + std::abs(b[3][row]);
      if (glm::length(matrix_row(a, row) - matrix_row(b, row)) > 1e-5 * scale) return false;
      if (std::abs(a[3][row] - b[3][row]) > 1e-5 * reach) return false;
    }
    return true;
  }

  [[noreturn]] void fail_disagreement(JsonObject& object, const Cascade& cascade,
                                      const glm::dmat4& given) const {
    for (const ClipDepth clip_depth : {ClipDepth::zero_to_one, ClipDepth::minus_one_to_one}) {
      for (const bool reversed : {false, true}) {
        if (!agree(given, transform(cascade, clip_depth, reversed))) continue;
        object.fail(
            "world_to_shadow",
            "the shadow matrix does not match view and projection as the file describes them",
            fmt::format("it matches with clip_depth {} and reversed_z {}", name_of(clip_depth), reversed));
      }
    }
    object.fail(
        "world_to_shadow", "the shadow matrix does not match view and projection",
        "dump all three in the same frame, with the resolution and the number of cascades of the map");
  }

  // Stored depth grows along the light, or against it when reversed.
  void check_direction(JsonObject& object, const Cascade& cascade, const char* key) const {
    if (!light_direction_) return;
    const glm::dvec3 depth = matrix_row(cascade.world_to_shadow, 2) * (set_.reversed_z ? -1.0 : 1.0);
    const double cosine = glm::dot(glm::normalize(depth), *light_direction_);
    if (cosine > 0.9999) return;
    if (cosine < -0.9999) {
      object.fail(
          key, "depth runs against the light: reversed_z or light_direction is inverted",
          "light_direction is the direction in which the light travels (transform.forward of Unity's light)");
    }
    object.fail(key, fmt::format("depth runs {:.4g} degrees off light_direction",
                                 std::acos(cosine) * 57.29577951308232));
  }

  // Derives a view and a projection that give this shadow matrix, with the eye in the middle of the near
  // plane.
  void derive_pair(Cascade& cascade) const {
    const glm::dmat4& m = cascade.world_to_shadow;
    const double sign = set_.reversed_z ? -1.0 : 1.0;
    const glm::dvec3 right = glm::normalize(matrix_row(m, 0));
    const glm::dvec3 up = glm::normalize(matrix_row(m, 1));
    const glm::dvec3 forward = glm::normalize(matrix_row(m, 2)) * sign;
    const glm::dvec4 tile = cascade.offset_scale;
    const glm::dvec4 near_centre(tile.x + 0.5 * tile.z, tile.y + 0.5 * tile.w, set_.reversed_z ? 1 : 0, 1);
    const glm::dvec3 eye(glm::inverse(m) * near_centre);
    const glm::dmat3 rotation = glm::transpose(glm::dmat3(right, up, -forward));
    cascade.view = glm::dmat4(rotation);
    cascade.view[3] = glm::dvec4(-(rotation * eye), 1.0);
    const double per_range = glm::length(matrix_row(m, 2));
    const bool unit = set_.clip_depth == ClipDepth::zero_to_one;
    cascade.projection = glm::dmat4(1.0);
    cascade.projection[0][0] = 2.0 * glm::length(matrix_row(m, 0)) / tile.z;
    cascade.projection[1][1] = 2.0 * glm::length(matrix_row(m, 1)) / tile.w;
    cascade.projection[2][2] = unit ? -per_range : -2.0 * per_range;
    cascade.projection[3][2] = unit ? 0.0 : -1.0;
  }

  // The sphere is given, or is the one that is as wide as the tile: its centre and half its side.
  void read_sphere(JsonObject& object, Cascade& cascade) const {
    if (!object.has("split_sphere")) {
      const glm::dvec4 tile = cascade.offset_scale;
      const glm::dvec4 middle(tile.x + 0.5 * tile.z, tile.y + 0.5 * tile.w, 0.5, 1.0);
      const double half = 0.5 * tile.z / glm::length(matrix_row(cascade.world_to_shadow, 0));
      cascade.split_sphere = glm::dvec4(glm::dvec3(glm::inverse(cascade.world_to_shadow) * middle), half);
      return;
    }
    const std::vector<double> sphere = object.numbers("split_sphere", 4);
    cascade.split_sphere = {sphere[0], sphere[1], sphere[2], sphere[3]};
    if (!(sphere[3] > 0.0)) object.fail("split_sphere", "the sphere's radius is not positive");
    const double depth = (cascade.world_to_shadow * glm::dvec4(glm::dvec3(cascade.split_sphere), 1.0)).z;
    if (!(depth >= 0.0 && depth <= 1.0)) {
      object.fail("split_sphere",
                  fmt::format("the sphere's centre has stored depth {:.6g}, outside the map's 0 .. 1", depth),
                  "clip_depth may be the other one, or the sphere of another cascade or frame");
    }
  }

  const CascadeSet& set_;
  bool row_major_;
  std::optional<glm::dvec3> light_direction_;
};

// The bounds are those of the same setting in a --config file.
void check_bounds(const JsonObject& object, const char* key, const char* setting_name, double value) {
  const SettingKey& setting = setting_key(setting_name);
  if (value >= setting.smallest && value <= setting.largest) return;
  object.fail(key, fmt::format("is {}, outside {}{}{}", value, setting.bounds(),
                               *setting.unit == '\0' ? "" : " ", setting.unit));
}

ShadowSettings read_map(JsonObject& root) {
  ShadowSettings settings;
  settings.resolution = root.integer("resolution", settings.resolution);
  settings.depth_bias = root.number("depth_bias", settings.depth_bias);
  settings.normal_bias = root.number("normal_bias", settings.normal_bias);
  settings.soft_quality = read_soft_quality(root, "soft_quality", settings.soft_quality);
  check_bounds(root, "resolution", "/shadows/resolution", settings.resolution);
  check_bounds(root, "depth_bias", "/shadows/depth_bias", settings.depth_bias);
  check_bounds(root, "normal_bias", "/shadows/normal_bias", settings.normal_bias);
  require(
      root, "clip_depth",
      "state the projections' depth range: \"minus_one_to_one\" (Unity's own matrices) or \"zero_to_one\"");
  settings.clip_depth = read_clip_depth(root, "clip_depth", settings.clip_depth);
  require(root, "reversed_z", "state whether the device reverses depth (SystemInfo.usesReversedZBuffer)");
  settings.reversed_z = root.boolean("reversed_z", true);
  return settings;
}

std::optional<glm::dvec3> read_direction(JsonObject& root) {
  if (!root.has("light_direction")) return std::nullopt;
  const std::vector<double> numbers = root.numbers("light_direction", 3);
  const glm::dvec3 direction(numbers[0], numbers[1], numbers[2]);
  const double length = glm::length(direction);
  if (!(length > 1e-150 && length < 1e150))
    root.fail("light_direction", "is the zero vector or out of range");
  return direction / length;
}

}  // namespace

glm::dmat4 shadow_transform(const glm::dmat4& view, const glm::dmat4& projection, ClipDepth clip_depth,
                            bool reversed_z, const glm::dvec4& offset_scale) {
  // Unity's projections are -1 .. 1. Others are first mapped to that range, the depth row is negated if the
  // device reverses, and x, y and z alike are mapped to 0 .. 1. With depth 0 .. 1 that is z or 1 - z.
  glm::dmat4 clip = projection;
  if (clip_depth == ClipDepth::zero_to_one) {
    for (int column = 0; column < 4; ++column) clip[column][2] = 2.0 * clip[column][2] - clip[column][3];
  }
  if (reversed_z) {
    for (int column = 0; column < 4; ++column) clip[column][2] = -clip[column][2];
  }
  const glm::dvec3 scale = 0.5 * glm::dvec3(offset_scale.z, offset_scale.w, 1.0);
  const glm::dvec3 offset = glm::dvec3(offset_scale.x, offset_scale.y, 0.0) + scale;
  glm::dmat4 to_atlas(1.0);
  for (int i = 0; i < 3; ++i) {
    to_atlas[i][i] = scale[i];
    to_atlas[3][i] = offset[i];
  }
  return to_atlas * clip * view;
}

MatricesDump read_matrices(const LocatedJson& document) {
  JsonObject root(document);
  const bool row_major = read_row_major(root);
  MatricesDump dump;
  dump.settings = read_map(root);
  const auto direction = read_direction(root);
  const std::vector<JsonObject> cascades = root.objects("cascades");
  if (cascades.empty() || cascades.size() > 4) {
    root.fail("cascades", fmt::format("{} cascades, outside 1 .. 4", cascades.size()),
              "leave out the no-op matrices Unity appends to _MainLightWorldToShadow");
  }
  dump.settings.cascades = static_cast<int>(cascades.size());
  const AtlasLayout layout = atlas_layout(dump.settings.resolution, dump.settings.cascades);
  CascadeSet& set = dump.set;
  set.reversed_z = dump.settings.reversed_z;
  set.clip_depth = dump.settings.clip_depth;
  set.angular_diameter_degrees = root.number("angular_diameter_degrees", set.angular_diameter_degrees);
  check_bounds(root, "angular_diameter_degrees", "/light/angular_diameter_degrees",
               set.angular_diameter_degrees);
  root.finish();
  set.atlas_width = layout.width;
  set.atlas_height = layout.height;
  set.tile_resolution = layout.tile_resolution;
  set.depth_range_source = "the matrices given";
  const CascadeReader reader(set, row_major, direction);
  for (int i = 0; i < dump.settings.cascades; ++i) {
    Cascade cascade = reader.read(cascades[static_cast<std::size_t>(i)], i, tile_rectangle(layout, i));
    derive_scales(set, dump.settings, cascade);
    if (const std::string why = why_not_emittable(cascade); !why.empty()) {
      root.fail("cascades", fmt::format("cascade {} cannot be represented: {}", i, why));
    }
    set.cascades.push_back(cascade);
  }
  const glm::dvec3 depth = matrix_row(set.cascades.front().world_to_shadow, 2);
  set.light_direction = direction.value_or(glm::normalize(set.reversed_z ? -depth : depth));
  return dump;
}

}  // namespace penumbra::parameters
