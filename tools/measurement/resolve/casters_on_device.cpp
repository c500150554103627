#include "resolve/casters_on_device.h"

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <span>

#include "input/input_error.h"
#include "scene/cut_out.h"
#include "scene/shadow_volume.h"

namespace penumbra::resolve {
namespace {

using scene::CutOut;

constexpr std::array<std::pair<const char*, int>, 4> kSemantics{
    {{"POSITION0", 3}, {"NORMAL0", 3}, {"TEXCOORD0", 2}, {"COLOR0", 4}}};

// A pattern as a texture: bilinear reads of so many texels are off by at most 1e-4 in alpha.
constexpr int kPatternTexels = 512;

struct Picture {
  int width = 1;
  int height = 1;
  std::vector<float> rgba;
};

float linear_of(std::uint8_t stored) {
  const float value = static_cast<float>(stored) / 255.0F;
  return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

Picture pattern_picture(scene::AlphaPattern pattern) {
  Picture picture{kPatternTexels, kPatternTexels, {}};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const glm::vec2 uv((static_cast<float>(x) + 0.5F) / kPatternTexels,
                         (static_cast<float>(y) + 0.5F) / kPatternTexels);
      for (const float channel : {1.0F, 1.0F, 1.0F, scene::pattern_alpha(pattern, uv)})
        picture.rgba.push_back(channel);
    }
  return picture;
}

// The colours are the material's where they are in the same texture as its alpha; else white.
Picture texture_picture(const scene::Texture& texture, const CutOut& cut_out, bool has_colours) {
  Picture picture{texture.width, texture.height, {}};
  const std::size_t alpha = cut_out.channel == scene::TextureChannel::alpha ? 3 : 0;
  for (std::size_t at = 0; at + 3 < texture.rgba.size(); at += 4) {
    for (std::size_t channel = 0; channel < 3; ++channel)
      picture.rgba.push_back(has_colours ? linear_of(texture.rgba[at + channel]) : 1.0F);
    picture.rgba.push_back(static_cast<float>(texture.rgba[at + alpha]) / 255.0F);
  }
  return picture;
}

// The next mip level: each texel is the mean of those that it covers.
Picture halved(const Picture& picture) {
  Picture half{gpu::mip_size(picture.width, 1), gpu::mip_size(picture.height, 1), {}};
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      const int left = x * picture.width / half.width, right = (x + 1) * picture.width / half.width;
      const int top = y * picture.height / half.height, bottom = (y + 1) * picture.height / half.height;
      for (int channel = 0; channel < 4; ++channel) {
        float sum = 0.0F;
        for (int row = top; row < bottom; ++row)
          for (int column = left; column < right; ++column)
            sum += picture.rgba[static_cast<std::size_t>(4 * (row * picture.width + column) + channel)];
        half.rgba.push_back(sum / static_cast<float>((right - left) * (bottom - top)));
      }
    }
  return half;
}

gpu::Image image_of(const gpu::Device& device, Picture picture, bool with_mips) {
  gpu::ImageShape shape{.format = gpu::Format::rgba32f, .width = picture.width, .height = picture.height};
  if (with_mips) shape.mips = gpu::mip_count(picture.width, picture.height);
  gpu::Image image(device, shape);
  image.upload(picture.rgba);
  for (int mip = 1; mip < shape.mips; ++mip) {
    picture = halved(picture);
    image.upload(picture.rgba, {.mip = mip});
  }
  return image;
}

gpu::SamplerWrap wrap_of(scene::TextureWrap wrap) {
  if (wrap == scene::TextureWrap::repeat) return gpu::SamplerWrap::repeat;
  return wrap == scene::TextureWrap::mirror ? gpu::SamplerWrap::mirror : gpu::SamplerWrap::clamp;
}

template <typename Element>
gpu::Buffer buffer_of(const gpu::Device& device, const std::vector<Element>& elements) {
  return {device, std::span<const Element>(elements)};
}

UniformValues object_uniforms(const glm::dvec3& origin) {
  const std::array to_world{glm::translate(glm::dmat4(1.0), origin)};
  const std::array to_object{glm::translate(glm::dmat4(1.0), -origin)};
  UniformValues values;
  values.set("unity_ObjectToWorld", std::span<const glm::dmat4>(to_world));
  values.set("unity_WorldToObject", std::span<const glm::dmat4>(to_object));
  return values;
}

}  // namespace

