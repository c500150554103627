// A graph without its last passes, for what the earlier ones leave behind.
#pragma once

#include <algorithm>
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

}  // namespace penumbra::resolve
