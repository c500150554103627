// Where a scene's cut-out surfaces are open and how much light blended ones stop: one evaluation for rays
// (Embree's filter), and the tables with which the rasteriser's shaders (shaders/CutOut.hlsl) compute the
// same. The rasterisers draw nothing of blended surfaces: their cutoff in the tables is one that no alpha
// reaches.
//
// The formulas are those of AlphaPattern and CutOut (material.h), in single precision, operation by operation
// the same here and in HLSL: both see the same silhouette, up to the rounding of interpolated texture
// coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "scene/scene.h"

namespace penumbra::platform {
class ContentHash;
}

namespace penumbra::scene {

inline constexpr float kLargestTexCoord =
    1e6F;  // beyond it, a float cannot resolve the texels of a repeated texture

class CutOuts {
 public:
  // As the shaders read it: eight words.
  struct Entry {
    AlphaPattern pattern = AlphaPattern::none;
    std::uint32_t first_texel = 0;
    std::uint32_t width = 0;  // of the texture; 0 is none
    std::uint32_t height = 0;
    TextureWrap wrap_u = TextureWrap::repeat;
    TextureWrap wrap_v = TextureWrap::repeat;
    float factor = 1.0F;
    float cutoff = 0.5F;
  };
  static_assert(sizeof(Entry) == 32);

  // Keeps a reference to the scene's mesh. Throws InputError naming the scene and the material: texture
  // coordinates that are missing, not one per vertex or beyond kLargestTexCoord, a texture or material out of
  // range or without all of its texels, numbers that are not finite.
  explicit CutOuts(const Scene& scene);

  bool any() const { return !of_triangle_.empty(); }
  bool cuts(std::size_t triangle) const { return any() && of_triangle_[triangle] != 0; }

  bool any_blended() const;
  bool blends(std::size_t triangle) const;

  // Share of the light that a triangle of the mesh stops at weights 1 - u - v, u and v of its corners: 0 or 1
  // of a cut-out.
  float opacity(std::size_t triangle, float u, float v) const;
  // Whether the rasterisers draw nothing there: where a cut-out is open, and all of a blended triangle.
  bool open(std::size_t triangle, float u, float v) const;

  static constexpr std::uint32_t texels_per_word = 4;  // the first in the lowest bits
  const std::vector<std::uint32_t>& of_triangle() const { return of_triangle_; }  // 1 + its entry; 0: none
  const std::vector<Entry>& entries() const { return entries_; }
  const std::vector<std::uint32_t>& texels() const { return texels_; }

  // Adds everything that affects where surfaces are open; nothing if there are no cut-outs.
  void add_to(platform::ContentHash& hash) const;

 private:
  std::uint32_t add_entry(const Scene& scene, const Material& material);
  void add_texels(const Texture& texture, TextureChannel channel);
  const Entry& entry_of(std::size_t triangle) const { return entries_[of_triangle_[triangle] - 1]; }
  float alpha(const Entry& entry, std::size_t triangle, float u, float v) const;
  float texel(const Entry& entry, int x, int y) const;
  float texture_alpha(const Entry& entry, const glm::vec2& uv) const;

  const Mesh& mesh_;
  std::vector<std::uint32_t> of_triangle_;  // none at all when no triangle is cut out
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> texels_;
  std::uint32_t texel_count_ = 0;
};

// Alpha of the pattern alone, in [0, 1].
float pattern_alpha(AlphaPattern pattern, const glm::vec2& uv);

}  // namespace penumbra::scene
