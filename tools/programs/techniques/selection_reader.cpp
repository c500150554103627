// The selections and options of a manifest (manifest_reader.h).
#include <algorithm>

#include "input/input_error.h"
#include "techniques/manifest_reader.h"
#include "techniques/selection.h"
#include "techniques/settings_emit.h"

namespace penumbra::techniques {
namespace {

FeatureOption read_option(JsonObject object) {
  FeatureOption option{object.text("name", ""),
                       object.text("type", ""),
                       object.text("label", ""),
                       object.text("tooltip", ""),
                       {}};
  if (object.has("range")) {
    const std::vector<double> ends = object.numbers("range", 2);
    if (!(ends[0] < ends[1])) object.fail("range", "the smallest value is not below the largest");
    option.range = {ends[0], ends[1]};
  }
  return option;
}

// The options belong to the filter's parameters and those of the passes before it.
void read_options_of(JsonObject object, const TechniqueList& list, Selection& selection) {
  std::vector<std::string> options;
  for (const FeatureOption& option : list.options) options.push_back(option.name);
  const std::vector<ParameterField> fields = list.fields_of(list.find(selection.technique));
  std::vector<std::string> names;
  for (const ParameterField& field : fields) names.push_back(field.name);
  for (const std::string& name : object.keys()) {
    require_known(object, name, "option", name, options);
    const std::string field = object.text(name, "");
    require_known(object, name, "field", field, names);
    const auto option = std::find_if(list.options.begin(), list.options.end(),
                                     [&](const FeatureOption& one) { return one.name == name; });
    const auto set = std::find_if(fields.begin(), fields.end(),
                                  [&](const ParameterField& one) { return one.name == field; });
    if (option->type != set->type)
      object.fail(name, "'" + name + "' is of type " + option->type + ", the field '" + field + "' of type " +
                            set->type);
    selection.options[name] = field;
  }
}

// Reads the enumerator, where the renderer feature offers the selection.
void read_entry(JsonObject& object, const TechniqueList& list, Selection& selection) {
  selection.value = object.integer("value", 0);
  for (const Selection& other : list.selections)
    if (other.value == selection.value)
      object.fail("value", "'" + other.name + "' has the value " + std::to_string(*selection.value));
  selection.title = object.text("title", "");
  selection.doc = object.text("doc", "");
  read_options_of(object.object("options"), list, selection);
}

// A fallback is needed where the filter or the passes before it read the shadow map without comparing.
void read_fallback(JsonObject& object, const TechniqueList& list, Selection& selection) {
  const bool has_passes = !list.find(selection.technique).graph_name.empty();
  if (!selection.reads_raw_depth() && !has_passes) {
    if (object.has("fallback"))
      object.fail(
          "fallback",
          "'" + selection.name +
              "' reads no raw depths: its filter takes no point sampler, and no passes run before it");
    return;
  }
  if (!object.has("fallback")) object.fail("fallback", "'fallback' is missing");
  selection.fallback = object.text("fallback", "");
  std::vector<std::string> known;
  for (const Selection& other : list.selections)
    if (selection.draws_visibility ? !other.draws_visibility : other.fallback.empty())
      known.push_back(other.name);
  require_known(object, "fallback", "selection", selection.fallback, known);
  if (!selection.draws_visibility) return;
  for (const Selection& other : list.selections)
    if (other.name == selection.fallback) selection.keyword = other.keyword;
}

// Returns a technique whose filter a keyword can select, under the sun, after passes or without any; or one
// whose passes draw the visibility from the shadow map alone.
const Technique& read_technique(JsonObject& object, const std::string& key, const TechniqueList& list) {
  const Technique& technique = named_technique(object, key, list);
  const std::string& name = technique.name;
  const PassGraph& graph = technique.graph;
  const bool ends =
      graph.filter_pass() != nullptr || (graph.over_screen() && graph.source.empty() && graph.needs.empty());
  if (!ends || !technique.is_for(LightKind::directional))
    object.fail(key, "'" + name +
                         "' does not end in a filter for directional lights, nor in a visibility "
                         "that needs the shadow map alone");
  return technique;
}

void read_16_bits(JsonObject& object, const TechniqueList& list, Selection& selection) {
  if (!object.has("technique_16_bits")) return;
  const Technique& technique = read_technique(object, "technique_16_bits", list);
  if (selection.draws_visibility || technique.graph.filter_pass() == nullptr ||
      technique.graph.filter()->function != selection.filter.function || technique.graph_name.empty())
    object.fail("technique_16_bits", "'" + technique.name + "' is not the filter '" +
                                         selection.filter.function + "' over maps, as '" +
                                         selection.technique + "' is");
  selection.technique_16_bits = technique.name;
}

// The passes are those of a half as wide screen, which end in one as wide.
void read_half_resolution(JsonObject& object, const TechniqueList& list, Selection& selection) {
  if (!object.has("technique_half_resolution")) return;
  const Technique& technique = read_technique(object, "technique_half_resolution", list);
  if (!selection.draws_visibility || technique.graph.filter_pass() != nullptr)
    object.fail("technique_half_resolution",
                "'" + technique.name + "' does not end in a texture, as '" + selection.technique + "' does",
                "filters have the feature's own passes at half resolution");
  selection.technique_half_resolution = technique.name;
}

// The parameters are those of the technique's structs.
void read_computed_parameters(JsonObject& object, const TechniqueList& list, const Technique& technique,
                              Selection& selection) {
  selection.computed_parameters = object.texts("computed_parameters");
  std::vector<std::string> known;
  for (const ParameterStruct* parameters : list.structs_of(technique)) known.push_back(parameters->name);
  for (const std::string& name : selection.computed_parameters)
    require_known(object, "computed_parameters", "struct", name, known);
}

Selection read_selection(JsonObject& object, const TechniqueList& list) {
  Selection selection;
  selection.name = object.text("name", "");
  selection.where = object.where("name");
  const Technique& technique = read_technique(object, "technique", list);
  selection.technique = technique.name;
  selection.draws_visibility = technique.graph.filter_pass() == nullptr;
  if (selection.draws_visibility && object.has("keyword"))
    object.fail("keyword",
                "'" + selection.technique + "' ends in a texture, not in a filter that shaders could call",
                "leave the keyword out: its fallback's is on");
  if (selection.draws_visibility && !object.has("value"))
    object.fail("name",
                "'" + selection.technique + "' ends in a texture, which the renderer feature alone draws",
                "give it a value, a title, a doc and options");
  selection.keyword = object.text("keyword", "");
  for (const Selection& other : list.selections) {
    if (other.name == selection.name) object.fail("name", "there are two selections '" + other.name + "'");
    if (!selection.draws_visibility && !other.draws_visibility && other.keyword == selection.keyword)
      object.fail("keyword", "'" + other.name + "' has the keyword '" + other.keyword + "'");
  }
  if (!selection.draws_visibility) selection.filter = *technique.graph.filter();
  for (const GraphTexture& texture : technique.graph.textures)
    if (selection.filter.takes(texture.name)) selection.textures.push_back(texture);
  selection.is_sampled = technique.is_sampled() && !selection.draws_visibility;
  selection.widens_with_disc = object.boolean("widens_with_disc", technique.is_sampled());
  selection.needs_target_45 = object.boolean("target_4_5", selection.filter.takes("pointSampler"));
  read_computed_parameters(object, list, technique, selection);
  read_16_bits(object, list, selection);
  read_half_resolution(object, list, selection);
  read_fallback(object, list, selection);
  if (object.has("value")) read_entry(object, list, selection);
  return selection;
}

// Returns the selection whose passes draw the visibility; null if none does so by this technique's graph.
const Selection* selection_with_passes(const TechniqueList& list, const Technique& technique) {
  for (const Selection& selection : list.selections) {
    if (!selection.draws_visibility) continue;
    for (const std::string& name : {selection.technique, selection.technique_half_resolution}) {
      if (name.empty()) continue;
      const Technique& other = list.find(name);
      if (other.graph_name == technique.graph_name && other.manifest == technique.manifest) return &selection;
    }
  }
  return nullptr;
}

bool is_at_half_resolution(const Technique& technique) {
  return std::any_of(technique.graph.passes.begin(), technique.graph.passes.end(),
                     [](const GraphPass& pass) { return pass.name == upsampling_pass; });
}

// A preset's options set both its passes and its fallback, so the measured techniques must have them, too.
// Its passes may call the fallback's filter, as upsampling does.
void require_same_options(JsonObject& object, const TechniqueList& list, const PresetChoice& choice,
                          const Selection& selection) {
  const Technique& preset = list.find(choice.preset);
  const Technique& fallback = list.find(choice.fallback);
  auto options = selection.options;
  if (preset.graph.filter() != nullptr)
    for (const Selection& other : list.selections)
      if (other.name == selection.fallback) options.insert(other.options.begin(), other.options.end());
  for (const auto& [option, field] : options) {
    const auto other = fallback.values.find(field);
    const auto own = preset.values.find(field);
    if (other != fallback.values.end() && own != preset.values.end() && other->second != own->second)
      object.fail("fallback", "'" + preset.name + "' and '" + fallback.name + "' differ in '" + field + "'",
                  "the preset has one value of the option '" + option + "' for both");
  }
  if (is_at_half_resolution(preset) != is_at_half_resolution(fallback))
    object.fail("fallback", "of '" + preset.name + "' and '" + fallback.name + "', one is at half resolution",
                "a preset has it for both or for neither");
}

}  // namespace

bool Selection::reads_raw_depth() const {
  return filter.takes(shadow_map_name) && filter.takes("pointSampler");
}

void add_options(const Manifest& manifest, TechniqueList& list) {
  JsonObject root(manifest.document);
  for (JsonObject& object : entries(root, "options", list.options.size(), most_choices)) {
    FeatureOption option = read_option(object);
    for (const FeatureOption& other : list.options)
      if (other.name == option.name) object.fail("name", "there are two options '" + option.name + "'");
    list.options.push_back(std::move(option));
  }
}

void add_presets(JsonObject& root, TechniqueList& list) {
  std::vector<std::string> names;
  for (const Technique& technique : list.techniques) names.push_back(technique.name);
  for (JsonObject& object : entries(root, "presets", list.presets.size(), most_choices)) {
    PresetChoice choice{object.text("preset", ""), object.text("fallback", ""), {}};
    require_known(object, "preset", "technique", choice.preset, names);
    require_known(object, "fallback", "technique", choice.fallback, names);
    for (const PresetChoice& other : list.presets)
      if (other.preset == choice.preset)
        object.fail("preset", "there are two fallbacks of '" + choice.preset + "'");
    const Selection* selection = selection_with_passes(list, list.find(choice.preset));
    if (selection == nullptr)
      object.fail("preset", "no selection has the passes of '" + choice.preset + "'",
                  "add one to \"selections\" of its manifest");
    if (list.find(choice.fallback).keywords != std::vector<std::string>{selection->keyword})
      object.fail("fallback", "'" + choice.fallback + "' has not the keyword of '" + selection->fallback +
                                  "', which '" + selection->name + "' falls back to");
    require_same_options(object, list, choice, *selection);
    choice.selection = selection->name;
    list.presets.push_back(std::move(choice));
  }
}

void add_selections(JsonObject& root, TechniqueList& list) {
  for (JsonObject& object : entries(root, "selections", list.selections.size(), most_choices))
    list.selections.push_back(read_selection(object, list));
}

}  // namespace penumbra::techniques
