// Cascades fitted to the receivers that the camera sees, instead of to spheres around the view frustum.
//
// The camera sees only a part of a split sphere's tile: the frustum fills a third of its sphere's shadow, and
// the scene's surfaces a part of the frustum. A tile around the visible part has smaller texels for the same
// memory and no additional fetch. Source: Lauritzen, Salvi and Lefohn, "Sample Distribution Shadow Maps", I3D
// 2011, whose partitions are fitted to the depths that are seen, and their boxes to the positions.
//
// The cost: a tile changes when the visible part changes, and with it the size of its texels. Sizes are
// therefore powers of 2^(1/8), turns of the tile multiples of 15 degrees, and positions whole texels: while
// size and turn stay the same, edges stand still. Surfaces that are not among the receivers, such as
// transparent ones, may lie outside of the tile. Casters outside of it are drawn as with any fit: by the
// matrices, clamped to the near plane.
//
// Receivers are read back from a depth image, or are corners of what is known to be visible. Cascades are
// still selected by split spheres: a receiver belongs to the first whose sphere holds it.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "parameters/cascades.h"

namespace penumbra::parameters {

enum class LightFit {
  sphere,                 // fit_cascades
  casters,                // fit_cascades with fit_to_bounds
  receivers,              // a square around the receivers of each cascade
  turned_receivers,       // the smallest such square of those turned about the light's direction
  turned_receivers_range  // besides, the splits divide the depths that are seen, not all up to the shadow
                          // distance
};

inline constexpr std::array kLightFits{LightFit::sphere, LightFit::casters, LightFit::receivers,
                                       LightFit::turned_receivers, LightFit::turned_receivers_range};

// Returns "sphere", "casters", "receivers", "turned-receivers" or "turned-receivers-range".
std::string_view name_of(LightFit fit);
std::optional<LightFit> light_fit_named(std::string_view name);

// Each size of the tile's side is 2^(1/8) times the one before.
inline constexpr double kSizesPerOctave = 8.0;
inline constexpr double kTurnDegrees = 15.0;
// The texels that a filter reads beyond the penumbra's radius: a smallest kernel of 1.25 texels, and the
// texels that it interpolates. The fit adds the radius itself for each receiver from the depth of the nearest
// caster that the map can hold.
inline constexpr double kKernelMarginTexels = 2.0;

// `receivers` are world positions. One in no split sphere belongs to no cascade; a cascade without receivers
// has its sphere's tile, and none is larger than that. Without depth_range_metres the far plane lies behind
// the farthest receiver. Throws InputError as fit_cascades() does, and for a position that is not finite.
CascadeSet fit_cascades(const Camera& camera, const Light& light, const ShadowSettings& settings,
                        LightFit fit, std::span<const glm::dvec3> receivers);

}  // namespace penumbra::parameters
