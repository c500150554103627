// A debug view of the renderer feature over a frame, as Unity would draw it over the camera's picture.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "resolve/camera_image.h"
#include "resolve/frame_on_device.h"
#include "resolve/program_on_device.h"
#include "shaders/package_shader.h"

namespace penumbra::resolve {

class DebugView {
 public:
  // `view` is a pass of the shader and is compiled as a graph is. Throws InputError if the shader lacks it.
  DebugView(const gpu::Device& device, const shaders::PackageShader& shader, const std::string& view,
            bool reversed_z, const Compiler& compiler = {});

  const std::string& key() const { return key_; }  // a hash of its program

  // Returns colours in [0, 1], rows from the top. Visibility and mask come as a chain's result holds them; an
  // empty mask means that the frame had none. `parameters` are those of the technique that made the
  // visibility. The picture may begin with another row than the camera's textures, as a back buffer does.
  std::vector<glm::vec3> draw(const FrameOnDevice& frame, const CameraImage& camera,
                              const std::vector<float>& visibility,
                              const std::vector<std::uint8_t>& masked_out, const UniformValues& parameters,
                              std::optional<RowOrder> picture = std::nullopt);

 private:
  DebugView(const gpu::Device& device, CompiledProgram program);

  const gpu::Device& device_;
  std::string key_;
  ProgramOnDevice program_;
};

}  // namespace penumbra::resolve
