// Generates the other stage of a graphics pipeline if only one is given: HLSL that writes or reads exactly
// the given stage's interface.
//
// Drivers link stages: an input that no vertex shader writes is undefined and the code that depends on it is
// removed, an output that no fragment shader reads is removed, too, and constants are propagated across
// stages. So the generated vertex shader passes a separate vertex attribute through every location, and the
// generated fragment shader reads every component of every location.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace penumbra::cost {

// Returns HLSL with the entry point Main. Throws std::invalid_argument when the words are no SPIR-V module or
// its interface is one that shaders::pipeline_interface() refuses.
std::string vertex_stage_for(const std::vector<std::uint32_t>& fragment, const std::string& entry);
std::string fragment_stage_for(const std::vector<std::uint32_t>& vertex, const std::string& entry);

}  // namespace penumbra::cost
