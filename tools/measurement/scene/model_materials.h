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
  std::vector<std::string> notes;  // a line for whatever is left out, with the file and the reason
};

// Base colour (glTF) or diffuse colour (others) as linear numbers, the roughness factor, and the textures of
// base colour and normals, embedded or beside the file. A texture's path resolves inside the model's own
// folder only, links followed. A texture that is missing, broken, too large or elsewhere is left out with a
// note.
// Cut-outs: alphaMode MASK of glTF, with its cutoff, the alpha of factor and texture, and the sampler's
// repeat modes; BLEND likewise, blended, where any of that alpha is below 1; of other formats the opacity
// map, at a cutoff of 1/2, its alpha channel where it has one and else its red one, white being solid. A
// cut-out whose texture is left out is solid, with a note. Not read: metals, opacity factors, heights,
// transforms of coordinates (with a note where they move a cut-out), repeat modes of colours and normals.
ModelMaterials read_model_materials(const aiScene& scene, const std::filesystem::path& file);

}  // namespace penumbra::scene
