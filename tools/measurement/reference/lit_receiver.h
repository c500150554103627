// The pixels that are receivers of a light, and the start of their rays: one rule for every reference.
//
// Space: relative to the scene's origin, metres. Single precision positions carry rounding of the rasteriser
// that made them, so a ray starts a little above the surface, along its geometric normal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "parameters/cascades.h"
#include "scene/frame.h"

namespace penumbra::reference {

// The sun: unit direction to its centre, and its radius. A point s of the unit disc,
// uniform by area, is seen in direction to_light + tan_half * (s.x * right + s.y * up): uniform on a disc
// perpendicular to the light, so that between planes perpendicular to it visibility is exactly the lit share
// of a disc of radius tan_half * gap.
struct DiscLight {
  glm::dvec3 to_light{0.0, 1.0, 0.0};
  glm::dvec3 right{1.0, 0.0, 0.0};
  glm::dvec3 up{0.0, 0.0, 1.0};
  double sin_half = 0.0;
  double tan_half = 0.0;
};

// Throws InputError if the direction is zero or not finite, or the angular diameter is outside 0 .. 30
// degrees.
DiscLight disc_light(const parameters::Light& light);

// Returns the metres by which rays start above a surface at this position: 2^-15 of its largest coordinate,
// which counts as at least a metre (0.03 mm within a metre, 1.5 mm at 50 m). That is 256 to 512 ULP of the
// position.
double surface_offset(const glm::vec3& position);

struct LitReceiver {
  glm::dvec3 position;  // lifted by surface_offset
  glm::dvec3 normal;    // unit
};

// Returns nothing where no surface was seen, where position or normal are not finite or the normal is no
// direction, and where part of the disc is below the surface's horizon:
// normal . to_light <= sin_half.
std::optional<LitReceiver> lit_receiver(const scene::Receivers& receivers, std::size_t pixel,
                                        const DiscLight& light);

// Returns 1 where lit_receiver() has a value. Throws InputError when the buffers' sizes disagree with width x
// height.
std::vector<std::uint8_t> valid_receivers(const scene::Receivers& receivers, const DiscLight& light);

}  // namespace penumbra::reference
