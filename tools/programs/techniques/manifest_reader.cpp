#include "techniques/manifest_reader.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "hlsl/identifier.h"
#include "input/input_error.h"
#include "input/nearest_name.h"
#include "techniques/graph_reader.h"
#include "techniques/technique_values.h"

namespace penumbra::techniques {
namespace {

const std::vector<std::string> field_types = {"float", "float2", "float4", "int"};
const std::vector<std::string> soft_qualities = {"off", "low", "medium", "high"};
const std::vector<std::string> target_names = {"spirv", "essl310", "glsl450", "msl23", "hlsl50"};

void require_value(JsonObject& object, const std::string& key, const ParameterField& field,
                   const std::vector<double>& components) {
  for (const double value : components) {
    const std::string problem = value_problem(field, value);
    if (!problem.empty()) object.fail(key, problem);
  }
}

std::vector<double> components(JsonObject& object, const std::string& key, const ParameterField& field) {
  if (component_count(field) > 1) return object.numbers(key, component_count(field));
  const double value = object.number(key, 0.0);
  if (field.type == "int") object.integer(key, 0);
  return {value};
}

// Of C# and HLSL, and what an emitted struct has besides its fields.
bool is_reserved(const std::string& name) {
  static const std::set<std::string> words{
      "Default",  "SetGlobal", "abstract", "as",        "base",      "bool",      "break",      "byte",
      "case",     "catch",     "char",     "checked",   "class",     "const",     "continue",   "decimal",
      "default",  "delegate",  "do",       "double",    "else",      "enum",      "event",      "explicit",
      "extern",   "false",     "finally",  "fixed",     "float",     "for",       "foreach",    "goto",
      "half",     "if",        "implicit", "in",        "inout",     "int",       "interface",  "internal",
      "is",       "lock",      "long",     "matrix",    "namespace", "new",       "null",       "object",
      "operator", "out",       "override", "params",    "private",   "protected", "public",     "readonly",
      "ref",      "return",    "sbyte",    "sealed",    "short",     "sizeof",    "stackalloc", "static",
      "string",   "struct",    "switch",   "texture",   "this",      "throw",     "true",       "try",
      "typeof",   "uint",      "ulong",    "unchecked", "uniform",   "unsafe",    "ushort",     "using",
      "vector",   "virtual",   "void",     "volatile",  "while"};
  const auto numbered = [&name](std::string_view word) {
    return name.starts_with(word) && name.size() > word.size() &&
           name.find_first_not_of("0123456789", word.size()) == std::string::npos;
  };
  return words.count(name) != 0 || numbered("Vector") || numbered("Uniform");
}

ParameterField read_field(JsonObject object) {
  ParameterField field;
  field.name = required_identifier(object, "name");
  field.type = required_text(object, "type");
  field.unit = required_line(object, "unit");
  field.doc = required_line(object, "doc");
  require_known(object, "type", "type", field.type, field_types);
  if (object.has("range")) {
    const std::vector<double> ends = object.numbers("range", 2);
    if (ends[0] > ends[1]) object.fail("range", "the smallest value comes after the largest");
    require_value(object, "range", field, ends);
    field.range = {ends[0], ends[1]};
  }
  if (object.has("default")) {
    field.otherwise = components(object, "default", field);
    require_value(object, "default", field, field.otherwise);
  }
  object.finish();
  return field;
}

ParameterStruct read_struct(JsonObject object) {
  ParameterStruct parameters{required_identifier(object, "name"), required_line(object, "doc"), {}, {}};
  std::set<std::string> seen;
  for (JsonObject& field : object.objects("fields")) {
    parameters.fields.push_back(read_field(field));
    const std::string& name = parameters.fields.back().name;
    if (!seen.insert(name).second) field.fail("name", "there are two fields '" + name + "'");
    if (name == parameters.name || is_reserved(name))
      field.fail("name", "'" + name + "' is a word of C#, of HLSL or of the emitted struct",
                 "choose another");
  }
  if (parameters.fields.empty()) object.fail("fields", "'" + parameters.name + "' has no fields");
  object.finish();
  return parameters;
}

double read_bias_setting(JsonObject& bias, const std::string& key) {
  const double value = bias.number(key, -1.0);
  if (value < 0.0 || value > 10.0) bias.fail(key, "'" + key + "' must be a number from 0 to 10");
  return value;
}

TechniqueBias read_bias(JsonObject object) {
  TechniqueBias bias;
  bias.depth = read_bias_setting(object, "depth");
  bias.normal = read_bias_setting(object, "normal");
  bias.soft_quality = object.text("soft_quality", bias.soft_quality);
  require_known(object, "soft_quality", "soft quality", bias.soft_quality, soft_qualities);
  object.finish();
  return bias;
}

double number_up_to(JsonObject& object, const std::string& key, double largest) {
  const double value = object.number(key, 0.0);
  if (!(value > 0.0 && value <= largest))
    object.fail(key, "'" + key + "' is not above 0 and at most " + std::to_string(static_cast<int>(largest)));
  return value;
}

// What commands and files call a technique or a look.
std::string required_name(JsonObject& object) {
  std::string name = required_text(object, "name");
  const bool plain =
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-") ==
      std::string::npos;
  if (!plain || name.size() > 100)
    object.fail("name", "a name has letters, digits, '.', '_' and '-', at most 100 of them");
  return name;
}

// The ranges are those of the renderer feature's options.
Look read_look(JsonObject object) {
  Look look{required_name(object), required_line(object, "title"), required_line(object, "doc"),
            number_up_to(object, "angularDiameterDegrees", 30.0),
            number_up_to(object, "maxPenumbraMetres", 100.0)};
  object.finish();
  return look;
}

// Names and values are each a look's own: the inspector tells by the values which look is set.
void add_looks(JsonObject& root, TechniqueList& list) {
  for (JsonObject& object : root.objects("looks")) {
    const Look look = read_look(object);
    for (const Look& other : list.looks) {
      if (other.name == look.name) object.fail("name", "there are two looks '" + look.name + "'");
      if (other.angular_diameter_degrees == look.angular_diameter_degrees &&
          other.max_penumbra_metres == look.max_penumbra_metres)
        object.fail("name", "'" + look.name + "' has the values of '" + other.name + "'");
    }
    list.looks.push_back(look);
  }
}

// Entries over the defaults of their manifest: what an entry leaves out is theirs.
class TechniqueReader {
 public:
  TechniqueReader(const Manifest& manifest, const TechniqueList& list,
                  std::map<std::string, PassGraph> graphs)
      : document_(manifest.document),
        list_(list),
        files_(manifest.file, list.package),
        graphs_(std::move(graphs)),
        defaults_(JsonObject(document_).object("defaults")),
        shared_values_(defaults_.object("values")) {
    for (const char* key : {"family", "source", "bias", "graph", "filter", "keywords", "unlimited",
                            "keyword_sets", "targets_absent"})
      defaults_.has(key);
    defaults_.finish();
  }

