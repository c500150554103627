// A scene's triangles as passes that draw the casters get them, with what Unity gives a shader of a material.
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
    // _BaseColor (linear, alpha is the cut-out's factor), _Cutoff, _BaseMap_ST, _BaseMap_TexelSize.
    UniformValues uniforms;
    // Of a cut-out, RGB linear; else white. Of blended casters with mip levels, as textures in Unity have
    // them: a texel of the map gets the mean alpha over what it covers. Cut-outs are read as rays read them.
    std::optional<gpu::Image> base_map;
    gpu::Sampler sampler;
  };

  // Throws InputError, naming scene and material, for a cut-out of a pattern and a texture: no _BaseMap is
  // both.
  CastersOnDevice(const gpu::Device& device, const scene::Scene& scene);

  // The shadow volumes (scene/shadow_volume.h) of the scene that this is of, as one more part, which has no
  // material. Throws as shadow_volume() does.
  void add_volumes(const gpu::Device& device, const scene::Scene& scene);

  bool has_volumes() const { return has_volumes_; }

  const std::vector<Part>& parts() const { return parts_; }
  const gpu::Image& base_map(const Part& part) const { return part.base_map ? *part.base_map : white_; }

  // Of that semantic, so many floats for each vertex; null: scenes have none of it. Colours are white, as
  // Unity gives them for meshes without. Throws InputError for volumes, which have positions alone.
  const gpu::Buffer* vertices(const std::string& semantic, techniques::DrawnCasters of) const;
  static int components(const std::string& semantic);  // 0: none
  static std::string semantics();                      // all, for messages

  // unity_ObjectToWorld and unity_WorldToObject: positions are relative to the scene's origin.
  const UniformValues& uniforms() const { return uniforms_; }

 private:
  void add_part(const gpu::Device& device, const scene::Scene& scene, std::size_t material,
                const std::vector<std::uint32_t>& indices);

  std::map<std::string, gpu::Buffer> vertices_;
  std::optional<gpu::Buffer> volume_positions_;  // where a triangle casts
  bool has_volumes_ = false;
  gpu::Image white_;
  std::vector<Part> parts_;
  UniformValues uniforms_;
};

}  // namespace penumbra::resolve
