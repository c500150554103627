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
  std::string name;  // the name that the shader declares
  scene::Texture picture;
};

// The texture is a picture's file, or one of Unity's default textures: white, black, gray, grey, red, bump.
// Throws InputError as scene::read_image_apart() does, and for a file that is not there, with the names of
// the default textures.
AdapterTexture adapter_texture(const std::string& name, const std::string& file_or_default,
                               const scene::ReadingProcess& process = {});

// Returns the filter and addressing that Unity reads out of a sampler's name: Point, Linear or Trilinear, and
// Clamp or Repeat, in any case and order (Unity manual, "Using sampler states", inline sampler states). The
// result is empty for names with Compare or Mirror, and for names without a filter and an addressing.
std::optional<gpu::SamplerKind> inline_sampler(const std::string& name);

// The adapter's textures and samplers on a device. A texture's channels are 0 to 1 as the file stores them;
// no colour space is converted.
class AdapterResources {
 public:
  AdapterResources(const gpu::Device& device, const std::vector<AdapterTexture>& textures);

  std::map<std::string, const gpu::Image*> images() const;

  // Returns the sampler of a name: an inline one, or that of "sampler" and a texture's name, which repeats
  // and filters. Returns null for other names.
  const gpu::Sampler* sampler(const std::string& name);

  // These hold TEXTURE_TexelSize (1/width, 1/height, width, height) and TEXTURE_ST (1, 1, 0, 0) of every
  // texture.
  const UniformValues& uniforms() const { return uniforms_; }

 private:
  const gpu::Sampler* kept(gpu::SamplerKind kind);

  const gpu::Device* device_;
  std::map<std::string, gpu::Image> images_;
  std::map<gpu::SamplerKind, gpu::Sampler> samplers_;
  UniformValues uniforms_;
};

}  // namespace penumbra::resolve
