#include "variants/platform_defines.h"

#include <algorithm>
#include <charconv>

namespace penumbra::variants {
namespace {

struct ApiNames {
  GraphicsApi api;
  const char* renderer;
  const char* macro;
};

constexpr ApiNames api_names[] = {{GraphicsApi::d3d11, "d3d11", "SHADER_API_D3D11"},
                                  {GraphicsApi::vulkan, "vulkan", "SHADER_API_VULKAN"},
                                  {GraphicsApi::metal, "metal", "SHADER_API_METAL"},
                                  {GraphicsApi::glcore, "glcore", "SHADER_API_GLCORE"},
                                  {GraphicsApi::gles3, "gles3", "SHADER_API_GLES3"},
                                  {GraphicsApi::nintendo_switch, "switch", "SHADER_API_SWITCH"}};

const ApiNames& names_of(GraphicsApi api) {
  return *std::find_if(std::begin(api_names), std::end(api_names),
                       [&](const ApiNames& names) { return names.api == api; });
}

std::string stage_macro(hlsl::Stage stage) {
  std::string macro = "SHADER_STAGE_";
  for (const char* c = hlsl::stage_name(stage); *c != '\0'; ++c) macro += static_cast<char>(*c - 'a' + 'A');
  return macro;
}

}  // namespace

const char* renderer_name(GraphicsApi api) {
  return names_of(api).renderer;
}

bool keeps_stage_keywords(GraphicsApi api) {
  return api != GraphicsApi::vulkan && api != GraphicsApi::glcore && api != GraphicsApi::gles3;
}

std::optional<GraphicsApi> find_graphics_api(std::string_view renderer) {
  for (const ApiNames& names : api_names)
    if (renderer == names.renderer) return names.api;
  return std::nullopt;
}

std::optional<int> unity_version_number(std::string_view version) {
  int parts[3] = {0, 0, 0};
  const char* at = version.data();
  const char* const end = at + version.size();
  for (int i = 0; i < 3; ++i) {
    if (i == 2 && at == end) break;  // "2022.3"
    if (i > 0 && (at == end || *at++ != '.')) return std::nullopt;
    const auto [next, error] = std::from_chars(at, end, parts[i]);
    if (error != std::errc() || parts[i] < 0) return std::nullopt;
    at = next;
  }
  const auto [major, minor, patch] = parts;
  if (major >= 6000 && major < 10000) {
    if (minor > 999 || patch > 9999) return std::nullopt;
    return (major / 1000) * 10'000'000 + minor * 10'000 + patch;
  }
  if (major < 2017 || major > 2100) return std::nullopt;
  return major * 100 + std::min(minor, 9) * 10 + std::min(patch, 9);
}

std::map<std::string, std::string> pragma_defines(const Platform& platform) {
  std::map<std::string, std::string> defines;
  defines[names_of(platform.api).macro] = "1";
  defines["UNITY_VERSION"] = std::to_string(platform.unity_version);
  if (platform.api != GraphicsApi::nintendo_switch)
    defines[platform.mobile ? "SHADER_API_MOBILE" : "SHADER_API_DESKTOP"] = "1";
  return defines;
}

std::map<std::string, std::string> platform_defines(const Platform& platform, hlsl::Stage stage,
                                                    int shader_target) {
  std::map<std::string, std::string> defines = pragma_defines(platform);
  const GraphicsApi api = platform.api;
  defines[stage_macro(stage)] = "1";
  defines["SHADER_TARGET"] = std::to_string(shader_target);
  if (api == GraphicsApi::glcore || api == GraphicsApi::gles3) defines["SHADER_TARGET_GLSL"] = "1";
  if (platform.includes_hlsl_support) return defines;
  defines["UNITY_COMPILER_HLSL"] = "1";
  if (api != GraphicsApi::d3d11 && api != GraphicsApi::nintendo_switch)
    defines["UNITY_COMPILER_HLSLCC"] = "1";
  return defines;
}

}  // namespace penumbra::variants
