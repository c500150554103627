#include "resolve/adapter_resources.h"

#include <array>
#include <filesystem>
#include <span>

#include "hlsl/sampler_name.h"
#include "input/input_error.h"
#include "scene/image_file.h"

namespace penumbra::resolve {
namespace {

using Colour = std::array<std::uint8_t, 4>;

// Unity's default textures (Unity manual, "ShaderLab: defining material properties", Texture2D).
const std::map<std::string, Colour> kDefaultTextures{
    {"white", {255, 255, 255, 255}}, {"black", {0, 0, 0, 255}},      {"gray", {128, 128, 128, 128}},
    {"grey", {128, 128, 128, 128}},  {"bump", {128, 128, 255, 128}}, {"red", {255, 0, 0, 255}}};

std::string default_names() {
  std::string names;
  for (const auto& entry : kDefaultTextures) names += (names.empty() ? "" : ", ") + entry.first;
  return names;
}

std::vector<float> as_floats(const scene::Texture& picture) {
  std::vector<float> texels;
  texels.reserve(picture.rgba.size());
  for (const std::uint8_t value : picture.rgba) texels.push_back(static_cast<float>(value) / 255.0F);
  return texels;
}

glm::vec4 texel_size(const scene::Texture& picture) {
  const auto width = static_cast<float>(picture.width);
  const auto height = static_cast<float>(picture.height);
  return {1.0F / width, 1.0F / height, width, height};
}

}  // namespace

AdapterTexture adapter_texture(const std::string& name, const std::string& file_or_default,
                               const scene::ReadingProcess& process) {
  const auto found = kDefaultTextures.find(file_or_default);
  if (found != kDefaultTextures.end()) {
    const Colour& colour = found->second;
    return {name, {1, 1, {colour.begin(), colour.end()}}};
  }
  if (!std::filesystem::is_regular_file(file_or_default)) {
    throw InputError(
        "'" + name + "=" + file_or_default + "'",
        "'" + file_or_default + "' is neither a number nor a picture's file",
        "a uniform takes numbers with commas between them; a texture a PNG, JPEG, TGA or BMP file "
        "or one of Unity's default textures: " +
            default_names());
  }
  return {name, scene::read_image_apart(file_or_default, process)};
}

std::optional<gpu::SamplerKind> inline_sampler(const std::string& name) {
  const hlsl::SamplerName words = hlsl::read_sampler_name(name);
  if (words.compare || words.mirror || words.point == words.linear || words.clamp == words.repeat) {
    return std::nullopt;
  }
  if (words.clamp) return words.point ? gpu::SamplerKind::point_clamp : gpu::SamplerKind::linear_clamp;
  return words.point ? gpu::SamplerKind::point_repeat : gpu::SamplerKind::linear_repeat;
}

AdapterResources::AdapterResources(const gpu::Device& device, const std::vector<AdapterTexture>& textures)
    : device_(&device) {
  for (const AdapterTexture& texture : textures) {
    gpu::Image image(device, gpu::Format::rgba32f, texture.picture.width, texture.picture.height);
    image.upload(as_floats(texture.picture));
    images_.insert_or_assign(texture.name, std::move(image));
    uniforms_.set(texture.name + "_TexelSize", texel_size(texture.picture));
    uniforms_.set(texture.name + "_ST", glm::vec4(1.0F, 1.0F, 0.0F, 0.0F));
  }
}

std::map<std::string, const gpu::Image*> AdapterResources::images() const {
  std::map<std::string, const gpu::Image*> images;
  for (const auto& [name, image] : images_) images.emplace(name, &image);
  return images;
}

const gpu::Sampler* AdapterResources::sampler(const std::string& name) {
  if (const std::optional<gpu::SamplerKind> kind = inline_sampler(name)) return kept(*kind);
  const std::string prefix = "sampler";
  const bool of_a_texture =
      name.compare(0, prefix.size(), prefix) == 0 && images_.count(name.substr(prefix.size())) != 0;
  return of_a_texture ? kept(gpu::SamplerKind::linear_repeat) : nullptr;
}

const gpu::Sampler* AdapterResources::kept(gpu::SamplerKind kind) {
  return &samplers_.try_emplace(kind, *device_, kind).first->second;
}

}  // namespace penumbra::resolve
