// Whether a compiler can know how often a loop runs at most. Internal to this room.
#pragma once

#include <cstddef>
#include <vector>

#include "lint/control_flow.h"
#include "spirv/code.h"

namespace penumbra::lint {

// One of the loop's ways out compares with a constant. `body` holds the loop's nodes; the function belongs to
// a legalised module. Errs towards true: the comparison may be of data and not of a counter.
bool has_constant_bound(const spirv::Code& code, const spirv::Function& function, const ControlFlow& flow,
                        const std::vector<bool>& body);

// The nodes of the natural loop with this header; empty when it is none.
std::vector<bool> loop_body(const ControlFlow& flow, std::size_t header);

}  // namespace penumbra::lint
