// The reads of a graph's passes, and the order that follows from them. Internal to this folder.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "techniques/pass_graph.h"

namespace penumbra::techniques {

bool reads(const PassGraph& graph, const GraphPass& pass, const std::string& name);

// Returns whether `later` has to wait for `earlier`: it reads or changes what `earlier` writes, or makes the
// mip levels of it.
bool waits_for(const PassGraph& graph, const GraphPass& later, const GraphPass& earlier);

// Returns for each pass the numbers of those that it waits for, rising. Only passes that write what it needs
// are examined.
std::vector<std::vector<std::size_t>> awaited_passes(const PassGraph& graph);

}  // namespace penumbra::techniques
