// Cascaded shadow maps of a directional light: splits, fit, matrices and the scales soft shadows need.
//
// Spaces: world space in metres, +Y up by habit but not by need. View space looks down -Z, as Unity's view
// matrices do. Matrices multiply column vectors; GLM stores them column-major, emitters write row-major. All
// mathematics here is in double precision; a test compares every figure that is emitted as a float with
// another derivation in long double.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

namespace penumbra::parameters {

// Depth range of a device's clip space: Direct3D, Vulkan and Metal use [0, 1], OpenGL [-1, 1].
enum class ClipDepth { zero_to_one, minus_one_to_one };

struct Camera {
  glm::dvec3 position{0.0, 1.7, 0.0};
  glm::dvec3 forward{0.0, 0.0, 1.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  double fov_y_degrees = 60.0;
  double aspect = 16.0 / 9.0;
  double near_plane = 0.3;
  double far_plane = 1000.0;
};

struct Light {
  glm::dvec3 direction{0.3, -0.8, 0.5};    // the direction in which the light travels; any length but zero
  double angular_diameter_degrees = 0.53;  // full angle of the disc, 0 (point) .. 30; the sun's is 0.53
};

struct Bounds {
  glm::dvec3 minimum;
  glm::dvec3 maximum;
};

enum class SoftQuality { off, low, medium, high };

// URP's settings that move casters before they are drawn: unitless, in texels of the map times the kernel's
// radius.
struct CasterBias {
  double depth = 1.0;
  double normal = 1.0;
  SoftQuality soft_quality = SoftQuality::medium;

  bool operator==(const CasterBias&) const = default;
};

struct ShadowSettings {
  double distance_metres = 50.0;
  int cascades = 1;  // 1 .. 4
  // Fractions of the distance where cascades 0..2 end; if all are zero, URP's own for this number of cascades
  // (effective_splits).
  std::array<double, 3> splits{};
  int resolution = 2048;    // width of the atlas in texels; the tile follows as in URP
  double depth_bias = 1.0;  // URP's unitless settings
  double normal_bias = 1.0;
  SoftQuality soft_quality = SoftQuality::medium;
  bool reversed_z = true;
  ClipDepth clip_depth = ClipDepth::zero_to_one;  // convention of the projection matrices that are emitted
  std::optional<double> depth_range_metres{};     // extent of each light frustum along the light
  std::optional<Bounds> caster_bounds{};          // world box of all casters: fixes the near plane, and the
                                                  // custom fit tightens to it when fit_to_bounds is set
  bool fit_to_bounds = false;
  double near_plane_offset_metres =
      0.2;  // corresponds to Unity's Light.shadowNearPlane; added in front of the sphere
};

// A tile of the atlas. The matrices have URP's meaning: world_to_shadow maps world space to atlas UV (x, y)
// and to the depth that the map stores (z, already reversed when reversed_z), in [0, 1].
struct Cascade {
  int index = 0;
  glm::dmat4 view{1.0};
  glm::dmat4 projection{1.0};  // for the set's clip_depth, not reversed (as Unity's CPU-side matrices)
  glm::dmat4 world_to_shadow{1.0};
  glm::dvec4 offset_scale{0.0, 0.0, 1.0, 1.0};  // tile rectangle in atlas UV: x, y, width, height
  glm::dvec4 split_sphere{0.0};                 // world centre, radius in metres
  double uv_per_metre = 0.0;     // tile UV per metre across the light: |row0.xyz| / offset_scale.z
  double depth_per_metre = 0.0;  // stored depth per metre along the light: |row2.xyz|
  double depth_to_radial = 0.0;  // penumbra RADIUS in tile UV per unit of stored depth gap (geometric)
  std::optional<double> radial_to_depth{};  // inverse; absent at angular diameter 0
  // HDRP's tan(a/2) |m00 / m22| of the device projection (depth 0 .. 1): twice the geometric value, whatever
  // clip_depth is emitted. For a projection to -1 .. 1 the same ratio happens to be the geometric value.
  double depth_to_radial_hdrp = 0.0;
  double texel_size_metres = 0.0;
  double max_penumbra_texels = 0.0;  // radius for the whole depth range of the tile
  double depth_bias_metres = 0.0;    // URP's _ShadowBias.x and .y, both <= 0
  double normal_bias_metres = 0.0;
};

struct CascadeSet {
  bool reversed_z = true;
  ClipDepth clip_depth = ClipDepth::zero_to_one;
  double angular_diameter_degrees = 0.53;
  glm::dvec3 light_direction{0.0, -1.0, 0.0};  // unit, the direction in which the light travels
  int atlas_width = 0;
  int atlas_height = 0;  // half the width with two cascades, as URP allocates it
  int tile_resolution = 0;
  std::string depth_range_source;  // names the input that fixed the depth range
  std::vector<Cascade> cascades;
};

// Returns the splits in use: the given ones, or URP's defaults 0.25 | 0.1, 0.3 | 0.067, 0.2, 0.467.
std::array<double, 3> effective_splits(const ShadowSettings& settings);

// Snapping to texels rounds half up, but with round numbers halves are common, and rounding noise would
// decide them: so the tie is shifted slightly, to no simple fraction; the tile's margin is half a texel and
// more.
inline constexpr double kSnapTieTexels = 0.000618034;
inline constexpr double kSnapMarginTexels = 0.501;

// Returns URP's soft kernel radius in texels, by which GetShadowBias widens both biases: 1 (off), 1.5, 2.5,
// 3.5.
double kernel_radius_texels(SoftQuality quality);

// Returns the result of GetShadowBias: depth and normal bias in metres, at most 0, of a light whose
// orthographic projection (any clip depth) shows 2 / m00 metres across one tile.
glm::dvec2 bias_of_projection(const glm::dmat4& projection, int tile_resolution,
                              const ShadowSettings& settings);

// URP's atlas has tiles in two columns, row by row; the height halves with two cascades.
struct AtlasLayout {
  int width = 0;
  int height = 0;
  int tile_resolution = 0;
};
AtlasLayout atlas_layout(int resolution, int cascades);
glm::dvec4 tile_rectangle(const AtlasLayout& layout, int cascade);  // x, y, width, height in atlas UV

// Fills every figure that follows from world_to_shadow and offset_scale: from uv_per_metre to the biases.
void derive_scales(const CascadeSet& set, const ShadowSettings& settings, Cascade& cascade);

// Returns the name of a value that overflows a float or is NaN; empty if there is none.
std::string why_not_emittable(const Cascade& cascade);

// The fit, per cascade: the smallest sphere around the camera's sub-frustum (its radius does not change when
// the camera turns), a square tile around it, snapped to whole texels in light space (so a moving camera
// moves the map by whole texels), and a depth range from caster_bounds, depth_range_metres or the sphere.
// Unity's own fit is native code: this one is ours and equality with Unity's is not claimed.
// Throws InputError (input_error.h) when a setting is out of range.
CascadeSet fit_cascades(const Camera& camera, const Light& light, const ShadowSettings& settings);

}  // namespace penumbra::parameters
