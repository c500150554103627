// Replaces the filter of a technique by a probe: what it returns is read back in place of visibility.
#pragma once

#include <string>

#include "resolve/kept_runners.h"

namespace penumbra::resolve {

// The graph of a library technique with `body` in place of its filter: HLSL that may use the graph's
// textures, `receiver` and `tile`, and returns a float.
inline ShadowGraph probe_graph(const std::string& technique, const std::string& body,
                               bool reversed_z = true) {
  ShadowGraph graph = library_graph(technique, reversed_z);
  std::string& text = graph.filter->body;
  text.resize(text.find("float ResolveTechnique("));
  text += "float ResolveTechnique(ShadowReceiver receiver, ShadowTile tile, int cascade)\n{\n" + body + "}\n";
  return graph;
}

}  // namespace penumbra::resolve
