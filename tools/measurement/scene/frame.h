// The GPU's output for a scene, a light and map settings: the cascade atlas and the receivers that the camera
// sees. All later steps start from a Frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "parameters/cascades.h"
#include "parameters/receiver_fit.h"
#include "parameters/spot_light.h"
#include "scene/scene.h"
#include "scene/stand_ins.h"

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

constexpr std::uint32_t no_triangle = 0xFFFF'FFFFU;

// One record per pixel, row 0 at the top of the picture. position_ws.w is 1 where a surface within the shadow
// distance, or the scene's seen distance, was seen, else 0. normal_ws is the geometric (flat) normal, unit,
// turned to the camera. `triangle` is that of the surface seen at any distance, and no_triangle where there
// is none.
struct Receivers {
  int width = 0;
  int height = 0;
  std::vector<glm::vec4> position_ws;
  std::vector<glm::vec4> position_relative;  // the same relative to Scene::origin: exact far from it too
  std::vector<glm::vec4> normal_ws;
  std::vector<std::uint32_t> triangle{};
};

// The rasteriser's bias away from the light, which is added to each caster's depth in addition to the bias of
// the vertices. The first is in smallest steps of the format, the second is multiplied by the largest change
// of depth from texel to texel.
struct RasterBias {
  double constant = 0.0;
  double slope = 0.0;

  bool operator==(const RasterBias&) const = default;
};

// The bias with which URP (ShadowUtils.RenderShadowSlice) and HDRP (HDShadowAtlas, at the light component's
// default) draw their casters.
inline constexpr RasterBias kUnityRasterBias{1.0, 2.5};

// The transition between two cascades, across a share of the split sphere's radius. If `mixed` is true, each
// pixel has a mixture of both results; otherwise noise gives it one of them.
struct CascadeBlend {
  double border = 0.0;
  bool mixed = false;

  bool operator==(const CascadeBlend&) const = default;
};

struct CascadeChoices {
  // A fit to the receivers is a fit to those of this frame.
  parameters::LightFit light_fit = parameters::LightFit::sphere;
  CascadeBlend blend;
  // The degrees of the sky by which the sun has moved on (sun_before) since the cascades were fitted and
  // drawn.
  double map_age_degrees = 0.0;

  bool operator==(const CascadeChoices&) const = default;
};

struct FrameSettings {
  parameters::ShadowSettings shadows;
  CascadeChoices cascade_choices;
  double angular_diameter_degrees = 0.53;  // the sun's
  RasterBias raster_bias;                  // no bias
  DepthFormat format = DepthFormat::d32;
  int width = 480;  // size of the receivers' picture
  int height = 270;
  // The lens shift in half pictures to the right and up: the projection of an eye of a headset, or of Unity's
  // Camera.lensShift, is not symmetric. Cascades are fitted without it.
  glm::dvec2 lens_shift{0.0};
};

inline constexpr std::size_t kMostBalls = 16;

struct Frame {
  std::string scene_name;
  parameters::Camera camera;  // world space (origin added)
  // light_direction is that of the light in which the map was drawn.
  parameters::CascadeSet cascades;
  // A spot light's map in world space, in place of the cascades; no scene has one, and tests of filters do.
  std::optional<parameters::SpotShadow> spot_shadow;
  FrameSettings settings;
  ShadowAtlas atlas;
  Receivers receivers;
  double ground_metres = 0.0;  // ground_level() in world space
  std::vector<Ball> balls;     // object_balls() in world space, at most kMostBalls
};

// A scene on the device: its mesh is uploaded and its shaders are compiled once for any number of frames.
//
// Casters are drawn as URP draws them: depth and normal bias applied to the caster's vertices, clamped to the
// near plane ("pancaking"), both faces; with URP's bias of the rasteriser when raster_bias is
// kUnityRasterBias. Vertices are relative to Scene::origin and the matrix that takes them to the map is made
// in double, so the map of a scene far from the world's origin is as exact as one near it; what Unity loses
// by float world positions shows in Receivers::position_ws.
//
// Without depth_range_metres and caster_bounds in the settings, the scene's bounds are the caster bounds: no
// caster is clamped to the near plane, so that no blocker's depth gap is cut short.
//
// Where a material is cut out (CutOut, material.h), neither the map nor the camera sees the surface.
//
// Receivers lie on their triangle's plane to the rounding of the float. The shadow distance is measured from
// the camera, as URP fades by it.
class Rasteriser {
 public:
  // The constructor keeps a reference to both. Throws InputError for a mesh without triangles or with an
  // index out of range, and for cut-outs as CutOuts does.
  Rasteriser(gpu::Device& device, const Scene& scene);
  ~Rasteriser();
  Rasteriser(Rasteriser&&) noexcept;

  // Throws InputError for a setting out of range, and EnvironmentError when the device lacks the depth
  // format.
  Frame frame(const FrameSettings& settings);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Draws one frame of a scene that needs no further ones.
Frame rasterise(gpu::Device& device, const Scene& scene, const FrameSettings& settings);

}  // namespace penumbra::scene
