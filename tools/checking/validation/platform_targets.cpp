#include "validation/platform_targets.h"

#include <map>
#include <utility>

#include "shaders/cross_compile.h"
#include "validation/spirv_target.h"

namespace penumbra::validation {

namespace {

// Returns the graphics API whose shaders a target is for.
variants::GraphicsApi api_of(const std::string& target) {
  const std::optional<shaders::Target> known = shaders::find_target(target);
  if (target == fxc_target) return variants::GraphicsApi::d3d11;
  if (!known) return variants::GraphicsApi::vulkan;
  switch (shaders::target_language(*known)) {
    case shaders::TargetLanguage::essl:
      return variants::GraphicsApi::gles3;
    case shaders::TargetLanguage::glsl:
      return variants::GraphicsApi::glcore;
    case shaders::TargetLanguage::msl:
      return variants::GraphicsApi::metal;
    case shaders::TargetLanguage::hlsl:
      break;
  }
  return variants::GraphicsApi::d3d11;
}

}  // namespace

std::vector<PlatformTargets> platform_targets(const std::vector<std::string>& targets,
                                              const PlatformChoice& choice) {
  std::map<variants::GraphicsApi, std::vector<std::string>> of_api;
  for (const std::string& target : targets)
    of_api[choice.api ? *choice.api : api_of(target)].push_back(target);
  std::vector<PlatformTargets> list;
  for (const auto& [api, made] : of_api) {
    variants::Platform platform;
    platform.api = api;
    platform.mobile = choice.mobile || api == variants::GraphicsApi::gles3;
    platform.unity_version = choice.unity_version;
    for (auto& [vulkan, of_version] : by_vulkan_version(made))
      list.push_back({platform, std::move(of_version), vulkan});
  }
  return list;
}

}  // namespace penumbra::validation
