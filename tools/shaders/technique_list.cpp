#include "shaders/technique_list.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "input/input_error.h"
#include "input/located_json.h"
#include "input/nearest_name.h"

namespace penumbra::shaders {
namespace {

const std::vector<std::string> kFieldTypes{"float", "float2", "float4", "int"};
const std::vector<std::string> kResources{"shadowMap", "pointSampler"};

void require_known(const JsonObject& object, const std::string& key, const std::string& name,
                   const std::vector<std::string>& known, const std::string& kind) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  object.fail(key, "unknown " + kind + " '" + name + "'", unknown_name_way_out(name, known));
}

std::string required_text(JsonObject& object, const std::string& key) {
  const std::string text = object.text(key, "");
  if (text.empty()) object.fail(key, "'" + key + "' is missing or empty");
  return text;
}

ParameterStruct read_struct(JsonObject& object) {
  ParameterStruct result;
  result.name = required_text(object, "name");
  result.doc = object.text("doc", "");
  for (JsonObject& field : object.objects("fields")) {
    ParameterField read;
    read.name = required_text(field, "name");
    read.type = required_text(field, "type");
    require_known(field, "type", read.type, kFieldTypes, "type");
    read.unit = field.text("unit", "");
    read.doc = field.text("doc", "");
    field.finish();
    result.fields.push_back(std::move(read));
  }
  object.finish();
  return result;
}

TechniquePass read_pass(JsonObject& object, const TechniqueList& list) {
  TechniquePass pass;
  pass.kind = required_text(object, "kind");
  require_known(object, "kind", pass.kind, {"resolve"}, "kind of pass");
  pass.file = required_text(object, "file");
  if (!std::filesystem::is_regular_file(list.file.parent_path() / pass.file)) {
    object.fail("file", "no such file: " + pass.file, "paths are relative to the list's own folder");
  }
  pass.function = required_text(object, "function");
  pass.resources = object.texts("resources");
  for (const std::string& resource : pass.resources) {
    require_known(object, "resources", resource, kResources, "resource");
  }
  pass.parameters = object.text("parameters", "");
  if (!pass.parameters.empty()) {
    std::vector<std::string> names;
    for (const ParameterStruct& known : list.structs) names.push_back(known.name);
    require_known(object, "parameters", pass.parameters, names, "parameter struct");
  }
  object.finish();
  return pass;
}

std::size_t width_of(const std::string& type) {
  if (type == "float2") return 2;
  return type == "float4" ? 4 : 1;
}

// One number, or as many as the field's type has.
std::vector<double> read_value(JsonObject& values, const ParameterField& field) {
  const std::size_t width = width_of(field.type);
  if (width > 1) return values.numbers(field.name, width);
  if (!values.has(field.name)) values.fail(field.name, "no value for '" + field.name + "'");
  const double value = values.number(field.name, 0.0);
  if (field.type == "int") values.integer(field.name, 0);
  return {value};
}

void read_values(JsonObject& object, Technique& technique, const TechniqueList& list) {
  JsonObject values = object.object("values");
  JsonObject unlimited = object.object("unlimited");
  for (const TechniquePass& pass : technique.chain) {
    const ParameterStruct* parameters = list.find_struct(pass.parameters);
    if (parameters == nullptr) continue;
    for (const ParameterField& field : parameters->fields) {
      technique.values[field.name] = read_value(values, field);
      if (!unlimited.has(field.name)) continue;
      std::ostringstream number;
      number.precision(17);
      number << unlimited.number(field.name, 0.0);
      technique.unlimited[field.name] = number.str();
    }
  }
  values.finish();
  unlimited.finish();
}

Technique read_technique(JsonObject& object, const TechniqueList& list, const nlohmann::json& raw) {
  Technique technique;
  technique.name = required_text(object, "name");
  technique.title = required_text(object, "title");
  technique.family = required_text(object, "family");
  technique.source = required_text(object, "source");
  for (JsonObject& pass : object.objects("chain")) technique.chain.push_back(read_pass(pass, list));
  if (technique.chain.empty()) object.fail("chain", "a technique needs at least one pass");
  read_values(object, technique, list);
  technique.keywords = object.texts("keywords");
  if (object.has("keyword_sets")) {
    const nlohmann::json& sets = raw.at("keyword_sets");
    const bool lists_of_strings =
        sets.is_array() && std::all_of(sets.begin(), sets.end(), [](const nlohmann::json& set) {
          return set.is_array() &&
                 std::all_of(set.begin(), set.end(), [](const auto& k) { return k.is_string(); });
        });
    if (!lists_of_strings)
      object.fail("keyword_sets", "'keyword_sets' must be an array of arrays of strings");
    technique.keyword_sets = sets.get<std::vector<std::vector<std::string>>>();
  }
  JsonObject absent = object.object("targets_absent");
  for (const std::string& target : absent.keys()) technique.targets_absent[target] = absent.text(target, "");
  object.finish();
  return technique;
}

std::string arguments_of(const TechniquePass& pass) {
  std::string arguments;
  for (const std::string& resource : pass.resources) {
    arguments += resource == "shadowMap" ? "TEXTURE2D_SHADOW_ARGS(_ShadowMap, sampler_ShadowMap), "
                                         : "sampler_PointClamp, ";
  }
  return arguments + "receiver, tile" + (pass.parameters.empty() ? "" : ", parameters");
}

}  // namespace

