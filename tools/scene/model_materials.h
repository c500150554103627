// Materials and textures of a model file, as the importer library reads them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/material.h"

struct aiScene;

namespace penumbra::scene {

// All of a model's textures together; the shadows of a model with more can be measured, in plain colours.
inline constexpr std::size_t kMostTexturePixels = std::size_t{128} << 20;

struct ModelMaterials {
  std::vector<Material> materials;    // one for each of the file's
  std::vector<unsigned> uv_channels;  // for each material, which of a mesh's coordinates its textures use
  std::vector<Texture> textures;
  std::vector<std::string> notes;  // a line for each texture that is left out, with the file and the reason
};

// Base colour (glTF) or diffuse colour (others) as linear numbers, the roughness factor, and the textures of
// base colour and normals, embedded or beside the file. A texture's path resolves inside the model's own
// folder only, links followed. A texture that is missing, broken, too large or elsewhere is left out with a
// note: shadows need none. Not read: metals, transparency and cut-outs, heights, transforms of coordinates,
// repeat modes.
ModelMaterials read_model_materials(const aiScene& scene, const std::filesystem::path& file);

}  // namespace penumbra::scene
