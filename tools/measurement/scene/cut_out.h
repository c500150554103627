// The openings of a scene's cut-out surfaces, and the light that blended ones stop. Rays evaluate them here
// (Embree's filter); the rasteriser's shaders (shaders/CutOut.hlsl) compute the same from the tables made
// here. The rasterisers draw nothing of blended surfaces: their cutoff in the tables is one that no alpha
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
  // An entry has eight words, as the shaders read it.
  struct Entry {
    AlphaPattern pattern = AlphaPattern::none;
    std::uint32_t first_texel = 0;
    std::uint32_t width = 0;  // the texture's width; 0 means no texture
    std::uint32_t height = 0;
    TextureWrap wrap_u = TextureWrap::repeat;
    TextureWrap wrap_v = TextureWrap::repeat;
    float factor = 1.0F;
    float cutoff = 0.5F;
  };
  static_assert(sizeof(Entry) == 32);

  // The constructor keeps a reference to the scene's mesh. Throws InputError naming the scene and the
  // material for texture coordinates that are missing, not one per vertex or beyond kLargestTexCoord; for a
  // texture or material that is out of range or lacks some of its texels; and for numbers that are not
  // finite.
  explicit CutOuts(const Scene& scene);

  bool any() const { return !of_triangle_.empty(); }
  bool cuts(std::size_t triangle) const { return any() && of_triangle_[triangle] != 0; }

  bool any_blended() const;
  bool blends(std::size_t triangle) const;

  // Returns the share of light that a triangle of the mesh stops at weights 1 - u - v, u and v of its
  // corners. For a cut-out it is 0 or 1.
  float opacity(std::size_t triangle, float u, float v) const;
  // Returns whether the rasterisers draw nothing there: where a cut-out is open, and everywhere on a blended
  // triangle.
  bool open(std::size_t triangle, float u, float v) const;

  static constexpr std::uint32_t texels_per_word = 4;  // the first in the lowest bits
  const std::vector<std::uint32_t>& of_triangle() const { return of_triangle_; }  // 1 + its entry; 0 for none
  const std::vector<Entry>& entries() const { return entries_; }
  const std::vector<std::uint32_t>& texels() const { return texels_; }

  // Adds everything that affects where surfaces are open; adds nothing if there are no cut-outs.
  friend void add_fields(platform::ContentHash& hash, const CutOuts& cut_outs);

 private:
  std::uint32_t add_entry(const Scene& scene, const Material& material);
  void add_texels(const Texture& texture, TextureChannel channel);
  const Entry& entry_of(std::size_t triangle) const { return entries_[of_triangle_[triangle] - 1]; }
  float alpha(const Entry& entry, std::size_t triangle, float u, float v) const;
  float texel(const Entry& entry, int x, int y) const;
  float texture_alpha(const Entry& entry, const glm::vec2& uv) const;

  const Mesh& mesh_;
  std::vector<std::uint32_t> of_triangle_;  // empty when no triangle is cut out
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> texels_;
  std::uint32_t texel_count_ = 0;
};

// Returns the alpha of the pattern alone, in [0, 1].
float pattern_alpha(AlphaPattern pattern, const glm::vec2& uv);

}  // namespace penumbra::scene
