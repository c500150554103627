#include "variants/narrowing.h"

#include <set>

#include "hlsl/identifier.h"
#include "input/input_error.h"
#include "input/located_json.h"
#include "input/nearest_name.h"
#include "variants/urp_settings.h"

namespace penumbra::variants {

namespace {

template <typename Value>
using Names = std::vector<std::pair<std::string, Value>>;

template <typename Value>
Value find_name(JsonObject& object, const std::string& key, const std::string& given,
                const Names<Value>& names) {
  std::vector<std::string> known;
  for (const auto& [name, value] : names) {
    if (name == given) return value;
    known.push_back(name);
  }
  object.fail(key, "'" + key + "' cannot be '" + given + "'", unknown_name_remedy(given, known));
}

template <typename Value>
void read(JsonObject& urp, const std::string& key, std::optional<Value>& setting, const Names<Value>& names) {
  if (urp.has(key)) setting = find_name(urp, key, urp.text(key, ""), names);
}

void read_choices(JsonObject& urp, UrpSettings& settings) {
  read(urp, "additional_lights", settings.additional_lights,
       {{"disabled", AdditionalLights::disabled},
        {"per_vertex", AdditionalLights::per_vertex},
        {"per_pixel", AdditionalLights::per_pixel}});
  read(urp, "rendering_mode", settings.rendering_mode,
       {{"forward", RenderingMode::forward},
        {"deferred", RenderingMode::deferred},
        {"forward_plus", RenderingMode::forward_plus}});
  read(urp, "decals", settings.decals,
       {{"none", Decals::none},
        {"dbuffer_albedo", Decals::dbuffer_albedo},
        {"dbuffer_albedo_normal", Decals::dbuffer_albedo_normal},
        {"dbuffer_albedo_normal_maos", Decals::dbuffer_albedo_normal_maos},
        {"screen_space", Decals::screen_space},
        {"gbuffer", Decals::gbuffer}});
  read(urp, "decal_normal_blend", settings.decal_normal_blend,
       {{"none", NormalBlend::none},
        {"low", NormalBlend::low},
        {"medium", NormalBlend::medium},
        {"high", NormalBlend::high}});
  read(urp, "ssao", settings.ssao,
       {{"off", AmbientOcclusion::off},
        {"on", AmbientOcclusion::on},
        {"after_opaque", AmbientOcclusion::after_opaque}});
}

UrpSettings read_urp(JsonObject urp) {
  UrpSettings settings;
  for (const UrpSwitch& known : urp_switches())
    if (urp.has(known.name)) settings.*known.setting = urp.boolean(known.name, false);
  read_choices(urp, settings);
  if (urp.has("shadow_cascades")) {
    settings.shadow_cascades = urp.integer("shadow_cascades", 1);
    if (*settings.shadow_cascades < 1 || *settings.shadow_cascades > 4)
      urp.fail("shadow_cascades", "'shadow_cascades' must be from 1 to 4");
  }
  if (urp.has("fog")) {
    settings.fog.emplace();
    for (const std::string& mode : urp.texts("fog"))
      settings.fog->push_back(find_name<Fog>(
          urp, "fog", mode, {{"linear", Fog::linear}, {"exp", Fog::exp}, {"exp2", Fog::exp2}}));
  }
  for (const std::string& mode : urp.texts("xr"))
    settings.xr.push_back(find_name<std::string>(urp, "xr", mode,
                                                 {{"instancing", "STEREO_INSTANCING_ON"},
                                                  {"multiview", "STEREO_MULTIVIEW_ON"},
                                                  {"single_pass", "UNITY_SINGLE_PASS_STEREO"}}));
  urp.finish();
  return settings;
}

std::string keyword_at(const LocatedJson& document, const LocatedJson::Pointer& at) {
  const nlohmann::json& value = document.at(at);
  if (!value.is_string()) throw InputError(document.where(at), "a keyword must be a string");
  const std::string& keyword = value.get_ref<const std::string&>();
  if (!hlsl::is_identifier(keyword))
    throw InputError(document.where(at), "'" + keyword + "' is not a keyword");
  return keyword;
}

std::vector<Keywords> read_materials(const LocatedJson& document) {
  const LocatedJson::Pointer root("/materials");
  const nlohmann::json& list = document.at(root);
  const std::string wanted = "must be an array of keyword arrays: [[\"_NORMALMAP\"], []]";
  if (!list.is_array()) throw InputError(document.where(root), "'materials' " + wanted);
  std::vector<Keywords> materials;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const LocatedJson::Pointer at = root / i;
    if (!document.at(at).is_array()) throw InputError(document.where(at), "'materials' " + wanted);
    Keywords& material = materials.emplace_back();
    for (std::size_t j = 0; j < document.at(at).size(); ++j) material.push_back(keyword_at(document, at / j));
  }
  return materials;
}

struct NamedUses {
  std::set<std::string> taken_back;  // keywords set to "both"
  std::vector<Clause> clauses;
};

NamedUses read_keywords(JsonObject keywords) {
  enum class Use { always, never, both };
  const Names<Use> names{{"always", Use::always}, {"never", Use::never}, {"both", Use::both}};
  NamedUses uses;
  for (const std::string& keyword : keywords.keys()) {
    if (!hlsl::is_identifier(keyword)) keywords.fail(keyword, "'" + keyword + "' is not a keyword");
    const std::string said_by = keywords.where(keyword) + ": \"" + keyword + "\"";
    uses.taken_back.insert(keyword);
    switch (find_name(keywords, keyword, keywords.text(keyword, ""), names)) {
      case Use::always:
        uses.clauses.push_back(always(keyword, said_by));
        break;
      case Use::never:
        uses.clauses.push_back(never(keyword, said_by));
        break;
      case Use::both:
        break;
    }
  }
  return uses;
}

// Returns whether the clause decides one of the keywords on its own account.
bool decides(const Clause& clause, const std::set<std::string>& keywords) {
  if (!clause.when.empty()) return clause.any_of.empty() && keywords.contains(clause.when);
  return clause.any_of.size() == 1 && keywords.contains(clause.any_of.front());
}

Narrowing narrowing_of(const LocatedJson& document, const std::string& name) {
  Narrowing narrowing;
  JsonObject root(document);
  NamedUses uses;
  if (root.has("keywords")) uses = read_keywords(root.object("keywords"));
  if (root.has("urp")) {
    const UrpSettings settings = read_urp(root.object("urp"));
    narrowing.clauses = clauses_of(settings, name + ": \"urp\"");
    narrowing.stereo_modes = settings.xr;
    narrowing.unused_passes = unused_passes(settings);
    std::erase_if(narrowing.clauses, [&](const Clause& clause) { return decides(clause, uses.taken_back); });
  }
  narrowing.clauses.insert(narrowing.clauses.end(), uses.clauses.begin(), uses.clauses.end());
  if (root.has("materials")) narrowing.materials = read_materials(document);
  if (root.has("shader_feature")) {
    const bool used = find_name<bool>(root, "shader_feature", root.text("shader_feature", ""),
                                      {{"used", true}, {"all", false}});
    if (!used && narrowing.materials)
      root.fail("shader_feature", "\"materials\" has no effect together with \"all\"",
                "remove one of the two");
    if (used && !narrowing.materials) narrowing.materials.emplace();
  }
  root.finish();
  return narrowing;
}

constexpr const char* grammar = "write +NAME (always on), -NAME (never on) or A|B (only these of their set)";

[[noreturn]] void fail(const std::string& word, const std::string& problem) {
  throw InputError("--keywords", "'" + word + "' " + problem, grammar);
}

std::vector<std::string> words_of(std::string_view expression) {
  std::vector<std::string> words{""};
  for (const char c : expression) {
    const bool separates = c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',';
    if (!separates) words.back() += c;
    if (separates && !words.back().empty()) words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

Clause choice_of(const std::string& word) {
  Clause clause;
  clause.of_their_sets = true;
  clause.said_by = "--keywords " + word;
  for (std::size_t at = 0; at <= word.size();) {
    const std::size_t end = std::min(word.find('|', at), word.size());
    const std::string name = word.substr(at, end - at);
    if (is_empty_keyword(name)) {
      clause.or_none = true;
    } else if (hlsl::is_identifier(name)) {
      clause.any_of.push_back(name);
    } else {
      fail(word, name.empty() ? "lacks a name next to '|'" : "holds '" + name + "', which is not a keyword");
    }
    at = end + 1;
  }
  if (clause.any_of.empty()) fail(word, "names no keyword, so it is not known which sets it is for");
  return clause;
}

}  // namespace

Narrowing read_narrowing(const NarrowingInput& input) {
  Narrowing narrowing;
  if (!input.stripping.empty()) narrowing = read_stripping(input.stripping);
  if (!input.urp_assets.empty()) {
    const UrpSettings settings = read_urp_assets(input.urp_assets);
    for (Clause& clause : clauses_of(settings, "--urp-asset")) narrowing.clauses.push_back(std::move(clause));
    for (std::string& pass : unused_passes(settings)) narrowing.unused_passes.push_back(std::move(pass));
  }
  for (const std::string& expression : input.keywords)
    for (Clause& clause : parse_keyword_expression(expression))
      narrowing.clauses.push_back(std::move(clause));
  return narrowing;
}

Narrowing read_stripping(const std::filesystem::path& file) {
  return narrowing_of(LocatedJson::read(file), file.string());
}

Narrowing parse_stripping(std::string_view text, const std::string& name) {
  return narrowing_of(LocatedJson::parse(text, name), name);
}

std::vector<Clause> parse_keyword_expression(std::string_view expression) {
  std::vector<Clause> clauses;
  std::map<std::string, char> signs;
  for (const std::string& word : words_of(expression)) {
    const char sign = word.front();
    if (sign != '+' && sign != '-') {
      if (word.find('|') == std::string::npos) fail(word, "does not say whether it is on or off");
      clauses.push_back(choice_of(word));
      continue;
    }
    const std::string name = word.substr(1);
    if (!hlsl::is_identifier(name) || is_empty_keyword(name)) fail(word, "does not name a keyword");
    const auto [known, is_new] = signs.try_emplace(name, sign);
    if (is_new) {
      const std::string said_by = "--keywords " + word;
      clauses.push_back(sign == '+' ? always(name, said_by) : never(name, said_by));
    } else if (known->second != sign) {
      fail(word, "contradicts '" + std::string(1, known->second) + name + "'");
    }
  }
  return clauses;
}

std::vector<std::string> unknown_keywords(const std::vector<Clause>& clauses,
                                          const std::vector<const Pragmas*>& programs) {
  std::set<std::string> declared;
  for (const Pragmas* program : programs) {
    for (const KeywordSet& set : program->keyword_sets)
      for (const std::string& keyword : keywords_of(set)) declared.insert(keyword);
    for (const DynamicKeyword& keyword : program->dynamic_keywords) declared.insert(keyword.name);
  }
  const std::vector<std::string> known(declared.begin(), declared.end());
  std::vector<std::string> messages;
  for (const Clause& clause : clauses) {
    Keywords named = clause.any_of;
    if (!clause.when.empty()) named.insert(named.begin(), clause.when);
    for (const std::string& keyword : named) {
      if (declared.contains(keyword)) continue;
      const std::string nearest = nearest_name(keyword, known);
      messages.push_back(clause.said_by + ": no program declares '" + keyword + "'" +
                         (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
    }
  }
  return messages;
}

}  // namespace penumbra::variants
