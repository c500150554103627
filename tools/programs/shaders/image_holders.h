// Where the image comes from that an instruction of SPIR-V accesses. Internal to this folder.
//
// Before legalisation, glslang's modules copy textures into local variables and pass them to functions, and
// structs have textures as members. A holder is what keeps an image: a variable, a parameter that is or
// points to one, or a function that returns one. For a struct or an array, which has one holder, the images
// in it count as one.
#pragma once

#include <vector>

#include "spirv/code.h"

namespace penumbra::shaders {

class ImageHolders {
 public:
  explicit ImageHolders(const spirv::Code& code);

  const std::vector<spirv::Id>& all() const { return all_; }  // by id, rising

  // Returns the holder from which the value or pointer is made, 0 where it is made of no image.
  spirv::Id of(spirv::Id value) const;

 private:
  bool has_image(spirv::Id type) const;

  const spirv::Code& code_;
  std::vector<spirv::Id> all_;
};

}  // namespace penumbra::shaders
