#include "variants/pragma_names.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "hlsl/name_set.h"

namespace penumbra::variants {

namespace {

constexpr std::pair<std::string_view, KeywordPragmaName::Base> bases[] = {
    {"multi_compile", KeywordPragmaName::Base::multi_compile},
    {"shader_feature", KeywordPragmaName::Base::shader_feature},
    {"dynamic_branch", KeywordPragmaName::Base::dynamic_branch}};

constexpr std::string_view stage_suffixes[] = {"vertex", "fragment", "hull",
                                               "domain", "geometry", "raytracing"};

const std::vector<std::string>& read_pragmas() {
  static const std::vector<std::string> names = hlsl::names_in(
      "vertex fragment geometry hull domain surface kernel target require only_renderers "
      "exclude_renderers skip_variants hardware_tier_variants instancing_options");
  return names;
}

const std::vector<std::string>& option_pragmas() {
  static const std::vector<std::string> names = hlsl::names_in(
      "editor_sync_compilation enable_d3d11_debug_symbols enable_debug_symbols "
      "enable_vulkan_debug_symbols enable_ray_tracing_shader_debug_symbols skip_optimizations "
      "hlslcc_bytecode_disassembly disable_fastmath enable_cbuffer prefer_hlslcc use_dxc never_use_dxc "
      "require_dxc glsl glsl_es2 glsl_no_auto_normalization fragmentoption profileoption "
      "force_concat_matrix raytracing max_recursion_depth once warning pack_matrix message def "
      "ruledisable dxc debug PSSL_target_output_format");
  return names;
}

std::vector<std::string> all_names() {
  std::vector<std::string> names = read_pragmas();
  names.insert(names.end(), option_pragmas().begin(), option_pragmas().end());
  for (const std::string& name : built_in_set_names()) names.push_back(name);
  for (const auto& [base, kind] : bases) {
    for (const std::string local : {"", "_local"}) {
      names.push_back(std::string(base) + local);
      for (const std::string_view stage : stage_suffixes)
        names.push_back(std::string(base) + local + "_" + std::string(stage));
    }
  }
  return names;
}

using Alternatives = std::vector<Keywords>;

Alternatives free_choice(const std::string& keyword) {
  return {{}, {keyword}};
}

BuiltInSets with_free(BuiltInSets sets, const Keywords& keywords) {
  for (const std::string& keyword : keywords) sets.sets.push_back(free_choice(keyword));
  return sets;
}

const Alternatives& light_types() {
  static const Alternatives types{
      {"POINT"}, {"DIRECTIONAL"}, {"SPOT"}, {"POINT_COOKIE"}, {"DIRECTIONAL_COOKIE"}};
  return types;
}

Alternatives shadowed_light_types() {
  Alternatives types = light_types();
  types.insert(types.end(), {{"SPOT", "SHADOWS_DEPTH"},
                             {"SPOT", "SHADOWS_DEPTH", "SHADOWS_SOFT"},
                             {"DIRECTIONAL", "SHADOWS_SCREEN"},
                             {"DIRECTIONAL_COOKIE", "SHADOWS_SCREEN"},
                             {"POINT", "SHADOWS_CUBE"},
                             {"POINT", "SHADOWS_CUBE", "SHADOWS_SOFT"},
                             {"POINT_COOKIE", "SHADOWS_CUBE"},
                             {"POINT_COOKIE", "SHADOWS_CUBE", "SHADOWS_SOFT"}});
  return types;
}

BuiltInSets lightmapped(BuiltInSets sets) {
  sets = with_free(std::move(sets), {"LIGHTMAP_ON", "DIRLIGHTMAP_COMBINED", "DYNAMICLIGHTMAP_ON"});
  sets.clauses.push_back(needs("DIRLIGHTMAP_COMBINED", {"LIGHTMAP_ON", "DYNAMICLIGHTMAP_ON"},
                               "directional lightmaps need a lightmap"));
  return sets;
}

BuiltInSets every_light() {
  return with_free({{shadowed_light_types()}, {}}, {"LIGHTMAP_SHADOW_MIXING", "SHADOWS_SHADOWMASK"});
}

BuiltInSets forward_base() {
  return with_free(
      lightmapped({{{{"DIRECTIONAL"}}}, {}}),
      {"LIGHTMAP_SHADOW_MIXING", "SHADOWS_SHADOWMASK", "SHADOWS_SCREEN", "LIGHTPROBE_SH", "VERTEXLIGHT_ON"});
}

BuiltInSets forward_base_alpha() {
  return with_free(lightmapped({{{{"DIRECTIONAL"}}}, {}}),
                   {"LIGHTMAP_SHADOW_MIXING", "LIGHTPROBE_SH", "VERTEXLIGHT_ON"});
}

BuiltInSets prepass_final() {
  return with_free(lightmapped({}), {"UNITY_HDR_ON", "SHADOWS_SHADOWMASK", "LIGHTPROBE_SH"});
}

struct Shortcut {
  const char* name;
  std::function<BuiltInSets()> sets;
};

BuiltInSets one_set(const Alternatives& alternatives) {
  return {{alternatives}, {}};
}

const std::vector<Shortcut>& shortcuts() {
  static const std::vector<Shortcut> known{
      {"multi_compile_fog",
       [] {
         return one_set({{}, {"FOG_LINEAR"}, {"FOG_EXP"}, {"FOG_EXP2"}});
       }},
      {"multi_compile_instancing", [] { return one_set(free_choice("INSTANCING_ON")); }},
      {"multi_compile_particles", [] { return one_set(free_choice("SOFTPARTICLES_ON")); }},
      {"multi_compile_shadowcaster",
       [] {
         return one_set({{"SHADOWS_DEPTH"}, {"SHADOWS_CUBE"}});
       }},
      {"multi_compile_shadowcollector", [] { return BuiltInSets{}; }},
      {"multi_compile_fwdadd", [] { return one_set(light_types()); }},
      {"multi_compile_fwdadd_fullshadows", every_light},
      {"multi_compile_lightpass", every_light},
      {"multi_compile_fwdbase", forward_base},
      {"multi_compile_fwdbasealpha", forward_base_alpha},
      {"multi_compile_prepassfinal", prepass_final}};
  return known;
}

}  // namespace

std::optional<KeywordPragmaName> keyword_pragma_name(std::string_view name) {
  for (const auto& [base, kind] : bases) {
    if (name.substr(0, base.size()) != base) continue;
    std::string_view rest = name.substr(base.size());
    if (!rest.empty() && rest.front() != '_') return std::nullopt;
    KeywordPragmaName result;
    result.base = kind;
    StageSet stages;
    std::vector<std::string_view> seen;
    while (!rest.empty()) {
      const std::string_view suffix = rest.substr(1, rest.find('_', 1) - 1);
      rest.remove_prefix(1 + suffix.size());
      if (std::find(seen.begin(), seen.end(), suffix) != seen.end()) return std::nullopt;
      if (suffix == "local") {
        result.local = true;
      } else if (std::find(std::begin(stage_suffixes), std::end(stage_suffixes), suffix) ==
                 std::end(stage_suffixes)) {
        return std::nullopt;
      } else if (const std::optional<hlsl::Stage> stage = hlsl::find_stage(suffix)) {
        stages.add(*stage);
      }
      seen.push_back(suffix);
    }
    const bool for_all_stages = seen.size() == (result.local ? 1 : 0);
    if (!for_all_stages) result.stages = stages;
    return result;
  }
  return std::nullopt;
}

bool is_option_pragma(std::string_view name) {
  const std::vector<std::string>& names = option_pragmas();
  return std::find(names.begin(), names.end(), name) != names.end();
}

const std::vector<std::string>& pragma_names() {
  static const std::vector<std::string> names = all_names();
  return names;
}

const std::vector<std::string>& renderer_names() {
  static const std::vector<std::string> names = hlsl::names_in(
      "d3d11 d3d11_9x d3d9 xboxone xboxseries gamecore glcore opengl gles gles3 metal vulkan ps4 ps5 "
      "playstation psp2 switch switch2 wiiu n3ds webgpu nomrt xbox360 ps3");
  return names;
}

const std::vector<std::string>& feature_names() {
  static const std::vector<std::string> names = hlsl::names_in(
      "interpolators10 interpolators15 interpolators32 integers mrt4 mrt8 derivatives samplelod "
      "fragcoord 2darray cubearray instancing geometry tessellation compute randomwrite tesshw msaatex "
      "sparsetex framebufferfetch fbfetch inlineraytracing setrtarrayindexfromanyshader wavebasic "
      "wavevote waveballot wavemath wavemultiprefix quadshuffle int64 int64bufferatomics "
      "int64groupsharedatomics native16bit barycentrics variable_rate_shading");
  return names;
}

const std::vector<std::string>& instancing_option_names() {
  static const std::vector<std::string> names = hlsl::names_in(
      "forcemaxcount maxcount assumeuniformscaling nolodfade nolightprobe nolightmap renderinglayer "
      "procedural lodfade norenderinglayer nomatrices");
  return names;
}

std::optional<int> shader_model(std::string_view name) {
  if (name == "es3.0") return 35;
  if (name == "es3.1") return 45;
  if (name == "gl4.1") return 46;
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  if (name.size() != 3 || name[1] != '.' || !digit(name[0]) || !digit(name[2])) return std::nullopt;
  const int model = (name[0] - '0') * 10 + (name[2] - '0');
  return model >= 20 && model < 70 ? std::optional<int>(model) : std::nullopt;
}

std::optional<BuiltInSets> built_in_sets(std::string_view pragma) {
  for (const Shortcut& shortcut : shortcuts())
    if (pragma == shortcut.name) return shortcut.sets();
  return std::nullopt;
}

std::vector<std::string> built_in_set_names() {
  std::vector<std::string> names;
  for (const Shortcut& shortcut : shortcuts()) names.emplace_back(shortcut.name);
  return names;
}

KeywordSet stereo_set(const Keywords& modes) {
  KeywordSet set;
  set.pragma = "default shader keywords";
  set.alternatives.push_back({});
  for (const std::string& mode : modes) set.alternatives.push_back({mode});
  return set;
}

}  // namespace penumbra::variants
