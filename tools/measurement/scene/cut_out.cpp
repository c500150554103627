#include "scene/cut_out.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "input/input_error.h"
#include "platform/content_hash.h"

namespace penumbra::scene {
namespace {

[[noreturn]] void refuse(const Scene& scene, const std::string& problem) {
  throw InputError("", "scene '" + scene.name + "': " + problem);
}

bool has_cut_outs(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& material) { return material.cut_out.has_value(); });
}

void check_mesh(const Scene& scene) {
  const Mesh& mesh = scene.mesh;
  if (!mesh.triangle_materials.empty() && mesh.triangle_materials.size() != mesh.triangle_count()) {
    refuse(scene, "must have one material per triangle");
  }
  for (const std::uint16_t material : mesh.triangle_materials) {
    if (material >= scene.materials.size())
      refuse(scene, "has a triangle with a material index out of range");
  }
}

void check(const Scene& scene, const Material& material) {
  const CutOut& cut_out = *material.cut_out;
  const std::string name = "material '" + material.name + "' has a cut-out ";
  if (!std::isfinite(cut_out.factor) || !std::isfinite(cut_out.cutoff)) {
    refuse(scene, name + "whose factor or cutoff is not finite");
  }
  if (cut_out.reads_coordinates() && scene.mesh.uvs.size() != scene.mesh.positions.size()) {
    refuse(scene, name + "but the mesh does not have one texture coordinate per vertex");
  }
  const bool usable = std::all_of(scene.mesh.uvs.begin(), scene.mesh.uvs.end(), [](const glm::vec2& uv) {
    return std::abs(uv.x) <= kLargestTexCoord && std::abs(uv.y) <= kLargestTexCoord;
  });
  if (cut_out.reads_coordinates() && !usable) {
    refuse(scene, name + "but a texture coordinate is not finite or exceeds a million");
  }
  if (cut_out.texture < 0) return;
  if (static_cast<std::size_t>(cut_out.texture) >= scene.textures.size()) {
    refuse(scene, name + "with a texture index out of range");
  }
  const Texture& texture = scene.textures[static_cast<std::size_t>(cut_out.texture)];
  const bool whole = texture.width > 0 && texture.height > 0 &&
                     texture.rgba.size() == std::size_t{4} * static_cast<std::size_t>(texture.width) *
                                                static_cast<std::size_t>(texture.height);
  if (!whole) refuse(scene, name + "whose texture lacks texels");
}

// No alpha is as large, so blended surfaces are open for the rasterisers.
constexpr float kBlendedCutoff = std::numeric_limits<float>::infinity();

bool is_blended(const CutOuts::Entry& entry) {
  return entry.cutoff == kBlendedCutoff;
}

float wrapped(float coordinate, TextureWrap wrap) {
  if (wrap == TextureWrap::clamp) return std::clamp(coordinate, 0.0F, 1.0F);
  if (wrap == TextureWrap::repeat) return coordinate - std::floor(coordinate);
  const float both = coordinate - 2.0F * std::floor(0.5F * coordinate);
  return both > 1.0F ? 2.0F - both : both;
}

int neighbour(int texel, int size, TextureWrap wrap) {
  if (wrap == TextureWrap::repeat) return (texel + size) % size;
  return std::clamp(texel, 0, size - 1);
}

float unclamped_alpha(AlphaPattern pattern, const glm::vec2& in_square) {
  const glm::vec2 from_centre = glm::abs(in_square - 0.5F);
  switch (pattern) {
    case AlphaPattern::wire_grid:
      return 1.0F - 8.0F * (0.5F - std::max(from_centre.x, from_centre.y));
    case AlphaPattern::leaf:
      return 0.5F + 4.0F * (in_square.x * (1.0F - in_square.x) - from_centre.y);
    case AlphaPattern::holes:
      return 0.5F + 4.0F * (glm::length(from_centre) - 0.375F);
    case AlphaPattern::wire:
      return 0.5F + 24.0F * (1.0F / 6.0F - from_centre.y);
    case AlphaPattern::smoke: {
      const float inside = std::max(1.0F - 4.0F * glm::dot(from_centre, from_centre), 0.0F);
      return 0.6F * inside * inside;
    }
    case AlphaPattern::none:
      break;
  }
  return 1.0F;
}

}  // namespace

float pattern_alpha(AlphaPattern pattern, const glm::vec2& uv) {
  return std::clamp(unclamped_alpha(pattern, uv - glm::floor(uv)), 0.0F, 1.0F);
}

CutOuts::CutOuts(const Scene& scene) : mesh_(scene.mesh) {
  if (!has_cut_outs(scene)) return;
  check_mesh(scene);
  std::vector<std::uint32_t> of_material(scene.materials.size(), 0);
  std::vector<std::uint32_t> of_triangle(mesh_.triangle_count(), 0);
  for (std::size_t triangle = 0; triangle < of_triangle.size(); ++triangle) {
    const std::size_t index = mesh_.material_of(triangle);
    const Material& material = scene.materials[index];
    if (!material.cut_out) continue;
    if (of_material[index] == 0) of_material[index] = add_entry(scene, material);
    of_triangle[triangle] = of_material[index];
  }
  if (!entries_.empty()) of_triangle_ = std::move(of_triangle);
}

