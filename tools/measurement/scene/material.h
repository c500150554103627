// The appearance of a surface: colour, roughness and their textures, which only lit pictures use; and its
// alpha, which affects shadows.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace penumbra::scene {

// The texture has 8 bits a channel as the file stores them, rows from the top. Texture coordinate (0, 0) is
// the first row's first corner, as in glTF. Coordinates outside 0..1 repeat the texture, unless a cut-out
// states another rule.
struct Texture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

// Alpha by a formula: one shape per unit square of texture coordinates, repeated. It is clamped to 0..1;
// lengths are in those coordinates.
enum class AlphaPattern : std::uint32_t {
  none,       // 1
  wire_grid,  // 1 - 8 d, d to the nearest edge of the square: at a cutoff of 1/2 wires 1/8 wide, 49/64 open
  leaf,       // 1/2 + 4 (u (1 - u) - |v - 1/2|): pointed at u = 0 and 1; at a cutoff of 1/2, 2/3 open
  holes,      // 1/2 + 4 (d - 3/8), d to the square's centre: at a cutoff of 1/2 round holes, 9 pi / 64 open
  wire,       // 1/2 + 24 (1/6 - |v - 1/2|): a wire along u, of the middle third of v; its mean is 1/3
  smoke,      // 0.6 (1 - 4 d^2)^2, d to the square's centre, 0 from d = 1/2: a puff; its mean is pi / 20
};

enum class TextureWrap : std::uint32_t { repeat, mirror, clamp };  // the rule for coordinates outside 0..1
enum class TextureChannel : std::uint32_t { red, alpha };

// The meaning of a surface's alpha.
enum class AlphaMode : std::uint32_t {
  cut,      // open below the cutoff, else solid
  blended,  // transmits 1 - alpha of the light
};

// Alpha of a surface: factor * alpha of the pattern * alpha of the texture.
// Cut out, it is open, for light and for the camera, where its alpha is below the cutoff. Blended, it stops
// that share of each ray's light, and neither the shadow map nor the camera's depth has it: as in Unity,
// where transparent objects write neither.
// The texture is read bilinearly and without smaller versions, whatever the distance: one silhouette for the
// shadow map, the camera and the rays.
struct CutOut {
  AlphaPattern pattern = AlphaPattern::none;
  int texture = -1;  // index into Scene::textures; -1 means none, with alpha 1
  TextureChannel channel = TextureChannel::alpha;
  TextureWrap wrap_u = TextureWrap::repeat;
  TextureWrap wrap_v = TextureWrap::repeat;
  float factor = 1.0F;
  float cutoff = 0.5F;  // used with AlphaMode::cut
  AlphaMode mode = AlphaMode::cut;

  bool reads_coordinates() const { return pattern != AlphaPattern::none || texture >= 0; }
  bool operator==(const CutOut&) const = default;
};

struct Material {
  std::string name = "grey";
  glm::vec3 base_colour{0.5F};   // linear, Rec. 709; multiplies the texture
  float roughness = 0.8F;        // 0 mirror, 1 matt
  int base_colour_texture = -1;  // index into Scene::textures, whose colours are sRGB; -1 means none
  int normal_texture = -1;       // tangent space, +Y up, as glTF has it
  float translucency = 0.0F;  // share of the diffuse light that passes through, as through leaves and cloth
  std::optional<CutOut> cut_out{};
};

}  // namespace penumbra::scene
