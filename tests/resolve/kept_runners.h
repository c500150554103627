// Graphs of the library's techniques, and runners that a test keeps, because their pipelines cost more than
// running them.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "resolve/graph_runner.h"
#include "resolve/test_device.h"

namespace penumbra::resolve {

inline ShadowGraph library_graph(const std::string& technique, bool reversed_z) {
  const techniques::TechniqueList& list = library_techniques();
  return technique_graph(list, list.find(technique), Taps::as_listed, reversed_z);
}

class KeptRunners {
 public:
  // The runner of what `make_graph()` gives when the name is asked for first.
  template <typename MakeGraph>
  GraphRunner& of(const std::string& name, bool reversed_z, const MakeGraph& make_graph) {
    std::unique_ptr<GraphRunner>& runner = (*runners_)[{name, reversed_z}];
    if (runner == nullptr) runner = std::make_unique<GraphRunner>(test_device(), compile(make_graph()));
    return *runner;
  }

 private:
  KeptOnDevice<std::map<std::pair<std::string, bool>, std::unique_ptr<GraphRunner>>> runners_;
};

// Names the cases of a suite that runs in both directions of depth.
inline std::string direction_name(const testing::TestParamInfo<bool>& reversed_z) {
  return reversed_z.param ? "Reversed" : "Conventional";
}

}  // namespace penumbra::resolve
