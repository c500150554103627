// A Frame as shaders see it: atlas, receivers and samplers on the device, cascade constants by name.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <map>
#include <optional>
#include <string>

#include "gpu/resources.h"
#include "resolve/map_layout.h"
#include "resolve/uniform_values.h"
#include "scene/frame.h"

namespace penumbra::resolve {

class FrameOnDevice {
 public:
  FrameOnDevice(const gpu::Device& device, const scene::Frame& frame);

  int width() const { return width_; }
  int height() const { return height_; }

  // What a shader may bind by name: the harness's names and URP's for the same things.
  std::map<std::string, const gpu::Buffer*> buffers() const;
  std::map<std::string, const gpu::Image*> images() const;
  std::map<std::string, const gpu::Sampler*> samplers() const;
  // Whether the one of that name compares; empty for names that samplers() lacks.
  static std::optional<bool> sampler_compares(const std::string& name);
  UniformValues uniforms(int noise_frame) const;
  const MapLayout& map_layout() const { return map_layout_; }

  const gpu::Buffer& visibility() const { return visibility_; }

 private:
  int width_;
  int height_;
  MapLayout map_layout_;
  gpu::Image atlas_;
  gpu::Sampler compare_;
  gpu::Sampler point_;
  gpu::Sampler linear_;
  gpu::Buffer positions_;
  gpu::Buffer normals_;
  gpu::Buffer visibility_;
  UniformValues uniforms_;
  glm::vec4 main_light_params_;  // of Pipelines/Urp.hlsl, at frame 0
};

}  // namespace penumbra::resolve
