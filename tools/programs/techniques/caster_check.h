// Checks of passes that draw the casters, or use the content that they left in a stencil. Internal to this
// folder.
#pragma once

#include <optional>
#include <string>

#include "techniques/pass_graph.h"

namespace penumbra::techniques {

using Found = std::optional<GraphProblem>;

bool same_extent(const GraphTexture& a, const GraphTexture& b);
bool in_cascades(const GraphTexture& texture);

// Returns whether any pass draws with that texture as its depth.
bool is_depth(const PassGraph& graph, const std::string& name);

// Finds targets that nothing is drawn into from the light or the camera, a frequency that does not belong to
// them, and a depth target that does not fit them.
Found wrong_casters(const PassGraph& graph, const GraphPass& pass);

// Finds a stencil that the pass's texture does not have, or that is of another size or time than the pass.
Found wrong_stencil(const PassGraph& graph, const GraphPass& pass);

// Finds textures of a depth format that a pass writes as anything but its depth.
Found misused_depth(const PassGraph& graph);

}  // namespace penumbra::techniques
