// The garden's materials: several tints of each kind, over textures of stone, plaster, wood and sand.
#pragma once

#include <array>

#include "scene/mesh_builder.h"

namespace penumbra::scene::garden {

struct Palette {
  explicit Palette(MeshBuilder& mesh);  // adds the textures to it

  std::array<Material, 7> wall_stone;
  Material mortar;
  Material coping;
  std::array<Material, 5> flagstone;
  Material sand;
  std::array<Material, 4> pebble;
  Material plaster;
  Material trim;  // dressed stone about the door and windows
  std::array<Material, 3> table_wood;
  std::array<Material, 2> grey_wood;
  Material bark;
  std::array<Material, 3> terracotta;
  Material soil;
  Material turf;
  std::array<Material, 4> grass;
};

}  // namespace penumbra::scene::garden
