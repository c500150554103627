// The settings of a project that hold for every shader: the colour space and the encoding of lightmaps
// (ProjectSettings.asset), and ShaderBuildSettings of Unity 6000.3 and later (GraphicsSettings.asset), which
// change the keyword sets that shaders declare, define constants and choose the compiler of a graphics API.
//
// Source: Unity Scripting API, UnityEditor.Shaders.ShaderBuildSettings; the fields' names are those of its
// serialised members (UnityCsReference, ShaderBuildSettings.cs). A build profile may have settings of its
// own, which take the place of these in the editor; they are not read.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "variants/platform_defines.h"
#include "variants/pragmas.h"

namespace penumbra::variants {

struct KeywordOverride {
  enum class Mode { as_declared, shader_feature, multi_compile, dynamic_branch };
  Mode mode = Mode::as_declared;
  Keywords keywords;  // of the set that it is for, in any order; "_" for the empty keyword
  Keywords dropped;   // those of them that are not kept in builds
};

struct BuildSettings {
  std::vector<KeywordOverride> overrides;
  std::vector<std::pair<std::string, std::string>> defines;
  std::map<GraphicsApi, bool> dxc;  // true for DXC, false for FXC; Unity's choice for others
  bool gamma = false;
  std::optional<LightmapEncoding> desktop_lightmaps;
  std::optional<LightmapEncoding> mobile_lightmaps;
};

// Adds the settings of one of the two files. Throws InputError with the line of a wrong value.
void parse_build_settings(std::string_view text, const std::string& file, BuildSettings& settings);

// Returns nothing set for a project without these files.
BuildSettings read_build_settings(const std::filesystem::path& project);

void apply_settings(const BuildSettings& settings, Platform& platform);

// Changes the sets that have exactly the keywords of an override.
void apply_overrides(const std::vector<KeywordOverride>& overrides, Pragmas& pragmas);

}  // namespace penumbra::variants
