// The techniques of a manifest (manifest_reader.h).
#include <algorithm>
#include <set>
#include <utility>

#include "input/input_error.h"
#include "platform/data_directory.h"
#include "techniques/graph_reader.h"
#include "techniques/manifest_reader.h"

namespace penumbra::techniques {
namespace {

TechniqueBias read_bias(JsonObject object) {
  TechniqueBias bias;
  bias.depth = object.number("depth", bias.depth);
  bias.normal = object.number("normal", bias.normal);
  bias.soft_quality = object.text("soft_quality", bias.soft_quality);
  bias.slope = object.number("slope", bias.slope);
  return bias;
}

// The result is in running order. A problem of the graph as a whole is reported at the key.
PassGraph checked(const JsonObject& object, const std::string& key, PassGraph graph) {
  check_graph(graph, object.where(key));
  graph.passes = *in_running_order(graph);
  return graph;
}

std::size_t item_count(const PassGraph& graph) {
  return graph.passes.size() + graph.textures.size();
}

// Reads entries over the defaults of their manifest, which supply what an entry leaves out.
class TechniqueReader {
 public:
  TechniqueReader(const Manifest& manifest, const TechniqueList& list, Graphs graphs)
      : document_(manifest.document),
        list_(list),
        files_(manifest.file, list.package),
        manifest_(files_.named(manifest.file)),
        graphs_(std::move(graphs)),
        defaults_(JsonObject(document_).object("defaults")),
        shared_values_(defaults_.object("values")) {
    for (const Technique& technique : list.techniques) graph_items_ += item_count(technique.graph);
  }

  Technique read(JsonObject object, const LocatedJson::Pointer& at) {
    const auto of = [&](const std::string& key) -> JsonObject& { return giver(object, key); };
    const auto place = [&](const std::string& key) {
      return (object.has(key) ? at : LocatedJson::Pointer("/defaults")) / key;
    };
    const Technique* model = object.has("like") ? &model_of(object) : nullptr;
    const Technique* earlier = object.has("after") ? &over_screen(object) : nullptr;
    Technique technique = model != nullptr ? *model : Technique{};
    read_description(object, model != nullptr, technique);
    read_passes(object, model != nullptr, earlier, technique);
    if (of("bias").has("bias")) technique.bias = read_bias(of("bias").object("bias"));
    if (of("lights").has("lights")) technique.lights = read_lights(of("lights"));
    const std::vector<ParameterField> fields = list_.fields_of(technique);
    read_values(object.object("values"), fields, model != nullptr ? model : earlier, technique);
    if (model != nullptr) keep_models_unlimited(of("unlimited"), technique);
    if (of("unlimited").has("unlimited"))
      read_unlimited(of("unlimited").object("unlimited"), fields, technique);
    if (!technique.unlimited.empty() && technique.graph.filter() == nullptr)
      of("unlimited")
          .fail("unlimited", "no pass of '" + technique.name + "' calls a filter",
                "say which one a pass calls: \"filter\": {...}");
    if (object.has("cascades")) technique.cascades.clear();
    for (JsonObject& rule : object.objects("cascades"))
      technique.cascades.push_back(read_rule(rule, technique));
    require_fitting_lights(of("lights"), technique);
    if (model == nullptr || model->keyword_sets == usual_keyword_sets(*model))
      technique.keyword_sets = usual_keyword_sets(technique);
    if (of("keyword_sets").has("keyword_sets"))
      document_.at(place("keyword_sets")).get_to(technique.keyword_sets);
    if (of("targets_absent").has("targets_absent")) technique.targets_absent.clear();
    JsonObject reasons = of("targets_absent").object("targets_absent");
    for (const std::string& target : reasons.keys())
      technique.targets_absent[target] = reasons.text(target, "");
    return technique;
  }

  // Called after the last entry: throws for a value that is no technique's.
  void finish() const { shared_values_.finish(); }

 private:
  // The defaults give what an entry leaves out; an entry that is like another technique has the rest from
  // that.
  JsonObject& giver(JsonObject& object, const std::string& key) {
    return object.has(key) ? object : defaults_;
  }

