#include "scene/model_materials.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <span>
#include <string_view>
#include <system_error>

#include "input/input_error.h"
#include "scene/image_file.h"

namespace penumbra::scene {
namespace {

namespace fs = std::filesystem;

float factor(float value) {
  return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 0.5F;
}

// Decodes the escapes of a URI: "%20" is a space.
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

// Returns the file that a model means by a texture's path. Throws InputError for one outside the model's
// folder and for one that does not exist.
fs::path texture_file(std::string path, const fs::path& model) {
  std::replace(path.begin(), path.end(), '\\', '/');
  const fs::path folder = fs::canonical(model.has_parent_path() ? model.parent_path() : fs::path("."));
  std::error_code error;
  if (!fs::exists(folder / path, error)) path = percent_decoded(path);
  const std::optional<fs::path> resolved = in_model_folder(path, model);
  if (!resolved) throw InputError(path, "lies outside the model's folder");
  if (!fs::is_regular_file(*resolved, error)) throw InputError(path, "no such file");
  return *resolved;
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

TextureWrap wrap_of(aiTextureMapMode mode) {
  if (mode == aiTextureMapMode_Mirror) return TextureWrap::mirror;
  return mode == aiTextureMapMode_Wrap ? TextureWrap::repeat : TextureWrap::clamp;
}

bool has_alpha(const Texture& texture) {
  for (std::size_t at = 3; at < texture.rgba.size(); at += 4) {
    if (texture.rgba[at] != 255) return true;
  }
  return false;
}

class Reader {
 public:
  Reader(const aiScene& scene, const fs::path& file) : scene_(scene), file_(file) {}

  ModelMaterials read() {
    for (unsigned i = 0; i < scene_.mNumMaterials; ++i) add(*scene_.mMaterials[i]);
    if (result_.materials.empty()) add(aiMaterial{});
    if (blended_ > 0) {
      note(std::to_string(blended_) + " of its materials, '" + first_blended_ +
           "' for one, are blended (alphaMode BLEND): they dim the light, and the camera and the shadow map "
           "do "
           "not see them");
    }
    return std::move(result_);
  }

 private:
  struct Slot {
    int texture = -1;
    unsigned uv_channel = 0;
    TextureWrap wrap_u = TextureWrap::repeat;
    TextureWrap wrap_v = TextureWrap::repeat;
    bool lost = false;         // the material names a texture that cannot be loaded
    bool transformed = false;  // its coordinates are transformed
  };

  void add(const aiMaterial& material) {
    Material made;
    made.name = material.GetName().length == 0 ? "unnamed" : material.GetName().C_Str();
    aiColor4D colour(1.0F, 1.0F, 1.0F, 1.0F);
    if (material.Get(AI_MATKEY_BASE_COLOR, colour) == aiReturn_SUCCESS ||
        material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == aiReturn_SUCCESS) {
      made.base_colour = {factor(colour.r), factor(colour.g), factor(colour.b)};
    }
    float roughness = 0.0F;
    if (material.Get(AI_MATKEY_ROUGHNESS_FACTOR, roughness) == aiReturn_SUCCESS)
      made.roughness = factor(roughness);
    Slot base = slot(material, aiTextureType_BASE_COLOR);
    if (base.texture < 0) {
      const Slot diffuse = slot(material, aiTextureType_DIFFUSE);
      if (diffuse.texture >= 0 || !base.lost) base = diffuse;
    }
    Slot normal = slot(material, aiTextureType_NORMALS);
    Slot cut = base;  // the texture of the cut-out
    made.cut_out = cut_out(material, made.name, colour.a, cut);
    if (!made.cut_out) cut.texture = -1;
    const Slot& first = cut.texture >= 0 ? cut : base.texture >= 0 ? base : normal;
    const char* first_name = cut.texture >= 0 ? "opacity map" : "colour";
    keep_with(first, first_name, base, "colour texture", made);
    keep_with(first, first_name, normal, "normal map", made);
    made.base_colour_texture = base.texture;
    made.normal_texture = normal.texture;
    result_.uv_channels.push_back(first.uv_channel);
    result_.materials.push_back(std::move(made));
  }

  // A mesh has one set of coordinates here: textures that use another set than the first are omitted.
  void keep_with(const Slot& first, const char* first_name, Slot& slot, const char* name,
                 const Material& material) {
    if (slot.texture < 0 || slot.uv_channel == first.uv_channel) return;
    slot.texture = -1;
    note("material '" + material.name + "': its " + name + " uses other texture coordinates than its " +
         first_name + " and is left out");
  }

  // `slot` is that of the colour; afterwards it is that of the opacity map.
  std::optional<CutOut> cut_out(const aiMaterial& material, const std::string& name, float colour_alpha,
                                Slot& slot) {
    CutOut made;
    if (aiString mode; material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == aiReturn_SUCCESS) {
      if (std::string_view(mode.C_Str()) == "BLEND")
        made.mode = AlphaMode::blended;
      else if (std::string_view(mode.C_Str()) != "MASK")
        return std::nullopt;
      material.Get(AI_MATKEY_GLTF_ALPHACUTOFF, made.cutoff);
      if (!std::isfinite(made.cutoff)) made.cutoff = 0.5F;
      made.factor = std::isfinite(colour_alpha) ? std::clamp(colour_alpha, 0.0F, 1.0F) : 1.0F;
    } else {
      slot = this->slot(material, aiTextureType_OPACITY);
      if (slot.texture < 0 && !slot.lost) return std::nullopt;
      if (slot.texture >= 0 && !has_alpha(result_.textures[static_cast<std::size_t>(slot.texture)])) {
        made.channel = TextureChannel::red;
      }
    }
    if (slot.lost) {
      note("material '" + name + "': without the texture that cuts it out it is solid");
      return std::nullopt;
    }
    if (slot.texture >= 0 && slot.transformed) {
      note("material '" + name +
           "': the transform of its coordinates is not read, its holes may be elsewhere");
    }
    made.texture = slot.texture;
    if (made.mode == AlphaMode::blended) {
      if (is_opaque(made)) return std::nullopt;
      if (blended_++ == 0) first_blended_ = name;
    }
    made.wrap_u = slot.wrap_u;
    made.wrap_v = slot.wrap_v;
    return made;
  }

  // Exporters declare opaque materials as blended, too.
  bool is_opaque(const CutOut& blended) const {
    return blended.factor == 1.0F &&
           (blended.texture < 0 || !has_alpha(result_.textures[static_cast<std::size_t>(blended.texture)]));
  }

  Slot slot(const aiMaterial& material, aiTextureType type) {
    aiString path;
    Slot found;
    aiTextureMapMode wrap[2] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
    if (material.GetTextureCount(type) == 0 ||
        material.GetTexture(type, 0, &path, nullptr, &found.uv_channel, nullptr, nullptr, wrap) !=
            aiReturn_SUCCESS) {
      return {};
    }
    const auto [known, is_new] = indices_.try_emplace(path.C_Str(), -1);
    if (is_new) known->second = texture(path.C_Str());
    found.texture = known->second;
    found.lost = found.texture < 0;
    found.wrap_u = wrap_of(wrap[0]);
    found.wrap_v = wrap_of(wrap[1]);
    aiUVTransform transform;
    found.transformed = material.Get(AI_MATKEY_UVTRANSFORM(type, 0), transform) == aiReturn_SUCCESS;
    return found;
  }

  // Returns the new texture's index, or -1 with a note if it cannot be loaded.
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
  int blended_ = 0;
  std::string first_blended_;
};

}  // namespace

ModelMaterials read_model_materials(const aiScene& scene, const fs::path& file) {
  return Reader(scene, file).read();
}

std::optional<fs::path> in_model_folder(const fs::path& path, const fs::path& model) {
  std::error_code error;
  const fs::path folder = fs::canonical(model.has_parent_path() ? model.parent_path() : fs::path("."), error);
  if (error) return std::nullopt;
  const fs::path resolved = fs::weakly_canonical(folder / path, error);
  const fs::path relative = resolved.lexically_relative(folder);
  if (error || relative.empty() || *relative.begin() == "..") return std::nullopt;
  return resolved;
}

// The library gives paths relative to the working directory.
bool ModelFolder::allows(const std::string& file) const {
  std::error_code error;
  if (fs::path(file) == model_) return true;
  const std::optional<fs::path> inside = in_model_folder(fs::absolute(file, error), model_);
  if (!error && inside && fs::is_regular_file(*inside, error)) return true;  // a pipe has no end
  if (inside && !fs::exists(*inside, error)) {
    const std::string name = inside->filename().string();
    if (std::find(missing_.begin(), missing_.end(), name) == missing_.end()) missing_.push_back(name);
  } else if (refused_.empty()) {
    refused_ = file;
  }
  return false;
}

Assimp::IOStream* ModelFolder::Open(const char* file, const char* mode) {
  const bool writes = std::string_view(mode).find_first_of("wa+") != std::string_view::npos;
  return !writes && allows(file) ? DefaultIOSystem::Open(file, mode) : nullptr;
}

}  // namespace penumbra::scene
