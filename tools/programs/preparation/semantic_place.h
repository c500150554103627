// The place where a source declares a semantic of its entry point.
#pragma once

#include <string>

namespace penumbra::preparation {

struct SemanticPlace {
  std::string semantic;  // the semantic as written
  bool output = false;
  std::string file;
  int line = 0;
};

}  // namespace penumbra::preparation
