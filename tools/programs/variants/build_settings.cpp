#include "variants/build_settings.h"

#include <algorithm>
#include <set>

#include "hlsl/identifier.h"
#include "hlsl/source_text.h"
#include "input/input_error.h"
#include "variants/unity_asset.h"

namespace penumbra::variants {
namespace {

class Reader {
 public:
  Reader(std::string_view text, const std::string& file, BuildSettings& settings)
      : file_(file), fields_(asset_fields(text, file)), settings_(settings) {}

  void read_player() {
    std::string_view target;
    for (const AssetField& field : fields_) {
      if (field.name == "m_ActiveColorSpace") settings_.gamma = number(field, 1) == 0;
      if (field.name == "m_BuildTarget") target = field.value;
      if (field.name != "m_EncodingQuality") continue;
      const auto encoding = static_cast<LightmapEncoding>(number(field, 2));
      if (target == "Standalone") settings_.desktop_lightmaps = encoding;
      if (target == "Android" || (target == "iPhone" && !settings_.mobile_lightmaps))
        settings_.mobile_lightmaps = encoding;
    }
  }

  void read_graphics() {
    auto at = std::find_if(fields_.begin(), fields_.end(), [](const AssetField& field) {
      return field.indent == 2 && field.name == "m_ShaderBuildSettings";
    });
    if (at == fields_.end()) return;
    for (++at; at != fields_.end() && at->indent > 2; ++at) {
      if (at->indent == 4 && !at->begins_item) list_ = at->name;
      if (list_ == "keywordDeclarationOverrides") read_override(*at);
      if (list_ == "defines") read_define(*at);
      if (list_ == "compilerSettings") read_compiler(*at);
    }
  }

 private:
  [[noreturn]] void fail(const AssetField& field, const std::string& problem) const {
    throw InputError(file_ + ":" + std::to_string(field.line), problem);
  }

  int number(const AssetField& field, int highest) const { return number_in(field, highest, file_); }

  void read_override(const AssetField& field) {
    std::vector<KeywordOverride>& overrides = settings_.overrides;
    if (field.begins_item && field.name == "keywords") overrides.emplace_back();
    if (overrides.empty()) return;
    KeywordOverride& last = overrides.back();
    if (field.name == "name") {
      if (!hlsl::is_identifier(field.value))
        fail(field, "'" + std::string(field.value) + "' is not a keyword");
      last.keywords.emplace_back(is_empty_keyword(std::string(field.value)) ? "_" : field.value);
    } else if (field.name == "keepInBuild" && number(field, 1) == 0 && !last.keywords.empty()) {
      last.dropped.push_back(last.keywords.back());
    } else if (field.name == "variantGenerationMode") {
      last.mode = static_cast<KeywordOverride::Mode>(number(field, 3));
    }
  }

  void read_define(const AssetField& field) {
    if (!field.begins_item) return;
    const std::size_t blank = field.value.find(' ');
    const std::string_view name = field.value.substr(0, blank);
    if (blank == std::string_view::npos || !hlsl::is_identifier(name))
      fail(field, "'" + std::string(field.value) + "' is not a name and a number");
    settings_.defines.emplace_back(name, field.value.substr(field.value.find_first_not_of(' ', blank)));
  }

  void read_compiler(const AssetField& field) {
    if (field.name == "graphicsAPI") {
      static const std::map<int, GraphicsApi> apis{
          {2, GraphicsApi::d3d11},   {11, GraphicsApi::gles3},  {16, GraphicsApi::metal},
          {17, GraphicsApi::glcore}, {21, GraphicsApi::vulkan}, {22, GraphicsApi::nintendo_switch}};
      const auto known = apis.find(number(field, 1000));  // of UnityEngine.Rendering.GraphicsDeviceType
      api_ = known == apis.end() ? std::nullopt : std::optional(known->second);
    } else if (field.name == "compilerToolchainOverride" && api_ && number(field, 2) != 0) {
      settings_.dxc[*api_] = number(field, 2) == 2;
    }
  }

  const std::string& file_;
  std::vector<AssetField> fields_;
  std::string_view list_;
  std::optional<GraphicsApi> api_;
  BuildSettings& settings_;
};

std::set<std::string> names_of(const KeywordSet& set) {
  std::set<std::string> names;
  for (const Keywords& alternative : set.alternatives)
    if (alternative.empty()) names.insert("_");
  for (const std::string& keyword : keywords_of(set)) names.insert(keyword);
  return names;
}

void change(const KeywordOverride& override, KeywordSet& set) {
  std::erase_if(set.alternatives, [&](const Keywords& alternative) {
    return contains(override.dropped, alternative.empty() ? "_" : alternative.front());
  });
  if (override.mode == KeywordOverride::Mode::shader_feature) set.kind = KeywordSet::Kind::shader_feature;
  if (override.mode == KeywordOverride::Mode::multi_compile) set.kind = KeywordSet::Kind::multi_compile;
}

}  // namespace

void parse_build_settings(std::string_view text, const std::string& file, BuildSettings& settings) {
  Reader reader(text, file, settings);
  reader.read_player();
  reader.read_graphics();
}

BuildSettings read_build_settings(const std::filesystem::path& project) {
  BuildSettings settings;
  for (const char* name : {"ProjectSettings.asset", "GraphicsSettings.asset"}) {
    const std::filesystem::path file = project / "ProjectSettings" / name;
    if (!std::filesystem::exists(file)) continue;
    const hlsl::SourceRead read = hlsl::read_source(file);
    if (!read.problem.empty()) throw InputError(file.string(), "cannot be read: " + read.problem);
    parse_build_settings(read.text, file.string(), settings);
  }
  return settings;
}

void apply_settings(const BuildSettings& settings, Platform& platform) {
  platform.gamma = settings.gamma;
  platform.lightmaps = platform.mobile ? settings.mobile_lightmaps : settings.desktop_lightmaps;
}

void apply_overrides(const std::vector<KeywordOverride>& overrides, Pragmas& pragmas) {
  for (const KeywordOverride& override : overrides) {
    const std::set<std::string> wanted(override.keywords.begin(), override.keywords.end());
    for (KeywordSet& set : pragmas.keyword_sets) {
      if (names_of(set) != wanted) continue;
      change(override, set);
      if (override.mode != KeywordOverride::Mode::dynamic_branch) continue;
      for (const std::string& keyword : keywords_of(set))
        pragmas.dynamic_keywords.push_back({keyword, set.local, set.place});
      set.alternatives.clear();
    }
    std::erase_if(pragmas.keyword_sets, [&](const KeywordSet& set) { return set.alternatives.empty(); });
  }
}

}  // namespace penumbra::variants
