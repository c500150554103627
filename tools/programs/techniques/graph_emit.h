// The graphs of the manifests as C#, from which the renderer feature runs them: Runtime/Techniques has one
// file for each manifest with graphs, NAMEGraphs.cs. Graphs with a stencil are left out, because the feature
// does not draw them.
#pragma once

#include <vector>

#include "techniques/emitted_file.h"
#include "techniques/technique_list.h"

namespace penumbra::techniques {

// Throws InputError where C# has one name for two graphs of a manifest.
std::vector<EmittedFile> emit_graphs_csharp(const TechniqueList& list);

// Returns the C# name of the technique's graph: VarianceGraphs.Variance32.
std::string csharp_graph_of(const Technique& technique);

}  // namespace penumbra::techniques
