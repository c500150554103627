// The formats that a graph's textures may have, by the names that gpu/format.h gives them, and the APIs whose
// compute shaders can write them.
#pragma once

#include <span>
#include <string_view>

namespace penumbra::techniques {

struct TexelFormat {
  std::string_view name;
  std::string_view unity;     // name in UnityEngine.Experimental.Rendering.GraphicsFormat
  int bytes = 0;              // bytes of a texel, padded as devices pad it
  bool depth = false;         // a target of casters alone
  bool essl_storage = false;  // one of the image formats of OpenGL ES 3.1, section 8.5
  bool stencil = false;       // 8 bits of stencil beside the depth
};

std::span<const TexelFormat> texel_formats();
const TexelFormat* find_texel_format(std::string_view name);  // null if there is none

}  // namespace penumbra::techniques
