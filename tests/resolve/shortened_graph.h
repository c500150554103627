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

// Tiled PCSS's graph ends in the class of each pixel's tile: 1 lit, 0 dark, -1 not decided.
inline void show_tile_classes(techniques::PassGraph& graph) {
  remove_passes_after(graph, "DecideTiles");
  techniques::GraphPass& classes = graph.passes.emplace_back(graph.passes.back());
  classes.name = classes.program = "TileClasses";
  classes.file = sample_file("TileClasses.compute");
  classes.reads = {{"_PenumbraTiles", "tiles"}};
  classes.writes = {{"_PenumbraVisibility", "visibility"}};
  classes.groups = {};
  classes.groups.texels_of = "visibility";
}

}  // namespace penumbra::resolve
