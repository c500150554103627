#include "variants/built_in_sets.h"

#include <functional>
#include <utility>

namespace penumbra::variants {
namespace {

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