  std::string needed_text(JsonObject& object, const std::string& key) {
    if (!giver(object, key).has(key))
      object.fail(key, "'" + key + "' is missing", "give it here or in \"defaults\"");
    return giver(object, key).text(key, "");
  }

  void read_description(JsonObject& object, bool has_model, Technique& technique) {
    const auto has = [&](const std::string& key) { return !has_model || giver(object, key).has(key); };
    technique.name = object.text("name", "");
    technique.where = object.where("name");
    technique.manifest = manifest_;
    technique.title = object.text("title", "");
    if (has("family")) technique.family = needed_text(object, "family");
    if (has("source")) technique.source = needed_text(object, "source");
    technique.use_when = giver(object, "use_when").text("use_when", "");
    technique.not_when = giver(object, "not_when").text("not_when", "");
  }

  // Reads the graph and the keywords, and with an earlier technique what its passes need.
  void read_passes(JsonObject& object, bool has_model, const Technique* earlier, Technique& technique) {
    if (object.has("graph") && object.has("filter"))
      object.fail("graph", "'" + technique.name + "' has both a graph and a filter", "give one of the two");
    JsonObject& from = object.has("graph") || object.has("filter") ? object : defaults_;
    const bool has_passes = from.has("graph") || from.has("filter");
    if (!has_passes && !has_model)
      object.fail("graph", "'" + technique.name + "' has neither a filter nor a graph",
                  "give it one, here or in \"defaults\"");
    if (has_passes) {
      technique.cascades.clear();
      technique.graph_name.clear();
      technique.graph = graph(from, earlier, technique.graph_name);
    } else {
      count(object, "like", technique.graph);
    }
    if (earlier != nullptr) {
      technique.keywords = earlier->keywords;
      technique.unlimited = earlier->unlimited;
      technique.bias = earlier->bias;
    }
    JsonObject& keywords = giver(object, "keywords");
    if (has_model && keywords.has("keywords")) technique.keywords.clear();
    for (const std::string& keyword : read_keywords(keywords)) technique.keywords.push_back(keyword);
  }

  static std::vector<LightKind> read_lights(JsonObject& object) {
    std::vector<LightKind> lights;
    for (const std::string& name : object.texts("lights"))
      lights.push_back(name == name_of(LightKind::spot) ? LightKind::spot : LightKind::directional);
    return lights;
  }

  // A spot light's map has no passes over cascades, and only it has the argument "spotLight".
  static void require_fitting_lights(JsonObject& object, const Technique& technique) {
    const GraphPass* pass = technique.graph.filter_pass();
    const bool filter_alone = pass != nullptr && technique.graph.passes.size() == 1;
    if (technique.is_for(LightKind::spot) && !(filter_alone && technique.cascades.empty()))
      object.fail("lights",
                  "'" + technique.name +
                      "' has passes or rules for cascades; under a spot light only filters alone run",
                  "leave out \"spot\"");
    if (pass == nullptr || !pass->filter->takes(spot_light_name)) return;
    if (technique.is_for(LightKind::directional))
      object.fail("lights",
                  "the filter of '" + technique.name + "' takes the spot light, which the sun is not",
                  "write \"lights\": [\"spot\"]");
  }

  // Returns an earlier technique that the entry differs from in what it gives itself.
  const Technique& model_of(JsonObject& object) const {
    if (object.has("after"))
      object.fail("after", "'like' and 'after' both name a technique whose passes the entry has",
                  "leave out one of the two");
    return named_technique(object, "like", list_);
  }

  // The model's values without limit stand where none are given, and where the passes have their fields.
  static void keep_models_unlimited(JsonObject& given, Technique& technique) {
    if (given.has("unlimited")) technique.unlimited.clear();
    std::erase_if(technique.unlimited,
                  [&technique](const auto& value) { return !technique.values.contains(value.first); });
  }

  // Returns an earlier technique whose visibility is a texture, which another graph can read.
  const Technique& over_screen(JsonObject& object) const {
    return named_technique(object, "after", list_, "technique over the screen",
                           [](const Technique& technique) { return technique.graph.over_screen(); });
  }

