// A scene's triangles on a device for passes that draw the casters, with the uniforms and textures that Unity
// gives a shader of a material.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gpu/resources.h"
#include "resolve/uniform_values.h"
#include "scene/scene.h"
#include "techniques/pass_graph.h"

namespace penumbra::resolve {

class CastersOnDevice {
 public:
  // The triangles of one material.
  struct Part {
    gpu::Buffer indices;
    std::uint32_t index_count = 0;
    bool alpha_test = false;
    techniques::DrawnCasters casters = techniques::DrawnCasters::opaque;  // drawn by passes of these alone
    // These are _BaseColor (linear, alpha is the cut-out's factor), _Cutoff, _BaseMap_ST and
    // _BaseMap_TexelSize.
    UniformValues uniforms;
    // The texture of a cut-out, with linear RGB; other materials get white. Blended casters have mip levels,
    // as textures in Unity have them: a texel of the map gets the mean alpha over what it covers. Cut-outs
    // are read as rays read them.
    std::optional<gpu::Image> base_map;
    gpu::Sampler sampler;
  };

  // Throws InputError, naming scene and material, for a cut-out that has both a pattern and a texture: a
  // _BaseMap cannot hold both.
  CastersOnDevice(const gpu::Device& device, const scene::Scene& scene);

  // Adds the shadow volumes (scene/shadow_volume.h) of `scene`, from which these casters were made. They are
  // one more part, which has no material. Throws as shadow_volume() does.
  void add_volumes(const gpu::Device& device, const scene::Scene& scene);

  bool has_volumes() const { return has_volumes_; }

  const std::vector<Part>& parts() const { return parts_; }
  const gpu::Image& base_map(const Part& part) const { return part.base_map ? *part.base_map : white_; }

  // Returns the buffer of that semantic, with as many floats for each vertex as components() says; null if
  // scenes have none of it. Colours are white, as Unity gives them for meshes without colours. Throws
  // InputError for volumes, which have positions alone.
  const gpu::Buffer* vertices(const std::string& semantic, techniques::DrawnCasters of) const;
  static int components(const std::string& semantic);  // 0 if there is none
  static std::string semantics();                      // lists all of them, for messages

  // These are unity_ObjectToWorld and unity_WorldToObject; positions are relative to the scene's origin.
  const UniformValues& uniforms() const { return uniforms_; }

 private:
  void add_part(const gpu::Device& device, const scene::Scene& scene, std::size_t material,
                const std::vector<std::uint32_t>& indices);

  std::map<std::string, gpu::Buffer> vertices_;
  std::optional<gpu::Buffer> volume_positions_;  // empty where no triangle casts
  bool has_volumes_ = false;
  gpu::Image white_;
  std::vector<Part> parts_;
  UniformValues uniforms_;
};

}  // namespace penumbra::resolve
