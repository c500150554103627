#include "variants/platform_defines.h"

#include <algorithm>
#include <cctype>
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

std::string in_capitals(std::string_view word) {
  std::string capitals(word);
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return capitals;
}

constexpr const char* desktop_settings[] = {"UNITY_PBS_USE_BRDF1",
                                            "UNITY_SPECCUBE_BLENDING",
                                            "UNITY_SPECCUBE_BOX_PROJECTION",
                                            "UNITY_ENABLE_DETAIL_NORMALMAP",
                                            "UNITY_LIGHT_PROBE_PROXY_VOLUME",
                                            "UNITY_USE_DITHER_MASK_FOR_ALPHABLENDED_SHADOWS"};
constexpr const char* mobile_settings[] = {"UNITY_PBS_USE_BRDF2", "UNITY_NO_DXT5nm",
                                           "UNITY_NO_SCREENSPACE_SHADOWS"};
constexpr const char* lightmap_encodings[] = {"UNITY_LIGHTMAP_DLDR_ENCODING", "UNITY_LIGHTMAP_RGBM_ENCODING",
                                              "UNITY_LIGHTMAP_FULL_HDR"};

constexpr std::string_view light_modes[] = {"FORWARDBASE",  "FORWARDADD",   "DEFERRED", "PREPASSBASE",
                                            "PREPASSFINAL", "SHADOWCASTER", "META",     "MOTIONVECTORS"};

constexpr std::pair<const char*, const char*> renamed[] = {{"_Object2World", "unity_ObjectToWorld"},
                                                           {"_World2Object", "unity_WorldToObject"},
                                                           {"unity_World2Shadow", "unity_WorldToShadow"},
                                                           {"_LightMatrix0", "unity_WorldToLight"},
                                                           {"_Projector", "unity_Projector"},
                                                           {"_ProjectorClip", "unity_ProjectorClip"}};

constexpr int unity_6_0 = 60'000'000;
constexpr int unity_6_3 = 60'030'000;

// Returns the macro of the build target as far as the graphics API tells it, else an empty text.
std::string build_target(const Platform& platform) {
  switch (platform.api) {
    case GraphicsApi::nintendo_switch:
      return "UNITY_PLATFORM_SWITCH";
    case GraphicsApi::metal:
      return platform.mobile ? "UNITY_PLATFORM_IOS" : "UNITY_PLATFORM_OSX";
    case GraphicsApi::vulkan:
    case GraphicsApi::gles3:
      return platform.mobile ? "UNITY_PLATFORM_ANDROID" : "";
    case GraphicsApi::d3d11:
    case GraphicsApi::glcore:
      return "";
  }
  return "";
}

void add_names_of_version(const Platform& platform, std::map<std::string, std::string>& defines) {
  if (platform.unity_version < unity_6_0 && platform.mobile) defines["UNITY_NO_RGBM"] = "1";
  if (platform.unity_version >= unity_6_0 && platform.api == GraphicsApi::d3d11 && !platform.mobile)
    defines["UNITY_PLATFORM_SUPPORTS_DEPTH_FETCH"] = "1";
  const std::string target = build_target(platform);
  if (platform.unity_version >= unity_6_3 && !target.empty()) defines[target] = "1";
}

void add_settings(const Platform& platform, std::map<std::string, std::string>& defines) {
  defines["UNITY_ENABLE_REFLECTION_BUFFERS"] = "1";
  if (platform.mobile)
    for (const char* name : mobile_settings) defines[name] = "1";
  else
    for (const char* name : desktop_settings) defines[name] = "1";
  if (platform.gamma) defines["UNITY_COLORSPACE_GAMMA"] = "1";
  const LightmapEncoding usual = platform.mobile ? LightmapEncoding::dldr : LightmapEncoding::full_hdr;
  defines[lightmap_encodings[static_cast<int>(platform.lightmaps.value_or(usual))]] = "1";
  const std::string mode = in_capitals(platform.light_mode);
  if (std::find(std::begin(light_modes), std::end(light_modes), mode) != std::end(light_modes))
    defines["UNITY_PASS_" + mode] = "1";
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
  add_settings(platform, defines);
  add_names_of_version(platform, defines);
  return defines;
}

std::map<std::string, std::string> platform_defines(const Platform& platform, hlsl::Stage stage,
                                                    int shader_target) {
  std::map<std::string, std::string> defines = pragma_defines(platform);
  const GraphicsApi api = platform.api;
  defines["SHADER_STAGE_" + in_capitals(hlsl::stage_name(stage))] = "1";
  defines["SHADER_TARGET"] = std::to_string(shader_target);
  if (api == GraphicsApi::glcore || api == GraphicsApi::gles3) defines["SHADER_TARGET_GLSL"] = "1";
  if (platform.includes_hlsl_support) {
    for (const auto& [old, name] : renamed) defines[old] = name;
    return defines;
  }
  defines["UNITY_COMPILER_HLSL"] = "1";
  if (api != GraphicsApi::d3d11 && api != GraphicsApi::nintendo_switch)
    defines["UNITY_COMPILER_HLSLCC"] = "1";
  return defines;
}

}  // namespace penumbra::variants
