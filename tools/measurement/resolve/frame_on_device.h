// A Frame as shaders see it: atlas, receivers and samplers on the device, cascade constants by name.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <map>
#include <optional>
#include <string>

#include "gpu/resources.h"
#include "resolve/camera_image.h"
#include "resolve/casters_on_device.h"
#include "resolve/frame_inputs.h"
#include "resolve/graph_resources.h"
#include "resolve/uniform_values.h"
#include "scene/frame.h"

namespace penumbra::resolve {

class FrameOnDevice {
 public:
  // `casters` is for graphs that draw them, `inputs` for graphs with needs. Both are kept by reference.
  FrameOnDevice(const gpu::Device& device, const scene::Frame& frame,
                const CastersOnDevice* casters = nullptr, const FrameInputs* inputs = nullptr);

  int width() const { return width_; }
  int height() const { return height_; }

  // The resources that a shader may bind by name, under the harness's names and URP's for the same things.
  std::map<std::string, const gpu::Buffer*> buffers() const;
  std::map<std::string, const gpu::Image*> images() const;
  std::map<std::string, const gpu::Sampler*> samplers() const;
  // Returns whether the sampler of that name compares; empty for names that samplers() lacks.
  static std::optional<bool> sampler_compares(const std::string& name);
  UniformValues uniforms(int noise_frame) const;
  const MapLayout& map_layout() const { return map_layout_; }

  const CastersOnDevice* casters() const { return casters_; }
  const gpu::Image& atlas() const { return atlas_; }
  // Returns unity_MatrixVP, from world space to the clip space of the cascade's tile; and _ShadowBias and
  // _LightDirection as URP sets them for its own casters.
  UniformValues caster_uniforms(int cascade) const;
  // Returns unity_MatrixVP of the camera.
  static UniformValues caster_uniforms(const CameraImage& camera);

  const gpu::Buffer& visibility() const { return visibility_; }

 private:
  const CastersOnDevice* casters_;
  const FrameInputs* inputs_;
  parameters::CascadeSet cascades_;
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
  glm::vec4 main_light_params_;  // for Pipelines/Urp.hlsl, at frame 0
};

}  // namespace penumbra::resolve