std::uint32_t CutOuts::add_entry(const Scene& scene, const Material& material) {
  check(scene, material);
  const CutOut& cut_out = *material.cut_out;
  Entry entry;
  entry.pattern = cut_out.pattern;
  entry.wrap_u = cut_out.wrap_u;
  entry.wrap_v = cut_out.wrap_v;
  entry.factor = cut_out.factor;
  entry.cutoff = cut_out.mode == AlphaMode::blended ? kBlendedCutoff : cut_out.cutoff;
  if (cut_out.texture >= 0) {
    const Texture& texture = scene.textures[static_cast<std::size_t>(cut_out.texture)];
    if (texture.rgba.size() / 4 > std::numeric_limits<std::uint32_t>::max() - texel_count_) {
      refuse(scene, "the textures of its cut-outs have more than 2^32 texels");
    }
    entry.first_texel = texel_count_;
    entry.width = static_cast<std::uint32_t>(texture.width);
    entry.height = static_cast<std::uint32_t>(texture.height);
    add_texels(texture, cut_out.channel);
  }
  entries_.push_back(entry);
  return static_cast<std::uint32_t>(entries_.size());
}

void CutOuts::add_texels(const Texture& texture, TextureChannel channel) {
  const std::size_t offset = channel == TextureChannel::alpha ? 3 : 0;
  for (std::size_t at = offset; at < texture.rgba.size(); at += 4, ++texel_count_) {
    const std::uint32_t place = texel_count_ % texels_per_word;
    if (place == 0) texels_.push_back(0);
    texels_.back() |= std::uint32_t{texture.rgba[at]} << (8 * place);
  }
}

float CutOuts::texel(const Entry& entry, int x, int y) const {
  const std::uint32_t at =
      entry.first_texel + static_cast<std::uint32_t>(y) * entry.width + static_cast<std::uint32_t>(x);
  return static_cast<float>(texels_[at / texels_per_word] >> (8 * (at % texels_per_word)) & 255U) / 255.0F;
}

float CutOuts::texture_alpha(const Entry& entry, const glm::vec2& uv) const {
  const int width = static_cast<int>(entry.width), height = static_cast<int>(entry.height);
  const float x = wrapped(uv.x, entry.wrap_u) * static_cast<float>(width) - 0.5F;
  const float y = wrapped(uv.y, entry.wrap_v) * static_cast<float>(height) - 0.5F;
  const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
  const int left = neighbour(column, width, entry.wrap_u), right = neighbour(column + 1, width, entry.wrap_u);
  const int top = neighbour(row, height, entry.wrap_v), bottom = neighbour(row + 1, height, entry.wrap_v);
  const float across = x - std::floor(x), down = y - std::floor(y);
  const float above = texel(entry, left, top) * (1.0F - across) + texel(entry, right, top) * across;
  const float below = texel(entry, left, bottom) * (1.0F - across) + texel(entry, right, bottom) * across;
  return above * (1.0F - down) + below * down;
}

bool CutOuts::any_blended() const {
  return std::any_of(entries_.begin(), entries_.end(), is_blended);
}

bool CutOuts::blends(std::size_t triangle) const {
  return cuts(triangle) && is_blended(entry_of(triangle));
}

float CutOuts::alpha(const Entry& entry, std::size_t triangle, float u, float v) const {
  float alpha = entry.factor;
  if (!mesh_.uvs.empty()) {
    const std::uint32_t* corner = &mesh_.indices[3 * triangle];
    const glm::vec2 uv =
        mesh_.uvs[corner[0]] * (1.0F - u - v) + mesh_.uvs[corner[1]] * u + mesh_.uvs[corner[2]] * v;
    alpha *= pattern_alpha(entry.pattern, uv);
    if (entry.width > 0) alpha *= texture_alpha(entry, uv);
  }
  return alpha;
}

bool CutOuts::open(std::size_t triangle, float u, float v) const {
  return cuts(triangle) && alpha(entry_of(triangle), triangle, u, v) < entry_of(triangle).cutoff;
}

float CutOuts::opacity(std::size_t triangle, float u, float v) const {
  if (!blends(triangle)) return open(triangle, u, v) ? 0.0F : 1.0F;
  return std::clamp(alpha(entry_of(triangle), triangle, u, v), 0.0F, 1.0F);
}

void add_fields(platform::ContentHash& hash, const CutOuts& cut_outs) {
  if (!cut_outs.any()) return;
  hash.update(std::string_view("cut-outs"));
  hash.update(std::span<const std::uint32_t>(cut_outs.of_triangle_));
  hash.update(std::span<const CutOuts::Entry>(cut_outs.entries_));
  hash.update(std::span<const std::uint32_t>(cut_outs.texels_));
  hash.update(std::span<const glm::vec2>(cut_outs.mesh_.uvs));
}

}  // namespace penumbra::scene
