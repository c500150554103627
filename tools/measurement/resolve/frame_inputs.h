// The data that a scene's geometry was made into before the first frame (techniques::Need), by the names
// under which shaders read it.
#pragma once

#include <map>
#include <string>

#include "gpu/resources.h"
#include "resolve/uniform_values.h"

namespace penumbra::resolve {

struct FrameInputs {
  std::map<std::string, gpu::Image> images;
  UniformValues uniforms;
};

}  // namespace penumbra::resolve
