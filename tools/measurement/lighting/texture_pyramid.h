// A texture with its smaller versions, read through a footprint: three linear numbers per texel.
//
// Each level is the mean of 2 x 2 texels of the one above (odd sides repeat their last texel); colours are
// averaged in linear light, normals as vectors. Reads are trilinear, coordinates repeat. Reentrant.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/material.h"

namespace penumbra::lighting {

enum class TexelMeaning { srgb_colour, vector };  // vector: 0..255 stand for -1..1

class TexturePyramid {
 public:
  // Throws InputError for a texture whose texels are not width x height.
  TexturePyramid(const scene::Texture& texture, TexelMeaning meaning);

  // footprint_uv is the length that the pixel covers, in units of the texture.
  glm::vec3 read(const glm::vec2& uv, float footprint_uv) const;
  glm::vec3 mean() const { return levels_.back().texels.front(); }

 private:
  struct Level {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> texels;

    glm::vec3 read(const glm::vec2& uv) const;
  };
  static Level halved(const Level& level);

  std::vector<Level> levels_;  // the last is one texel
};

}  // namespace penumbra::lighting