  Technique read(JsonObject object, const LocatedJson::Pointer& at) {
    const auto of = [&](const std::string& key) -> JsonObject& {
      return object.has(key) ? object : defaults_;
    };
    const auto place = [&](const std::string& key) {
      return (object.has(key) ? at : LocatedJson::Pointer("/defaults")) / key;
    };
    Technique technique;
    technique.name = required_name(object);
    technique.where = object.where("name");
    technique.title = required_line(object, "title");
    technique.family = required_line(of("family"), "family");
    technique.source = required_line(of("source"), "source");
    if (of("bias").has("bias")) technique.bias = read_bias(of("bias").object("bias"));
    if (object.has("graph") && object.has("filter"))
      object.fail("graph", "'" + technique.name + "' has both a graph and a filter", "give one of the two");
    technique.graph = graph(object.has("graph") || object.has("filter") ? object : defaults_);
    technique.keywords = read_keywords(of("keywords"), "keywords");
    const std::vector<ParameterField> fields = list_.fields_of(technique);
    read_values(object.object("values"), fields, technique);
    if (of("unlimited").has("unlimited"))
      read_unlimited(of("unlimited").object("unlimited"), fields, technique);
    if (!technique.unlimited.empty() && technique.graph.filter() == nullptr)
      of("unlimited")
          .fail("unlimited", "no pass of '" + technique.name + "' calls a filter",
                "say which one a pass calls: \"filter\": {...}");
    technique.keyword_sets = usual_keyword_sets(technique);
    if (of("keyword_sets").has("keyword_sets"))
      technique.keyword_sets = keyword_sets(of("keyword_sets"), document_.at(place("keyword_sets")));
    read_targets_absent(of("targets_absent").object("targets_absent"), technique);
    object.finish();
    return technique;
  }

  // After the last entry: a value that is no technique's.
  void finish() const { shared_values_.finish(); }

 private:
  PassGraph graph(JsonObject& from) {
    const bool alone = from.has("filter");
    const char* key = alone ? "filter" : "graph";
    PassGraph graph;
    if (alone) {
      graph = graph_of(read_filter(from.object(key), list_, files_), from.where(key));
    } else {
      const std::string name = required_text(from, key);
      std::vector<std::string> known;
      for (const auto& [known_name, known_graph] : graphs_) known.push_back(known_name);
      require_known(from, key, "graph", name, known);
      graph = graphs_.at(name);
    }
    if (const std::optional<GraphProblem> problem = graph_problem(graph)) {
      if (problem->where.empty()) from.fail(key, problem->text, problem->way_out);
      throw InputError(problem->where, problem->text, problem->way_out);
    }
    graph.passes = *in_running_order(graph);
    return graph;
  }

