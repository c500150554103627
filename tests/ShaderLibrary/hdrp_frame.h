// Runs HLSL of Pipelines/Hdrp.hlsl on the GPU with HDRP's globals filled in, by way of the stand-in
// declarations of tools/programs/shaders/unity.
//
//   HdrpFrame frame;
//   frame.shadows = {cascade};
//   std::vector<float> scales = run({"Out(0, PenumbraHdrpTile(_HDShadowDatas[caseIndex],
//   In(0)).uvPerMetre);", 1, 1},
//                                   HdrpVersion::v14, DepthDirection::reversed, frame, inputs);
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <utility>
#include <vector>

#include "ShaderLibrary/core_function.h"
#include "project/package_root.h"

namespace penumbra::shader_library_tests {

// The declarations that the stand-in gives: those of HDRP 14, with the parameters HDRP 17 packs, or with
// arrays of six cascades.
enum class HdrpVersion { v14, v17, six_cascades };
constexpr HdrpVersion kHdrpVersions[] = {HdrpVersion::v14, HdrpVersion::v17, HdrpVersion::six_cascades};

using HdrpDefines = std::vector<std::pair<std::string, std::string>>;

// The macros by which a shader sees that version, as Unity's own version would tell it.
HdrpDefines defines_of(HdrpVersion version);
std::vector<project::PackageRoot> hdrp_package_roots();

// One element of _HDShadowDatas; what the binding does not read is left out.
struct HdrpShadow {
  std::array<glm::vec4, 3> view{};  // rot0..2, and pos in w
  glm::vec4 projection{};           // m00, m11, m22, m23
  glm::vec2 atlas_offset{};
  float world_texel_size = 0.0f;
  float normal_bias = 0.0f;
  glm::vec2 tile_texels{};
  std::int32_t blocker_samples = 0;
  std::int32_t filter_samples = 0;
  glm::vec4 params0{};
  glm::vec4 params1{};
  glm::vec3 cache_translation{};
};

struct HdrpFrame {
  std::vector<HdrpShadow> shadows;
  std::vector<glm::vec4> spheres;  // centre and squared radius of each cascade
  std::vector<float> borders;
  glm::vec2 atlas_texels{1.0f};
  std::vector<float> atlas;       // stored depths, row by row; for shaders that read the map
  std::int32_t shadow_index = 0;  // _DirectionalShadowIndex
  std::int32_t first_shadow = 0;  // the sun's first shadow in _HDShadowDatas
  glm::vec3 forward{0.0f, -1.0f, 0.0f};
  float dimmer = 1.0f;
  glm::vec4 main_light_params{};
  std::array<glm::vec4, 2>
      pcss{};  // vectors of ShaderLibrary/Filters/Peers/Parameters/PcssHdrpParameters.hlsl
};

struct HdrpFunction {
  std::string statement;  // reads In(i) and caseIndex, writes Out(i, float)
  int inputs = 1;         // words per case
  int outputs = 1;
  HdrpDefines defines = {};
};

// The caller says whether the depth is reversed: the projections tell it, and so does the shader's macro.
std::vector<float> run(const HdrpFunction& function, HdrpVersion version, DepthDirection direction,
                       const HdrpFrame& frame, const std::vector<float>& inputs);

}  // namespace penumbra::shader_library_tests
