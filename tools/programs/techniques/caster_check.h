// Checks of passes that draw the casters, or use the content that they left in a stencil. Internal to this
// folder.
#pragma once

#include "techniques/pass_graph.h"

namespace penumbra::techniques {

bool same_extent(const GraphTexture& a, const GraphTexture& b);
bool in_cascades(const GraphTexture& texture);

// Returns whether any pass draws with that texture as its depth.
bool is_depth(const PassGraph& graph, const std::string& name);

// Refuses targets that nothing is drawn into from the light or the camera, the frequency that belongs to
// each, and a depth target that does not fit them.
void check_casters(const PassGraph& graph, const GraphPass& pass);

// Refuses a stencil that the pass's texture does not have, or that is of another size or time than the pass.
void check_stencil(const PassGraph& graph, const GraphPass& pass);

// Refuses textures of a depth format that a pass writes as anything but its depth.
void refuse_misused_depth(const PassGraph& graph);

}  // namespace penumbra::techniques
