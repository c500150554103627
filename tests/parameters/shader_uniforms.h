// The uniforms that Shadows.hlsl and HDRP's shadow filter derive from user settings. Parameters that filters
// use unchanged are packed by techniques/parameter_packing.h.
//
// Units: degrees, metres, texels as named. Whatever the settings contain, every component is finite and in
// the range of the shaders: NaN becomes the lower end of the range. Source: ShaderLibrary/Shadows.hlsl and
// Pipelines/Urp.hlsl; for HDRP its request settings of a directional light's PCSS, version 17.
#pragma once

#include <glm/vec4.hpp>

#include "parameters/cascades.h"

namespace penumbra::parameters {

struct SoftShadowParameters {
  double angular_diameter_degrees = 0.53;
  int blocker_samples = 24;
  int filter_samples = 16;
  double blocker_clump = 0.0;
  double min_filter_texels = 1.25;
  double max_penumbra_metres = 100.0;
  double max_sampling_metres = 1000.0;
  double search_radius_metres = 0.5;    // for classic PCSS
  double hdrp_search_degrees = 12.0;    // the light's angle if that is larger
  double hdrp_min_filter_degrees = 10;  // the search's angle if that is larger
};

struct ShaderUniforms {
  glm::dvec4 atlas_texel_size;   // 1/width, 1/height, width, height
  glm::dvec4 main_light_params;  // cascade count, tan(a/2), frame index modulo 64, 0
  glm::dvec2 hdrp_tan_half;      // for HDRP's blocker search and the cone of its smallest filter
};

ShaderUniforms shader_uniforms(const SoftShadowParameters& parameters, const AtlasLayout& layout,
                               int cascades, int frame_index);

// These convert an angle in degrees to tan(a/2), and back.
double tan_half_of(double degrees);
double degrees_of(double tan_half);

// HDRP's two vectors of a cascade, with s = |m00 / m22| of the device projection, twice the geometric scale.
// params0 has tan(a/2) s, its inverse, the farthest blocker (m) and the cone's height (m). params1 has the
// smallest filter (texels), 1 / (s tan) of the smallest filter's and of the search's cone, and half the
// clump. At 0 degrees the inverse is 0 and the farthest blocker is the cascade's depth range away.
struct HdrpVectors {
  glm::dvec4 params0;
  glm::dvec4 params1;
};
HdrpVectors hdrp_vectors(const Cascade& cascade, const SoftShadowParameters& parameters);

}  // namespace penumbra::parameters
