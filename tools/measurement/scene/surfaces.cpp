#include "scene/surfaces.h"

#include <array>

namespace penumbra::scene::surfaces {
namespace {

struct Named {
  const char* name;
  glm::vec3 colour;
};

Material made(const Named& named, float roughness, float translucency = 0.0F) {
  Material material;
  material.name = named.name;
  material.base_colour = named.colour;
  material.roughness = roughness;
  material.translucency = translucency;
  return material;
}

template <std::size_t N>
const Named& chosen(const std::array<Named, N>& tints, int tint) {
  return tints[static_cast<std::size_t>(tint) % N];
}

}  // namespace

Material concrete() {
  return made({"concrete", {0.40F, 0.39F, 0.36F}}, 0.9F);
}
Material asphalt() {
  return made({"asphalt", {0.10F, 0.10F, 0.105F}}, 0.9F);
}
Material lawn() {
  return made({"lawn", {0.13F, 0.20F, 0.06F}}, 1.0F);
}
Material earth() {
  return made({"earth", {0.27F, 0.20F, 0.13F}}, 1.0F);
}
Material sandstone() {
  return made({"sandstone", {0.52F, 0.42F, 0.29F}}, 0.9F);
}
Material marble() {
  return made({"marble", {0.70F, 0.66F, 0.58F}}, 0.6F);
}
Material terracotta() {
  return made({"terracotta", {0.48F, 0.20F, 0.10F}}, 0.85F);
}
Material roof_tile() {
  return made({"roof tile", {0.36F, 0.13F, 0.08F}}, 0.85F);
}
Material wood() {
  return made({"wood", {0.34F, 0.21F, 0.11F}}, 0.75F);
}
Material bark() {
  return made({"bark", {0.16F, 0.12F, 0.085F}}, 0.95F);
}
Material galvanised_steel() {
  return made({"galvanised steel", {0.30F, 0.31F, 0.32F}}, 0.4F);
}
Material painted_iron() {
  return made({"painted iron", {0.05F, 0.075F, 0.065F}}, 0.45F);
}
Material dark_glass() {
  return made({"dark glass", {0.03F, 0.04F, 0.05F}}, 0.1F);
}
Material rubber() {
  return made({"rubber", {0.025F, 0.025F, 0.025F}}, 0.9F);
}

Material plaster(int tint) {
  static constexpr std::array tints{
      Named{"cream plaster", {0.66F, 0.57F, 0.41F}}, Named{"ochre plaster", {0.58F, 0.38F, 0.17F}},
      Named{"rose plaster", {0.60F, 0.38F, 0.30F}}, Named{"pale blue plaster", {0.42F, 0.51F, 0.57F}},
      Named{"white plaster", {0.75F, 0.73F, 0.69F}}};
  return made(chosen(tints, tint), 0.9F);
}

Material leaf(int tint) {
  static constexpr std::array tints{
      Named{"green leaf", {0.11F, 0.22F, 0.045F}}, Named{"light leaf", {0.17F, 0.29F, 0.06F}},
      Named{"dark leaf", {0.07F, 0.16F, 0.04F}}, Named{"yellow leaf", {0.24F, 0.30F, 0.07F}}};
  return made(chosen(tints, tint), 0.6F, 0.35F);
}

Material cloth(int tint) {
  static constexpr std::array tints{
      Named{"red cloth", {0.52F, 0.075F, 0.05F}}, Named{"white cloth", {0.76F, 0.73F, 0.66F}},
      Named{"green cloth", {0.06F, 0.22F, 0.12F}}, Named{"navy cloth", {0.05F, 0.08F, 0.22F}}};
  return made(chosen(tints, tint), 0.95F, 0.2F);
}

Material car_paint(int tint) {
  static constexpr std::array tints{
      Named{"red paint", {0.42F, 0.03F, 0.03F}}, Named{"grey paint", {0.25F, 0.26F, 0.28F}},
      Named{"blue paint", {0.04F, 0.11F, 0.30F}}, Named{"white paint", {0.72F, 0.72F, 0.70F}}};
  return made(chosen(tints, tint), 0.25F);
}

Material painted_wood(int tint) {
  static constexpr std::array tints{
      Named{"blue wood", {0.10F, 0.25F, 0.45F}},  Named{"yellow wood", {0.70F, 0.46F, 0.09F}},
      Named{"red wood", {0.50F, 0.09F, 0.06F}},   Named{"white wood", {0.70F, 0.68F, 0.62F}},
      Named{"green wood", {0.12F, 0.32F, 0.14F}}, Named{"orange wood", {0.62F, 0.26F, 0.07F}}};
  return made(chosen(tints, tint), 0.6F);
}

}  // namespace penumbra::scene::surfaces