  PassGraph graph(JsonObject& from, const Technique* earlier, std::string& name) {
    const bool alone = from.has("filter");
    const char* key = alone ? "filter" : "graph";
    PassGraph graph;
    if (alone) {
      graph = graph_of(read_filter(from.object(key), list_, files_), from.where(key));
    } else {
      name = from.text(key, "");
      if (!graphs_.contains(name)) {
        std::vector<std::string> known;
        for (const auto& [known_name, known_graph] : graphs_) known.push_back(known_name);
        require_known(from, key, "graph", name, known);
      }
      graph = graphs_.at(name);
    }
    if (graph.source.empty() != (earlier == nullptr))
      from.fail(key,
                earlier == nullptr
                    ? "the graph reads the visibility of another, its source '" + graph.source + "'"
                    : "the graph has no source, and would not read the visibility before it",
                earlier == nullptr ? "name the technique that makes it: \"after\": technique"
                                   : "leave out \"after\", or give the graph a \"source\"");
    if (earlier != nullptr) graph = in_sequence(earlier->graph, graph);
    count(from, key, graph);
    if (alone || earlier != nullptr) return checked(from, key, std::move(graph));
    // If techniques share a graph, it is checked for the first one.
    if (checked_.insert(name).second) graphs_.at(name) = checked(from, key, std::move(graph));
    return graphs_.at(name);
  }

  void count(const JsonObject& from, const char* key, const PassGraph& graph) {
    graph_items_ += item_count(graph);
    require_at_most(from, key, graph_items_, most_graph_items, "passes and textures of all techniques");
  }

  CascadeRule read_rule(JsonObject& object, const Technique& technique) {
    CascadeRule rule;
    rule.from = object.integer("from", 0);
    if (!technique.cascades.empty() && rule.from <= technique.cascades.back().from)
      object.fail("from", "'from' is not above that of the rule before it: rules come in rising order");
    const Technique& other = object.has("technique") ? filter_alone(object, technique) : technique;
    const GraphPass* pass = other.graph.filter_pass();
    if (pass == nullptr)
      object.fail("from",
                  "'" + technique.name + "' has no pass of kind filter, which runs for each receiver");
    if (object.has("technique")) {
      rule.technique = other.name;
      rule.values = other.values;
    }
    rule.filter = *pass->filter;
    rule.unlimited = other.unlimited;
    JsonObject own = object.object("values");
    if (const ParameterStruct* parameters = list_.find_struct(rule.filter.parameters))
      for (const ParameterField& field : parameters->fields)
        if (own.has(field.name)) rule.values[field.name] = value_of(own, field);
    own.finish();
    if (rule.technique.empty() && rule.values.empty())
      object.fail("from", "the rule changes nothing", "give it \"values\" or a \"technique\"");
    return rule;
  }

  // Returns the technique of a rule: one of the list so far that runs without passes and keywords of its own.
  const Technique& filter_alone(JsonObject& object, const Technique& technique) const {
    const Technique& other = named_technique(object, "technique", list_);
    const std::string& name = other.name;
    if (other.graph.passes.size() != 1 || other.graph.filter_pass() == nullptr)
      object.fail("technique", "'" + name + "' is not a filter alone: it has passes of its own");
    if (other.all_keywords() != technique.all_keywords())
      object.fail("technique",
                  "'" + name + "' is compiled with other keywords than '" + technique.name + "'");
    if (!other.cascades.empty()) object.fail("technique", "'" + name + "' has rules for cascades itself");
    return other;
  }

  static std::vector<double> value_of(JsonObject& from, const ParameterField& field) {
    std::vector<double> value = components(from, field.name, field);
    require_value(from, field.name, field, value);
    return value;
  }

  // Every field has a value, and every value is a field's.
  void read_values(JsonObject own, const std::vector<ParameterField>& fields, const Technique* earlier,
                   Technique& technique) {
    technique.values.clear();
    for (const ParameterField& field : fields) {
      JsonObject& from = own.has(field.name) ? own : shared_values_;
      if (from.has(field.name)) {
        technique.values[field.name] = value_of(from, field);
      } else if (earlier != nullptr && earlier->values.contains(field.name)) {
        technique.values[field.name] = earlier->values.at(field.name);
      } else if (!field.otherwise.empty()) {
        technique.values[field.name] = field.otherwise;
      } else {
        own.fail(field.name, "no value for '" + field.name + "' of '" + technique.name + "'",
                 "give it in \"values\", or the field a \"default\"");
      }
    }
    own.finish();
  }

