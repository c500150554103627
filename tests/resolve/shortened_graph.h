// Shortens a graph by its last passes, for what the earlier ones leave behind, or puts a kernel of the tests
// in their place.
#pragma once

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "techniques/pass_graph.h"

namespace penumbra::resolve {

inline void remove_passes_after(techniques::PassGraph& graph, const std::string& pass) {
  const auto last = std::find_if(graph.passes.begin(), graph.passes.end(),
                                 [&pass](const techniques::GraphPass& one) { return one.name == pass; });
  if (last == graph.passes.end()) throw std::logic_error("there is no pass '" + pass + "'");
  graph.passes.erase(last + 1, graph.passes.end());
}

// The path of a file of tests/resolve/samples, in the generic form that manifests have.
inline std::string sample_file(const std::string& name) {
  return (std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests/resolve/samples" / name).generic_string();
}

// A kernel of samples/RingsByTextures.compute with a thread for each pixel. like is a pass of Cell PCSS,
// whose parameters it has.
inline techniques::GraphPass rings_by_textures(const techniques::GraphPass& like, const std::string& kernel) {
  techniques::GraphPass pass = like;
  pass.name = pass.program = kernel;
  pass.file = sample_file("RingsByTextures.compute");
  pass.reads = {{"_PenumbraBlockPlanes", "depthPlanes"},
                {"_PenumbraBlockSpreads", "depthSpreads"},
                {"_PenumbraCoarsePlanes", "coarsePlanes"},
                {"_PenumbraCoarseSpreads", "coarseSpreads"}};
  pass.writes = {{"_PenumbraVisibility", "visibility"}};
  pass.updates.clear();
  pass.groups = {};
  pass.groups.texels_of = "visibility";
  return pass;
}

}  // namespace penumbra::resolve
