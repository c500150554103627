// A procedural layer of clouds over a scene. It is the layer that ShaderLibrary/Core/CloudCover.hlsl draws
// into a map, in double and without a map.
#pragma once

#include <glm/vec2.hpp>

namespace penumbra::scene {

// The layer is a level plane. Defaults are those of CloudParameters in ShaderLibrary/Far, which a test
// compares.
struct CloudLayer {
  double altitude_metres = 1600.0;  // world space
  double feature_metres = 2400.0;   // size of the largest octave of the noise
  double coverage = 0.45;           // 0 is none, 1 everywhere
  double density = 4.0;             // optical depth where the noise is highest

  bool operator==(const CloudLayer&) const = default;
};

// Returns the share of light, in [0, 1], that passes the layer straight up at a place: x and z in world
// space, metres.
double cloud_transmittance(const CloudLayer& layer, const glm::dvec2& place);

}  // namespace penumbra::scene
