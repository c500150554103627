// Materials and textures of a model file, as the importer library reads them.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/material.h"

struct aiScene;

namespace penumbra::scene {

// The limit for all of a model's textures together; a model with more is measured in plain colours.
inline constexpr std::size_t kMostTexturePixels = std::size_t{128} << 20;

struct ModelMaterials {
  std::vector<Material> materials;  // one for each of the file's materials
  // The mesh's set of coordinates that the textures of each material use.
  std::vector<unsigned> uv_channels;
  std::vector<Texture> textures;
  std::vector<std::string> notes;  // a line for whatever is left out, with the file and the reason
};

// Reads base colour (glTF) or diffuse colour (others) as linear numbers, the roughness factor, and the
// textures of base colour and normals, embedded or beside the file. A texture's path resolves inside the
// model's own folder only, links followed. A texture that is missing, broken, too large or elsewhere is left
// out with a note.
// Cut-outs: for glTF alphaMode MASK, with its cutoff, the alpha of factor and texture, and the sampler's
// repeat modes. BLEND is read likewise, as blended, where any of that alpha is below 1. For other formats the
// opacity map is read, at a cutoff of 1/2: its alpha channel where it has one and else its red one, white
// being solid. A cut-out whose texture is left out is solid, with a note. Metals, opacity factors, heights,
// transforms of coordinates (with a note where they move a cut-out), and repeat modes of colours and normals
// are not read.
ModelMaterials read_model_materials(const aiScene& scene, const std::filesystem::path& file);

// Returns `path`, relative to the model's folder or absolute, with its links resolved; empty outside of that
// folder. The file need not exist.
std::optional<std::filesystem::path> in_model_folder(const std::filesystem::path& path,
                                                     const std::filesystem::path& model);

// The importer library opens files through it: the model, and buffers and material libraries in its folder.
class ModelFolder final : public Assimp::DefaultIOSystem {
 public:
  explicit ModelFolder(std::filesystem::path model) : model_(std::move(model)) {}

  bool Exists(const char* file) const override { return allows(file) && DefaultIOSystem::Exists(file); }
  Assimp::IOStream* Open(const char* file, const char* mode = "rb") override;

  // Returns the first file outside of the folder that the model named; empty if there is none.
  const std::string& refused() const { return refused_; }
  // Returns the files in the folder that the model named and that are not there, each once.
  const std::vector<std::string>& missing() const { return missing_; }

 private:
  bool allows(const std::string& file) const;

  std::filesystem::path model_;
  mutable std::string refused_;
  mutable std::vector<std::string> missing_;
};

}  // namespace penumbra::scene
