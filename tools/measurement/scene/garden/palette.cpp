#include "scene/garden/pieces.h"

#include <string>

#include "scene/patterns.h"

namespace penumbra::scene::garden {
namespace {

constexpr int kTextureSize = 512;

struct Surface {
  int colour = -1;
  int normal = -1;
};

struct Look {
  double slope;    // slope of the relief in the normal map
  glm::vec3 dark;  // factor on the base colour where the relief is deep
  glm::vec3 light;
};

Surface made(MeshBuilder& mesh, const Grain& grain, const Look& look) {
  const Relief relief = fractal_relief(kTextureSize, grain);
  return {mesh.add_texture(tinted(relief, look.dark, look.light)),
          mesh.add_texture(normals_of(relief, look.slope))};
}

Material painted(const std::string& name, const glm::vec3& colour, const Surface& surface,
                 float roughness = 0.9F) {
  Material material;
  material.name = name;
  material.base_colour = colour;
  material.roughness = roughness;
  material.base_colour_texture = surface.colour;
  material.normal_texture = surface.normal;
  return material;
}

// Returns one material for every tint, named kind 1, kind 2 and so on.
template <std::size_t N>
std::array<Material, N> tints(const std::string& kind, const std::array<glm::vec3, N>& colours,
                              const Surface& surface, float roughness = 0.9F) {
  std::array<Material, N> materials;
  for (std::size_t i = 0; i < N; ++i) {
    materials[i] = painted(kind + " " + std::to_string(i + 1), colours[i], surface, roughness);
  }
  return materials;
}

}  // namespace

Palette::Palette(MeshBuilder& mesh) {
  const Surface stone =
      made(mesh, {.cells_x = 5, .cells_y = 5, .octaves = 7, .persistence = 0.62, .seed = 11},
           {0.020, {0.62F, 0.60F, 0.57F}, {1.0F, 1.0F, 1.0F}});
  const Surface render =
      made(mesh, {.cells_x = 3, .cells_y = 3, .octaves = 8, .persistence = 0.55, .seed = 23},
           {0.008, {0.80F, 0.77F, 0.72F}, {1.0F, 1.0F, 1.0F}});
  const Surface grain =
      made(mesh, {.cells_x = 2, .cells_y = 48, .octaves = 4, .persistence = 0.6, .seed = 37},
           {0.004, {0.52F, 0.48F, 0.42F}, {1.0F, 1.0F, 1.0F}});
  const Surface rough =
      made(mesh, {.cells_x = 16, .cells_y = 16, .octaves = 5, .persistence = 0.75, .seed = 41},
           {0.030, {0.45F, 0.42F, 0.38F}, {1.0F, 1.0F, 1.0F}});
  const Surface furrows =
      made(mesh, {.cells_x = 3, .cells_y = 20, .octaves = 5, .persistence = 0.6, .seed = 53},
           {0.050, {0.45F, 0.42F, 0.40F}, {1.0F, 1.0F, 1.0F}});
  wall_stone = tints<7>("wall stone",
                        {{{0.58F, 0.48F, 0.35F},
                          {0.50F, 0.41F, 0.29F},
                          {0.63F, 0.55F, 0.43F},
                          {0.46F, 0.38F, 0.28F},
                          {0.56F, 0.43F, 0.27F},
                          {0.40F, 0.37F, 0.34F},
                          {0.65F, 0.56F, 0.41F}}},
                        stone);
  mortar = painted("mortar", {0.46F, 0.41F, 0.33F}, rough);
  coping = painted("coping", {0.60F, 0.55F, 0.46F}, stone);
  flagstone = tints<5>("flagstone",
                       {{{0.54F, 0.48F, 0.39F},
                         {0.46F, 0.42F, 0.36F},
                         {0.59F, 0.51F, 0.41F},
                         {0.42F, 0.40F, 0.36F},
                         {0.54F, 0.47F, 0.36F}}},
                       stone, 0.8F);
  sand = painted("sand", {0.42F, 0.34F, 0.24F}, rough, 1.0F);
  pebble =
      tints<4>("pebble",
               {{{0.55F, 0.51F, 0.45F}, {0.42F, 0.40F, 0.38F}, {0.62F, 0.55F, 0.45F}, {0.36F, 0.33F, 0.30F}}},
               {}, 0.7F);
  plaster = painted("garden plaster", {0.72F, 0.56F, 0.36F}, render, 0.95F);
  trim = painted("trim", {0.66F, 0.61F, 0.53F}, stone);
  table_wood = tints<3>("table wood", {{{0.44F, 0.26F, 0.13F}, {0.50F, 0.31F, 0.16F}, {0.39F, 0.22F, 0.11F}}},
                        grain, 0.6F);
  grey_wood = tints<2>("grey wood", {{{0.42F, 0.37F, 0.31F}, {0.36F, 0.32F, 0.27F}}}, grain, 0.8F);
  bark = painted("garden bark", {0.26F, 0.20F, 0.15F}, furrows, 1.0F);
  terracotta =
      tints<3>("garden terracotta", {{{0.58F, 0.25F, 0.13F}, {0.52F, 0.22F, 0.12F}, {0.62F, 0.31F, 0.18F}}},
               render, 0.85F);
  soil = painted("soil", {0.13F, 0.09F, 0.06F}, rough, 1.0F);
  turf = painted("turf", {0.16F, 0.19F, 0.07F}, rough, 1.0F);
  grass = tints<4>(
      "grass",
      {{{0.14F, 0.24F, 0.05F}, {0.19F, 0.30F, 0.07F}, {0.11F, 0.20F, 0.045F}, {0.27F, 0.31F, 0.10F}}}, {},
      0.7F);
  for (Material& blade : grass) blade.translucency = 0.3F;
}

}  // namespace penumbra::scene::garden
