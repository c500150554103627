// A test whether a loop has a constant bound on its iterations. Internal to this folder.
#pragma once

#include <cstddef>
#include <vector>

#include "lint/control_flow.h"
#include "spirv/code.h"

namespace penumbra::lint {

// Returns whether one of the loop's exits compares with a constant. `body` contains the loop's nodes; the
// function belongs to a legalised module. The result may be falsely true: the comparison may be of data and
// not of a counter.
bool has_constant_bound(const spirv::Code& code, const spirv::Function& function, const ControlFlow& flow,
                        const std::vector<bool>& body);

// Returns the nodes of the natural loop with this header; empty if it is not one.
std::vector<bool> loop_body(const ControlFlow& flow, std::size_t header);

}  // namespace penumbra::lint