  // Every field has a value, and every value is a field's.
  void read_values(JsonObject own, const std::vector<ParameterField>& fields, Technique& technique) {
    for (const ParameterField& field : fields) {
      JsonObject& from = own.has(field.name) ? own : shared_values_;
      if (from.has(field.name)) {
        technique.values[field.name] = components(from, field.name, field);
        require_value(from, field.name, field, technique.values[field.name]);
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

  // Both directions of depth; of a filter also with unlimited samples, where it has those.
  static std::vector<std::vector<std::string>> usual_keyword_sets(const Technique& technique) {
    std::vector<std::vector<std::string>> sets{{}, {"UNITY_REVERSED_Z"}};
    if (!technique.unlimited.empty() && technique.graph.filter_pass() != nullptr) {
      sets.push_back({"PENUMBRA_UNLIMITED"});
      sets.push_back({"UNITY_REVERSED_Z", "PENUMBRA_UNLIMITED"});
    }
    return sets;
  }

  static std::vector<std::vector<std::string>> keyword_sets(JsonObject& object, const nlohmann::json& sets) {
    const auto refuse = [&] { object.fail("keyword_sets", "must be an array of arrays of strings"); };
    if (!sets.is_array()) refuse();
    if (sets.empty()) object.fail("keyword_sets", "'keyword_sets' is empty", "leave it out, or give [[]]");
    std::vector<std::vector<std::string>> result;
    for (const nlohmann::json& set : sets) {
      if (!set.is_array()) refuse();
      result.emplace_back();
      for (const nlohmann::json& keyword : set) {
        if (!keyword.is_string()) refuse();
        result.back().push_back(keyword.get<std::string>());
        if (!hlsl::is_identifier(result.back().back()))
          object.fail("keyword_sets", "'" + result.back().back() + "' is not a keyword");
      }
    }
    return result;
  }

  static void read_targets_absent(JsonObject object, Technique& technique) {
    for (const std::string& target : object.keys()) {
      require_known(object, target, "target", target, target_names);
      technique.targets_absent[target] = required_text(object, target);
    }
  }

  const LocatedJson& document_;
  const TechniqueList& list_;
  ManifestFiles files_;
  std::map<std::string, PassGraph> graphs_;
  JsonObject defaults_;
  JsonObject shared_values_;
};

}  // namespace

std::string required_text(JsonObject& object, const std::string& key) {
  std::string text = object.text(key, "");
  if (text.empty()) object.fail(key, "'" + key + "' is missing or empty");
  return text;
}

std::string required_line(JsonObject& object, const std::string& key) {
  std::string text = required_text(object, key);
  const bool printable =
      std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  if (!printable || text.back() == '\\')
    object.fail(key,
                "'" + key + "' is one line, without control characters, and does not end in a backslash");
  return text;
}

std::vector<std::string> read_keywords(JsonObject& object, const std::string& key) {
  std::vector<std::string> keywords = object.texts(key);
  for (const std::string& keyword : keywords) {
    if (!hlsl::is_identifier(keyword)) object.fail(key, "'" + keyword + "' is not a keyword");
    if (keyword == "UNITY_REVERSED_Z") object.fail(key, "'UNITY_REVERSED_Z' is the platform's to define");
  }
  return keywords;
}

std::string required_identifier(JsonObject& object, const std::string& key) {
  std::string name = required_text(object, key);
  if (!hlsl::is_identifier(name)) object.fail(key, "'" + name + "' is not an HLSL identifier");
  return name;
}

void require_known(JsonObject& object, const std::string& key, const std::string& what,
                   const std::string& name, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) == known.end())
    object.fail(key, "unknown " + what + " '" + name + "'", unknown_name_way_out(name, known));
}

Manifest open_manifest(const std::filesystem::path& file) {
  Manifest manifest{file, LocatedJson::read(file), 0};
  JsonObject root(manifest.document);
  manifest.order = root.integer("order", 0);
  return manifest;
}

void add_structs(const Manifest& manifest, TechniqueList& list) {
  JsonObject root(manifest.document);
  for (JsonObject& object : root.objects("structs")) {
    ParameterStruct parameters = read_struct(object);
    if (list.find_struct(parameters.name) != nullptr)
      object.fail("name", "there are two structs '" + parameters.name + "'");
    parameters.manifest = ManifestFiles(manifest.file, list.package).named(manifest.file);
    list.structs.push_back(std::move(parameters));
  }
}

void add_techniques(const Manifest& manifest, TechniqueList& list) {
  JsonObject root(manifest.document);
  for (const char* key : {"order", "structs", "defaults"}) root.has(key);  // read elsewhere
  const ManifestFiles files(manifest.file, list.package);
  std::map<std::string, PassGraph> graphs;
  for (JsonObject& object : root.objects("graphs")) {
    const std::string name = required_text(object, "name");
    if (!graphs.emplace(name, read_graph(object, list, files, graphs)).second)
      object.fail("name", "there are two graphs '" + name + "'");
  }
  TechniqueReader reader(manifest, list, std::move(graphs));
  std::size_t index = 0;
  for (JsonObject& object : root.objects("techniques")) {
    Technique technique = reader.read(object, LocatedJson::Pointer("/techniques") / index++);
    for (const Technique& other : list.techniques)
      if (other.name == technique.name)
        object.fail("name", "there are two techniques '" + technique.name + "'",
                    "the other one is at " + other.where);
    list.techniques.push_back(std::move(technique));
  }
  reader.finish();
  add_looks(root, list);
  root.finish();
}

}  // namespace penumbra::techniques
