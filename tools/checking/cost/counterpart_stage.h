// The other stage of a graphics pipeline when only one is given: HLSL that passes on, or takes up, exactly
// what the given one needs.
//
// Drivers link stages: an input that no vertex shader writes is undefined and everything computed from it
// goes, an output that no fragment shader reads goes too, and a constant is carried over the border. So the
// vertex shader made here passes a vertex attribute of its own through every location, and the fragment
// shader made here reads every component of every location.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace penumbra::cost {

// HLSL with entry point Main. Throws std::invalid_argument when the words are no SPIR-V module or its
// interface is one that shaders::pipeline_interface() refuses.
std::string vertex_stage_for(const std::vector<std::uint32_t>& fragment, const std::string& entry);
std::string fragment_stage_for(const std::vector<std::uint32_t>& vertex, const std::string& entry);

}  // namespace penumbra::cost
