// What a surface looks like: colour, roughness and the textures of both. Only pictures of light read it; no
// shadow depends on it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace penumbra::scene {

// 8 bits a channel as the file stores them, rows from the top. Texture coordinate (0, 0) is the first row's
// first corner, as in glTF, and coordinates outside 0..1 repeat the texture.
struct Texture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

struct Material {
  std::string name = "grey";
  glm::vec3 base_colour{0.5F};   // linear, Rec. 709; multiplies the texture
  float roughness = 0.8F;        // 0 mirror, 1 matt
  int base_colour_texture = -1;  // index into Scene::textures, whose colours are sRGB; -1 is none
  int normal_texture = -1;       // tangent space, +Y up, as glTF has it
  float translucency = 0.0F;  // share of the diffuse light that passes through, as through leaves and cloth
};

}  // namespace penumbra::scene
