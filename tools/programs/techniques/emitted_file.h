// A text that is made from the manifests and checked in.
#pragma once

#include <string>

namespace penumbra::techniques {

struct EmittedFile {
  std::string file;  // path relative to the package's folder
  std::string text;
};

}  // namespace penumbra::techniques