const Technique& TechniqueList::find(const std::string& name) const {
  std::vector<std::string> names;
  for (const Technique& technique : techniques) {
    if (technique.name == name) return technique;
    names.push_back(technique.name);
  }
  throw InputError("", "unknown technique '" + name + "'", unknown_name_way_out(name, names));
}

const ParameterStruct* TechniqueList::find_struct(const std::string& name) const {
  for (const ParameterStruct& known : structs) {
    if (known.name == name) return &known;
  }
  return nullptr;
}

TechniqueList read_technique_list(const std::filesystem::path& file) {
  const LocatedJson document = LocatedJson::read(file);
  JsonObject root(document);
  TechniqueList list;
  list.file = file;
  for (JsonObject& object : root.objects("structs")) {
    list.structs.push_back(read_struct(object));
    const std::string& name = list.structs.back().name;
    for (std::size_t i = 0; i + 1 < list.structs.size(); ++i) {
      if (list.structs[i].name == name) object.fail("name", "two structs are named '" + name + "'");
    }
  }
  std::set<std::string> names;
  std::size_t index = 0;
  for (JsonObject& object : root.objects("techniques")) {
    const nlohmann::json& raw = document.value().at("techniques").at(index++);
    list.techniques.push_back(read_technique(object, list, raw));
    const std::string& name = list.techniques.back().name;
    if (!names.insert(name).second) object.fail("name", "two techniques are named '" + name + "'");
  }
  root.finish();
  return list;
}

TechniqueCall emit_technique_call(const TechniqueList& list, const Technique& technique,
                                  const std::string& uniform_prefix) {
  const TechniquePass& pass = technique.chain.back();
  TechniqueCall call;
  call.includes = "#include \"" + pass.file + "\"\n";
  std::string assignments;
  if (const ParameterStruct* parameters = list.find_struct(pass.parameters)) {
    assignments = "    " + parameters->name + " parameters;\n";
    for (const ParameterField& field : parameters->fields) {
      const std::string uniform = uniform_prefix + parameters->name + "_" + field.name;
      call.declarations += field.type + " " + uniform + ";\n";
      assignments += "    parameters." + field.name + " = " + uniform + ";\n";
    }
  }
  const bool point =
      std::find(pass.resources.begin(), pass.resources.end(), "pointSampler") != pass.resources.end();
  call.declarations += "TEXTURE2D_SHADOW(_ShadowMap);\nSAMPLER_CMP(sampler_ShadowMap);\n";
  if (point) call.declarations += "SAMPLER(sampler_PointClamp);\n";
  call.function = "float ResolveTechnique(ShadowReceiver receiver, ShadowTile tile)\n{\n" + assignments +
                  "    return " + pass.function + "(" + arguments_of(pass) + ");\n}\n";
  return call;
}

}  // namespace penumbra::shaders
