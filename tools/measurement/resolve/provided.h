// The resource a shader asks for by name. Internal to this folder.
#pragma once

#include <string>

#include "input/input_error.h"
#include "shaders/reflect.h"

namespace penumbra::resolve {

// Throws InputError with the names that are provided when this one is not. `where` is the shader, or the line
// that names the resource; `remedy` says how the user can provide it.
template <typename Map>
const auto& provided(const Map& map, const shaders::Resource& resource, const std::string& where,
                     const char* kind, const std::string& remedy = "") {
  const auto found = map.find(resource.name);
  if (found != map.end()) return *found->second;
  std::string known;
  for (const auto& entry : map) known += " " + entry.first;
  throw InputError(
      where,
      std::string("reads the ") + kind + " '" + resource.name + "', which the harness does not provide",
      (remedy.empty() ? "" : remedy + "; ") + "provided are:" + known);
}

}  // namespace penumbra::resolve
