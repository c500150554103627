// What the GPU rasterises of a scene for one light and one set of map settings: the cascade atlas and the
// receivers seen by the camera. Everything after this room starts from a Frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "parameters/cascades.h"
#include "scene/scene.h"

namespace penumbra::gpu {
class Device;
}

namespace penumbra::scene {

enum class DepthFormat { d16, d24, d32 };

// The cascade atlas as the shader will see it. depth[y * width + x] is the stored value decoded to float;
// row 0 is v = 0. texels holds the same in the format's own bits, for a bit-exact upload (d24: 32 bits per
// texel, depth in the low 24).
struct ShadowAtlas {
  int width = 0;
  int height = 0;
  DepthFormat format = DepthFormat::d32;
  std::vector<float> depth;
  std::vector<std::byte> texels;
};

// One record per pixel, row 0 at the top of the picture. position_ws.w is 1 where a surface within the shadow
// distance was seen, else 0. normal_ws is the geometric (flat) normal, unit, turned to the camera.
struct Receivers {
  int width = 0;
  int height = 0;
  std::vector<glm::vec4> position_ws;
  std::vector<glm::vec4> position_relative;  // the same relative to Scene::origin: exact far from it too
  std::vector<glm::vec4> normal_ws;
};

struct FrameSettings {
  parameters::ShadowSettings shadows;
  double angular_diameter_degrees = 0.53;
  DepthFormat format = DepthFormat::d32;
  int width = 480;   // of the receivers
  int height = 270;
};

struct Frame {
  std::string scene_name;
  parameters::Camera camera;        // world space (origin added)
  parameters::CascadeSet cascades;
  FrameSettings settings;
  ShadowAtlas atlas;
  Receivers receivers;
};

// Casters are drawn as URP draws them: depth and normal bias applied to the caster's vertices, clamped to the
// near plane ("pancaking"), both faces. Throws EnvironmentError when the device lacks the depth format.
Frame rasterise(gpu::Device& device, const Scene& scene, const FrameSettings& settings);

}  // namespace penumbra::scene