  // Only the upper end of a field's range may be exceeded.
  static void read_unlimited(JsonObject object, const std::vector<ParameterField>& fields,
                             Technique& technique) {
    std::vector<std::string> known;
    for (const ParameterField& field : fields) known.push_back(field.name);
    for (const std::string& key : object.keys()) {
      require_known(object, key, "field", key, known);
      ParameterField field =
          fields[static_cast<std::size_t>(std::find(known.begin(), known.end(), key) - known.begin())];
      if (component_count(field) > 1)
        object.fail(key, "'" + key + "' is a " + field.type + ", and only numbers can be unlimited");
      const double value = object.number(key, 0.0);
      if (field.range) field.range->largest = std::max(field.range->largest, value);
      require_value(object, key, field, {value});
      technique.unlimited[key] = value;
    }
  }

  // The sets cover both directions of depth; a filter with unlimited samples has sets for these, too.
  static std::vector<std::vector<std::string>> usual_keyword_sets(const Technique& technique) {
    std::vector<std::vector<std::string>> sets{{}, {"UNITY_REVERSED_Z"}};
    if (technique.is_sampled() && technique.graph.filter_pass() != nullptr) {
      sets.push_back({"PENUMBRA_UNLIMITED"});
      sets.push_back({"UNITY_REVERSED_Z", "PENUMBRA_UNLIMITED"});
    }
    return sets;
  }

  const LocatedJson& document_;
  const TechniqueList& list_;
  ManifestFiles files_;
  std::string manifest_;
  Graphs graphs_;
  std::set<std::string> checked_;  // names of these graphs
  std::size_t graph_items_ = 0;
  JsonObject defaults_;
  JsonObject shared_values_;
};

Graphs read_graphs(JsonObject& root, const TechniqueList& list, const ManifestFiles& files, Graphs graphs) {
  std::size_t items = 0;
  for (JsonObject& object : entries(root, "graphs", list.graphs.size(), most_graphs)) {
    const std::string name = object.text("name", "");
    if (!graphs.emplace(name, read_graph(object, list, files, graphs)).second)
      object.fail("name", "there are two graphs '" + name + "'",
                  "choose another name; the graphs of a manifest's library are known in it, too");
    items += item_count(graphs.at(name));
    require_at_most(object, "name", items, most_graph_items, "passes and textures of all graphs");
  }
  return graphs;
}

// Graphs that are parts of others may be incomplete; all others are checked.
void add_graphs(JsonObject& root, const Graphs& graphs, const std::string& manifest, TechniqueList& list) {
  std::set<std::string> parts;
  for (JsonObject& object : root.objects("graphs"))
    for (const std::string& part : object.texts("parts")) parts.insert(part);
  for (JsonObject& object : root.objects("graphs")) {
    const std::string name = object.text("name", "");
    if (!parts.contains(name))
      list.graphs.push_back({name, manifest, object.where("name"), checked(object, "name", graphs.at(name))});
  }
}

}  // namespace

Graphs add_techniques(const Manifest& manifest, TechniqueList& list, Graphs of_library) {
  JsonObject root(manifest.document);
  const ManifestFiles files(manifest.file, list.package);
  const Graphs graphs = read_graphs(root, list, files, std::move(of_library));
  add_graphs(root, graphs, files.named(manifest.file), list);
  TechniqueReader reader(manifest, list, graphs);
  std::size_t index = 0;
  for (JsonObject& object : entries(root, "techniques", list.techniques.size(), most_techniques)) {
    Technique technique = reader.read(object, LocatedJson::Pointer("/techniques") / index++);
    for (const Technique& other : list.techniques)
      if (other.name == technique.name)
        object.fail("name", "there are two techniques '" + technique.name + "'",
                    "the other one is at " + other.where);
    list.techniques.push_back(std::move(technique));
  }
  reader.finish();
  add_selections(root, list);
  add_presets(root, list);
  add_looks(root, list);
  return graphs;
}

}  // namespace penumbra::techniques