CastersOnDevice::CastersOnDevice(const gpu::Device& device, const scene::Scene& scene)
    : white_(image_of(device, {1, 1, {1.0F, 1.0F, 1.0F, 1.0F}}, false)),
      uniforms_(object_uniforms(scene.origin)) {
  const scene::Mesh& mesh = scene.mesh;
  vertices_.emplace("POSITION0", buffer_of(device, mesh.positions));
  vertices_.emplace("NORMAL0", buffer_of(device, mesh.normals));
  vertices_.emplace(
      "TEXCOORD0",
      buffer_of(device, mesh.uvs.empty() ? std::vector<glm::vec2>(mesh.positions.size()) : mesh.uvs));
  vertices_.emplace("COLOR0",
                    buffer_of(device, std::vector<glm::vec4>(mesh.positions.size(), glm::vec4(1.0F))));
  std::vector<std::vector<std::uint32_t>> indices(scene.materials.size());
  for (std::size_t triangle = 0; triangle < mesh.triangle_count(); ++triangle) {
    std::vector<std::uint32_t>& of_material = indices.at(mesh.material_of(triangle));
    for (std::size_t corner = 0; corner < 3; ++corner)
      of_material.push_back(mesh.indices[3 * triangle + corner]);
  }
  for (std::size_t material = 0; material < indices.size(); ++material)
    if (!indices[material].empty()) add_part(device, scene, material, indices[material]);
}

void CastersOnDevice::add_part(const gpu::Device& device, const scene::Scene& scene, std::size_t index,
                               const std::vector<std::uint32_t>& indices) {
  const scene::Material& material = scene.materials[index];
  const CutOut cut_out = material.cut_out.value_or(CutOut{});
  const bool has_pattern = cut_out.pattern != scene::AlphaPattern::none;
  if (has_pattern && cut_out.texture >= 0)
    throw InputError("", "scene '" + scene.name + "': material '" + material.name +
                             "' is cut out by a pattern and a texture, and shaders have one _BaseMap");
  const bool blended = material.cut_out && cut_out.mode == scene::AlphaMode::blended;
  Part part{buffer_of(device, indices),
            static_cast<std::uint32_t>(indices.size()),
            material.cut_out && !blended,
            blended ? techniques::DrawnCasters::blended : techniques::DrawnCasters::opaque,
            {},
            std::nullopt,
            gpu::Sampler(device, wrap_of(cut_out.wrap_u), wrap_of(cut_out.wrap_v))};
  if (has_pattern)
    part.base_map = image_of(device, pattern_picture(cut_out.pattern), blended);
  else if (cut_out.texture >= 0)
    part.base_map = image_of(device,
                             texture_picture(scene.textures.at(static_cast<std::size_t>(cut_out.texture)),
                                             cut_out, cut_out.texture == material.base_colour_texture),
                             blended);
  const auto width = static_cast<float>(base_map(part).width());
  const auto height = static_cast<float>(base_map(part).height());
  part.uniforms.set("_BaseColor", glm::vec4(material.base_colour, cut_out.factor));
  part.uniforms.set("_Cutoff", cut_out.cutoff);
  part.uniforms.set("_BaseMap_ST", glm::vec4(1.0F, 1.0F, 0.0F, 0.0F));
  part.uniforms.set("_BaseMap_TexelSize", glm::vec4(1.0F / width, 1.0F / height, width, height));
  parts_.push_back(std::move(part));
}

void CastersOnDevice::add_volumes(const gpu::Device& device, const scene::Scene& scene) {
  const scene::ShadowVolume volume = scene::shadow_volume(scene);
  has_volumes_ = true;
  if (volume.indices.empty()) return;
  volume_positions_.emplace(buffer_of(device, volume.positions));
  parts_.push_back({buffer_of(device, volume.indices),
                    static_cast<std::uint32_t>(volume.indices.size()),
                    false,
                    techniques::DrawnCasters::volumes,
                    {},
                    std::nullopt,
                    gpu::Sampler(device, gpu::SamplerWrap::clamp, gpu::SamplerWrap::clamp)});
}

const gpu::Buffer* CastersOnDevice::vertices(const std::string& semantic, techniques::DrawnCasters of) const {
  if (of == techniques::DrawnCasters::volumes) {
    if (semantic == "POSITION0") return &*volume_positions_;
    throw InputError("", "a pass of shadow volumes reads the vertex input " + semantic,
                     "they have POSITION0 alone");
  }
  const auto found = vertices_.find(semantic);
  return found == vertices_.end() ? nullptr : &found->second;
}

int CastersOnDevice::components(const std::string& semantic) {
  for (const auto& [name, components] : kSemantics)
    if (semantic == name) return components;
  return 0;
}

std::string CastersOnDevice::semantics() {
  std::string names;
  for (const auto& [name, components] : kSemantics) names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

}  // namespace penumbra::resolve
