#include "scene/model_materials.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <span>
#include <system_error>

#include "input/input_error.h"
#include "scene/image_file.h"

namespace penumbra::scene {
namespace {

namespace fs = std::filesystem;

float factor(float value) {
  return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 0.5F;
}

// "%20" is a blank, as in any URI.
std::string percent_decoded(const std::string& text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned code = 0;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(text.data() + i + 1, text.data() + i + 3, code, 16).ptr == text.data() + i + 3) {
      decoded += static_cast<char>(code);
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

// The file that a model means by a texture's path. Throws InputError for one outside the model's folder and
// for one that does not exist.
fs::path texture_file(std::string path, const fs::path& model) {
  std::replace(path.begin(), path.end(), '\\', '/');
  const fs::path folder = fs::canonical(model.has_parent_path() ? model.parent_path() : fs::path("."));
  std::error_code error;
  if (!fs::exists(folder / path, error)) path = percent_decoded(path);
  const fs::path resolved = fs::weakly_canonical(folder / path, error);
  const fs::path relative = resolved.lexically_relative(folder);
  if (error || relative.empty() || *relative.begin() == "..") {
    throw InputError(path, "lies outside the model's folder");
  }
  if (!fs::is_regular_file(resolved, error)) throw InputError(path, "no such file");
  return resolved;
}

Texture embedded_texture(const aiTexture& texture, const std::string& name) {
  if (texture.mHeight == 0) {  // a picture file of mWidth bytes
    return decode_image(
        std::as_bytes(std::span(reinterpret_cast<const char*>(texture.pcData), texture.mWidth)), name);
  }
  if (texture.mWidth > static_cast<unsigned>(kLargestImageSide) ||
      texture.mHeight > static_cast<unsigned>(kLargestImageSide)) {
    throw InputError(name, "has more than " + std::to_string(kLargestImageSide) + " pixels per side");
  }
  Texture read{static_cast<int>(texture.mWidth), static_cast<int>(texture.mHeight), {}};
  const std::size_t texels = std::size_t{texture.mWidth} * texture.mHeight;
  read.rgba.reserve(4 * texels);
  for (const aiTexel& texel : std::span(texture.pcData, texels)) {
    read.rgba.insert(read.rgba.end(), {texel.r, texel.g, texel.b, texel.a});
  }
  return read;
}

class Reader {
 public:
  Reader(const aiScene& scene, const fs::path& file) : scene_(scene), file_(file) {}

  ModelMaterials read() {
    for (unsigned i = 0; i < scene_.mNumMaterials; ++i) add(*scene_.mMaterials[i]);
    if (result_.materials.empty()) add(aiMaterial{});
    return std::move(result_);
  }

 private:
  struct Slot {
    int texture = -1;
    unsigned uv_channel = 0;
  };

  void add(const aiMaterial& material) {
    Material made;
    made.name = material.GetName().length == 0 ? "unnamed" : material.GetName().C_Str();
    aiColor4D colour;
    if (material.Get(AI_MATKEY_BASE_COLOR, colour) == aiReturn_SUCCESS ||
        material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == aiReturn_SUCCESS) {
      made.base_colour = {factor(colour.r), factor(colour.g), factor(colour.b)};
    }
    float roughness = 0.0F;
    if (material.Get(AI_MATKEY_ROUGHNESS_FACTOR, roughness) == aiReturn_SUCCESS)
      made.roughness = factor(roughness);
    Slot base = slot(material, aiTextureType_BASE_COLOR);
    if (base.texture < 0) base = slot(material, aiTextureType_DIFFUSE);
    const Slot normal = slot(material, aiTextureType_NORMALS);
    made.base_colour_texture = base.texture;
    const bool same_coordinates = base.texture < 0 || normal.uv_channel == base.uv_channel;
    if (same_coordinates) {
      made.normal_texture = normal.texture;
    } else if (normal.texture >= 0) {
      note("material '" + made.name +
           "': its normal map uses other texture coordinates than its colour and is left out");
    }
    result_.uv_channels.push_back(base.texture >= 0 ? base.uv_channel : normal.uv_channel);
    result_.materials.push_back(std::move(made));
  }

  Slot slot(const aiMaterial& material, aiTextureType type) {
    aiString path;
    Slot found;
    if (material.GetTextureCount(type) == 0 ||
        material.GetTexture(type, 0, &path, nullptr, &found.uv_channel) != aiReturn_SUCCESS) {
      return {};
    }
    const auto [known, is_new] = indices_.try_emplace(path.C_Str(), -1);
    if (is_new) known->second = texture(path.C_Str());
    found.texture = known->second;
    return found;
  }

  // The new texture's index; -1 and a note without one.
  int texture(const std::string& path) {
    try {
      const aiTexture* embedded = scene_.GetEmbeddedTexture(path.c_str());
      Texture read = embedded != nullptr ? embedded_texture(*embedded, "embedded texture " + path)
                                         : read_image(texture_file(path, file_));
      pixels_ += static_cast<std::size_t>(read.width) * static_cast<std::size_t>(read.height);
      if (pixels_ > kMostTexturePixels) {
        throw InputError(path, "the model's textures have more than " + std::to_string(kMostTexturePixels) +
                                   " pixels together");
      }
      result_.textures.push_back(std::move(read));
      return static_cast<int>(result_.textures.size()) - 1;
    } catch (const InputError& error) {
      note(std::string("drawn without a texture: ") + error.what());
    } catch (const fs::filesystem_error& error) {
      note(std::string("drawn without a texture: ") + error.what());
    }
    return -1;
  }

  void note(const std::string& text) { result_.notes.push_back(file_.string() + ": " + text); }

  const aiScene& scene_;
  const fs::path& file_;
  ModelMaterials result_;
  std::map<std::string, int> indices_;
  std::size_t pixels_ = 0;
};

}  // namespace

ModelMaterials read_model_materials(const aiScene& scene, const fs::path& file) {
  return Reader(scene, file).read();
}

}  // namespace penumbra::scene
