// Textures and samplers that an adapter brings: pictures from files, Unity's default textures, and the
// samplers that Unity makes of a name.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gpu/resources.h"
#include "resolve/uniform_values.h"
#include "scene/material.h"
#include "scene/reading_process.h"

namespace penumbra::resolve {

struct AdapterTexture {
  std::string name;  // as the shader declares it
  scene::Texture picture;
};

// A picture's file, or one of Unity's default textures: white, black, gray, grey, red, bump. Throws
// InputError as scene::read_image_apart() does, and for a file that is not there, with the names of the
// default textures.
AdapterTexture adapter_texture(const std::string& name, const std::string& file_or_default,
                               const scene::ReadingProcess& process = {});

// Filter and addressing that Unity reads out of a sampler's name: Point, Linear or Trilinear, and Clamp or
// Repeat, in any case and order (Unity manual, "Using sampler states", inline sampler states). Empty for
// names with Compare or Mirror, and for those that say not enough.
std::optional<gpu::SamplerKind> inline_sampler(const std::string& name);

// On a device. A texture's channels are 0 to 1 as the file stores them; no colour space is undone.
class AdapterResources {
 public:
  AdapterResources(const gpu::Device& device, const std::vector<AdapterTexture>& textures);

  std::map<std::string, const gpu::Image*> images() const;

  // Of a name: an inline one, or "sampler" and a texture's name, which repeats and filters. Null for others.
  const gpu::Sampler* sampler(const std::string& name);

  // TEXTURE_TexelSize (1/width, 1/height, width, height) and TEXTURE_ST (1, 1, 0, 0) of every texture.
  const UniformValues& uniforms() const { return uniforms_; }

 private:
  const gpu::Sampler* kept(gpu::SamplerKind kind);

  const gpu::Device* device_;
  std::map<std::string, gpu::Image> images_;
  std::map<gpu::SamplerKind, gpu::Sampler> samplers_;
  UniformValues uniforms_;
};

}  // namespace penumbra::resolve
