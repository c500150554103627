// Rule interpolated-cascade: a fragment program reads a value that a vertex program calculated from the
// cascade which URP's TransformWorldToShadowCoord() chose for the vertex.
//
// Cascades have places of their own in the shadow map; URP itself passes the coordinate between stages only
// where there is one cascade (REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR of its Shadows.hlsl).
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/token_place.h"

namespace penumbra::lint {

// Returns the locations of the outputs that depend on the cascade of the vertex, and not on a shadow map that
// is sampled: those are light and no coordinates. `spirv` is an optimised vertex program with its names.
// Throws std::invalid_argument for words that are not SPIR-V.
std::set<std::uint32_t> outputs_of_cascade(const std::vector<std::uint32_t>& spirv);

// The finding, at the input that reads the output of this vertex program.
hlsl::Diagnostic interpolated_cascade_finding(const hlsl::TokenPlace& place, const std::string& semantic,
                                              const std::string& vertex_program);

}  // namespace penumbra::lint
