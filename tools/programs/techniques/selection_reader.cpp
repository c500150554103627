// The selections and options of a manifest (manifest_reader.h).
#include <algorithm>

#include "input/input_error.h"
#include "techniques/manifest_reader.h"
#include "techniques/selection.h"

namespace penumbra::techniques {
namespace {

const std::vector<std::string> option_types = {"int", "float", "bool", "enum"};

FeatureOption read_option(JsonObject object) {
  FeatureOption option{required_identifier(object, "name"),
                       required_text(object, "type"),
                       required_line(object, "label"),
                       required_line(object, "tooltip"),
                       {}};
  require_known(object, "type", "type", option.type, option_types);
  const bool is_number = option.type == "int" || option.type == "float";
  if (is_number) {
    const std::vector<double> ends = object.numbers("range", 2);
    if (!(ends[0] < ends[1])) object.fail("range", "the smallest value is not below the largest");
    option.range = {ends[0], ends[1]};
  }
  object.finish();
  return option;
}

void read_options_of(JsonObject object, const TechniqueList& list, Selection& selection) {
  std::vector<std::string> options;
  for (const FeatureOption& option : list.options) options.push_back(option.name);
  std::vector<std::string> fields;
  if (const ParameterStruct* parameters = list.find_struct(selection.filter.parameters))
    for (const ParameterField& field : parameters->fields) fields.push_back(field.name);
  for (const std::string& option : object.keys()) {
    require_known(object, option, "option", option, options);
    const std::string field = required_text(object, option);
    require_known(object, option, "field", field, fields);
    selection.options[option] = field;
  }
}

// The enumerator, where the renderer feature offers the selection.
void read_entry(JsonObject& object, const TechniqueList& list, Selection& selection) {
  selection.value = object.integer("value", 0);
  if (*selection.value < 0) object.fail("value", "the value of an enumerator is not negative");
  for (const Selection& other : list.selections)
    if (other.value == selection.value)
      object.fail("value", "'" + other.name + "' has the value " + std::to_string(*selection.value));
  selection.title = required_line(object, "title");
  selection.doc = required_line(object, "doc");
  read_options_of(object.object("options"), list, selection);
}

void read_fallback(JsonObject& object, const TechniqueList& list, Selection& selection) {
  if (!selection.reads_raw_depth()) {
    if (object.has("fallback"))
      object.fail("fallback",
                  "'" + selection.name + "' reads no raw depths: its filter takes no point sampler");
    return;
  }
  selection.fallback = required_text(object, "fallback");
  std::vector<std::string> known;
  for (const Selection& other : list.selections)
    if (!other.reads_raw_depth()) known.push_back(other.name);
  require_known(object, "fallback", "selection", selection.fallback, known);
}

Selection read_selection(JsonObject& object, const TechniqueList& list) {
  Selection selection;
  selection.name = required_identifier(object, "name");
  selection.where = object.where("name");
  selection.keyword = object.text("keyword", "");
  for (const Selection& other : list.selections) {
    if (other.name == selection.name) object.fail("name", "there are two selections '" + other.name + "'");
    if (other.keyword == selection.keyword)
      object.fail("keyword", "'" + other.name + "' has the keyword '" + other.keyword + "'");
  }
  if (!selection.keyword.empty() && !selection.keyword.starts_with("_PENUMBRA_"))
    object.fail("keyword", "a keyword of the library begins with '_PENUMBRA_'");
  if (!selection.keyword.empty()) required_identifier(object, "keyword");
  selection.technique = required_text(object, "technique");
  std::vector<std::string> known;
  for (const Technique& technique : list.techniques) known.push_back(technique.name);
  require_known(object, "technique", "technique", selection.technique, known);
  const Technique& technique = list.find(selection.technique);
  if (technique.graph.passes.size() != 1 || technique.graph.filter_pass() == nullptr)
    object.fail("technique", "'" + technique.name + "' is not a filter alone: it has passes of its own");
  selection.filter = *technique.graph.filter();
  selection.is_sampled = technique.is_sampled();
  read_fallback(object, list, selection);
  if (object.has("value")) read_entry(object, list, selection);
  object.finish();
  return selection;
}

}  // namespace

bool Selection::reads_raw_depth() const {
  return std::find(filter.arguments.begin(), filter.arguments.end(), "pointSampler") !=
         filter.arguments.end();
}

void add_options(const Manifest& manifest, TechniqueList& list) {
  JsonObject root(manifest.document);
  for (JsonObject& object : root.objects("options")) {
    FeatureOption option = read_option(object);
    for (const FeatureOption& other : list.options)
      if (other.name == option.name) object.fail("name", "there are two options '" + option.name + "'");
    list.options.push_back(std::move(option));
  }
}

void add_selections(JsonObject& root, TechniqueList& list) {
  for (JsonObject& object : root.objects("selections"))
    list.selections.push_back(read_selection(object, list));
}

}  // namespace penumbra::techniques
