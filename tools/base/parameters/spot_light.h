// A spot light and its shadow map: one tile in perspective, its matrices, and the scales soft shadows need.
//
// URP's spot lights are points. Here the light has a source, a disc with a radius in metres that faces each
// receiver, so that its shadows have penumbrae. The cone limits where light is, not its visibility: its
// falloff is not part of the shadow.
//
//      ____|____    source, radius R
//       \  |  /
//   -----\ | /      d_b, an edge
//         \|/
//         /|\      all depths along the axis
//    ____/_|_\____  d_r, a receiver
//        2 w
//
// An edge at axial depth d_b casts on a receiver at d_r a penumbra of radius w = R (d_r - d_b) / d_b: the
// distance from the shadow of the source's centre to where all of the source is visible, and to where none of
// it is. In the map's UV it is w / (2 tan(angle / 2) d_r), which is linear in the stored depths. That is on
// the axis; at an angle t to it, the source, which faces the receiver, makes the penumbra 1 / cos t times as
// wide away from the axis, to first order in R.
//
// Spaces: as parameters/cascades.h. Axial depth: metres from the light's position along its direction.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "parameters/cascades.h"

namespace penumbra::parameters {

// Angles are full ones, as in Unity; the light fades from inner_angle_degrees to outer_angle_degrees.
struct SpotLight {
  glm::dvec3 position{0.0, 3.0, 0.0};
  glm::dvec3 direction{0.0, -1.0, 0.0};  // the direction in which the light travels; any length but zero
  double inner_angle_degrees = 21.80208;
  double outer_angle_degrees = 30.0;      // 1 .. 179
  double source_radius_metres = 0.05;     // 0 means a point
  double range_metres = 10.0;             // there is no light beyond
  double shadow_near_plane_metres = 0.2;  // Light.shadowNearPlane: nearer casters have no shadow
  double shadow_guard_degrees = 0.0;      // the map is wider than the cone by this angle; URP's is 0
};

struct SpotShadow {
  bool reversed_z = true;
  ClipDepth clip_depth = ClipDepth::zero_to_one;
  SpotLight light;     // with a unit direction
  int resolution = 0;  // size of the tile, which is the whole map
  glm::dmat4 view{1.0};
  glm::dmat4 projection{1.0};  // for clip_depth, not reversed (as Unity's CPU-side matrices)
  // The matrix takes world space to (u, v, stored depth) times w, and w: the axial depth. Stored depth is in
  // [0, 1], reversed when reversed_z.
  glm::dmat4 world_to_shadow{1.0};
  double uv_per_tangent = 0.0;   // UV per metre across at an axial depth of 1 m
  double depth_to_radial = 0.0;  // penumbra RADIUS in UV per unit of stored depth gap, at any depth
  std::optional<double> radial_to_depth{};  // inverse; absent for a point source
  double depth_bias_metres = 0.0;           // URP's _ShadowBias.x and .y, both <= 0
  double normal_bias_metres = 0.0;

  double stored_depth(double axial_metres) const;
  double axial_depth(double stored) const;  // the inverse of the stored depth
};

// Returns w of the drawing above. Depths are axial; the blocker is nearer than the receiver.
double penumbra_radius_metres(const SpotLight& light, double receiver_metres, double blocker_metres);

// Returns the map in URP's convention: a square perspective of the outer angle plus the guard, from the
// shadow near plane to the range. It reads resolution, biases, soft quality, reversed_z and clip_depth of the
// settings. Source of the bias: URP's ShadowUtils.GetShadowBias, whose texel of a spot light is half the far
// plane's width, by the outer angle, over the resolution. Throws InputError naming what is out of range.
SpotShadow spot_shadow(const SpotLight& light, const ShadowSettings& settings);

// Makes the same check alone.
void check_spot_light(const SpotLight& light);

}  // namespace penumbra::parameters
