#include "shaders/technique_list.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "hlsl/identifier.h"
#include "input/input_error.h"
#include "input/located_json.h"
#include "input/nearest_name.h"
#include "shaders/technique_chain.h"
#include "shaders/technique_values.h"

namespace penumbra::shaders {

namespace {

const std::vector<std::string> field_types = {"float", "float2", "float4", "int"};
const std::vector<std::string> soft_qualities = {"off", "low", "medium", "high"};
const std::vector<std::string> target_names = {"spirv", "essl310", "glsl450", "msl23", "hlsl50"};

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

std::string required_text(JsonObject& object, const std::string& key) {
  std::string text = object.text(key, "");
  if (text.empty()) object.fail(key, "'" + key + "' is missing or empty");
  return text;
}

std::string required_identifier(JsonObject& object, const std::string& key) {
  std::string name = required_text(object, key);
  if (!hlsl::is_identifier(name)) object.fail(key, "'" + name + "' is not an HLSL identifier");
  return name;
}

void require_known(JsonObject& object, const std::string& key, const std::string& what,
                   const std::string& name, const std::vector<std::string>& known) {
  if (!contains(known, name))
    object.fail(key, "unknown " + what + " '" + name + "'", unknown_name_way_out(name, known));
}

std::size_t components(const ParameterField& field) {
  if (field.type == "float2") return 2;
  return field.type == "float4" ? 4 : 1;
}

std::vector<std::string> field_names(const ParameterStruct* parameters) {
  std::vector<std::string> names;
  if (parameters != nullptr)
    for (const ParameterField& field : parameters->fields) names.push_back(field.name);
  return names;
}

ParameterField read_field(JsonObject object) {
  ParameterField field{required_identifier(object, "name"), required_text(object, "type"),
                       required_text(object, "unit"), required_text(object, "doc"), std::nullopt};
  require_known(object, "type", "type", field.type, field_types);
  if (object.has("range")) {
    const std::vector<double> ends = object.numbers("range", 2);
    if (ends[0] > ends[1]) object.fail("range", "the smallest value comes after the largest");
    field.range = {ends[0], ends[1]};
  }
  object.finish();
  return field;
}

ParameterStruct read_struct(JsonObject object) {
  ParameterStruct parameters{required_identifier(object, "name"), required_text(object, "doc"), {}};
  std::set<std::string> seen;
  for (JsonObject& field : object.objects("fields")) {
    parameters.fields.push_back(read_field(field));
    const std::string& name = parameters.fields.back().name;
    if (!seen.insert(name).second) field.fail("name", "there are two fields '" + name + "'");
  }
  if (parameters.fields.empty()) object.fail("fields", "'" + parameters.name + "' has no fields");
  object.finish();
  return parameters;
}

TechniquePass read_pass(const TechniqueList& list, JsonObject object) {
  TechniquePass pass;
  pass.kind = required_text(object, "kind");
  require_known(object, "kind", "kind of pass", pass.kind, pass_kind_names());
  pass.file = required_text(object, "file");
  pass.function = required_identifier(object, "function");
  pass.resources = object.texts("resources");
  pass.parameters = object.text("parameters", "");
  pass.scale = object.integer("scale", 1);
  std::error_code error;
  if (!std::filesystem::is_regular_file(list.file.parent_path() / pass.file, error))
    object.fail("file", "there is no file '" + (list.file.parent_path() / pass.file).string() + "'");
  for (const std::string& resource : pass.resources)
    require_known(object, "resources", "resource", resource, pass_kind(pass.kind).resources);
  if (!pass.parameters.empty() && list.find_struct(pass.parameters) == nullptr) {
    std::vector<std::string> known;
    for (const ParameterStruct& parameters : list.structs) known.push_back(parameters.name);
    require_known(object, "parameters", "struct", pass.parameters, known);
  }
  object.finish();
  return pass;
}

// Every field has a value and every value a field.
void read_values(JsonObject object, const std::vector<const ParameterStruct*>& structs,
                 Technique& technique) {
  for (const ParameterStruct* parameters : structs) {
    for (const ParameterField& field : parameters->fields) {
      if (!object.has(field.name))
        object.fail(field.name, "no value for '" + field.name + "' of " + parameters->name);
      technique.values[field.name] = components(field) == 1
                                         ? std::vector<double>{object.number(field.name, 0.0)}
                                         : object.numbers(field.name, components(field));
      if (field.type == "int") object.integer(field.name, 0);
      for (const double value : technique.values[field.name]) {
        const std::string problem = value_problem(field, value);
        if (!problem.empty()) object.fail(field.name, problem);
      }
    }
  }
  object.finish();
}

// A number, or a string that holds one, as text that reads back exactly.
std::string number_text(JsonObject& object, const std::string& key, const nlohmann::json& value) {
  if (value.is_string()) {
    std::string text = object.text(key, "");
    char* end = nullptr;
    std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0') object.fail(key, "'" + text + "' is not a number");
    return text;
  }
  std::ostringstream number;
  number.precision(17);
  number << object.number(key, 0.0);
  return number.str();
}

void read_unlimited(JsonObject object, const nlohmann::json& values,
                    const std::vector<const ParameterStruct*>& structs, Technique& technique) {
  for (const std::string& key : object.keys()) {
    std::vector<std::string> known;
    for (const ParameterStruct* parameters : structs)
      for (const std::string& name : field_names(parameters)) known.push_back(name);
    require_known(object, key, "field", key, known);
    technique.unlimited[key] = number_text(object, key, values.at(key));
  }
}

void check_keyword(JsonObject& object, const std::string& key, const std::string& keyword) {
  if (!hlsl::is_identifier(keyword)) object.fail(key, "'" + keyword + "' is not a keyword");
}

std::vector<std::vector<std::string>> read_keyword_sets(const LocatedJson& document, JsonObject& object,
                                                        const LocatedJson::Pointer& at) {
  if (!object.has("keyword_sets")) return {{}};
  const nlohmann::json& sets = document.at(at / "keyword_sets");
  if (!sets.is_array() || sets.empty()) object.fail("keyword_sets", "must be an array of arrays of strings");
  std::vector<std::vector<std::string>> result;
  for (const nlohmann::json& set : sets) {
    if (!set.is_array()) object.fail("keyword_sets", "must be an array of arrays of strings");
    result.emplace_back();
    for (const nlohmann::json& keyword : set) {
      if (!keyword.is_string()) object.fail("keyword_sets", "must be an array of arrays of strings");
      result.back().push_back(keyword.get<std::string>());
      check_keyword(object, "keyword_sets", result.back().back());
    }
  }
  return result;
}

void read_targets_absent(JsonObject object, Technique& technique) {
  for (const std::string& target : object.keys()) {
    require_known(object, target, "target", target, target_names);
    technique.targets_absent[target] = required_text(object, target);
  }
}

double read_bias_setting(JsonObject& bias, const std::string& key) {
  const double value = bias.number(key, -1.0);
  if (value < 0.0 || value > 10.0) bias.fail(key, "'" + key + "' must be a number from 0 to 10");
  return value;
}

TechniqueBias read_bias(JsonObject& technique) {
  TechniqueBias bias;
  if (!technique.has("bias")) return bias;
  JsonObject object = technique.object("bias");
  bias.depth = read_bias_setting(object, "depth");
  bias.normal = read_bias_setting(object, "normal");
  bias.soft_quality = object.text("soft_quality", bias.soft_quality);
  if (!contains(soft_qualities, bias.soft_quality)) {
    object.fail("soft_quality", "unknown soft quality '" + bias.soft_quality + "'",
                unknown_name_way_out(bias.soft_quality, soft_qualities));
  }
  object.finish();
  return bias;
}

Technique read_technique(const LocatedJson& document, const TechniqueList& list, JsonObject object,
                         const LocatedJson::Pointer& at) {
  Technique technique;
  technique.name = required_text(object, "name");
  technique.title = required_text(object, "title");
  technique.family = required_text(object, "family");
  technique.source = required_text(object, "source");
  technique.screen = object.boolean("screen", false);
  technique.bias = read_bias(object);
  std::vector<const ParameterStruct*> structs;
  for (const JsonObject& pass : object.objects("chain")) {
    technique.chain.push_back(read_pass(list, pass));
    const ParameterStruct* parameters = list.find_struct(technique.chain.back().parameters);
    if (parameters != nullptr) structs.push_back(parameters);
  }
  const ChainProblem problem = chain_problem(technique);
  if (!problem.text.empty()) object.fail("chain", problem.text, problem.way_out);
  read_values(object.object("values"), structs, technique);
  technique.keywords = object.texts("keywords");
  for (const std::string& keyword : technique.keywords) check_keyword(object, "keywords", keyword);
  technique.keyword_sets = read_keyword_sets(document, object, at);
  if (object.has("unlimited"))
    read_unlimited(object.object("unlimited"), document.at(at / "unlimited"), structs, technique);
  read_targets_absent(object.object("targets_absent"), technique);
  object.finish();
  return technique;
}

double number_up_to(JsonObject& object, const std::string& key, double largest) {
  const double value = object.number(key, 0.0);
  if (!(value > 0.0 && value <= largest))
    object.fail(key, "'" + key + "' is not above 0 and at most " + std::to_string(static_cast<int>(largest)));
  return value;
}

// The ranges are those of the renderer feature's options.
Look read_look(JsonObject object) {
  Look look{required_text(object, "name"), required_text(object, "title"), required_text(object, "doc"),
            number_up_to(object, "angularDiameterDegrees", 30.0),
            number_up_to(object, "maxPenumbraMetres", 100.0)};
  object.finish();
  return look;
}

// Names and values are each a look's own: the inspector tells by the values which look is set.
void read_looks(JsonObject& root, TechniqueList& list) {
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

}  // namespace

const Technique& TechniqueList::find(const std::string& name) const {
  std::vector<std::string> known;
  for (const Technique& technique : techniques) {
    if (technique.name == name) return technique;
    known.push_back(technique.name);
  }
  throw InputError(file.string(), "unknown technique '" + name + "'", unknown_name_way_out(name, known));
}

const TechniquePass& Technique::resolve() const {
  const auto found = std::find_if(chain.begin(), chain.end(),
                                  [](const TechniquePass& pass) { return pass.kind == "resolve"; });
  if (found == chain.end()) throw std::logic_error("technique '" + name + "' has no resolve pass");
  return *found;
}

const ParameterStruct* TechniqueList::find_struct(const std::string& name) const {
  const auto found = std::find_if(structs.begin(), structs.end(),
                                  [&](const ParameterStruct& parameters) { return parameters.name == name; });
  return found == structs.end() ? nullptr : &*found;
}

TechniqueList read_technique_list(const std::filesystem::path& file) {
  const LocatedJson document = LocatedJson::read(file);
  JsonObject root(document);
  TechniqueList list;
  list.file = file;
  for (JsonObject& object : root.objects("structs")) {
    ParameterStruct parameters = read_struct(object);
    if (list.find_struct(parameters.name) != nullptr)
      object.fail("name", "there are two structs '" + parameters.name + "'");
    list.structs.push_back(std::move(parameters));
  }
  std::set<std::string> names;
  std::size_t index = 0;
  for (JsonObject& object : root.objects("techniques")) {
    list.techniques.push_back(
        read_technique(document, list, object, LocatedJson::Pointer("/techniques") / index++));
    const std::string& name = list.techniques.back().name;
    if (!names.insert(name).second) object.fail("name", "there are two techniques '" + name + "'");
  }
  if (list.techniques.empty()) root.fail("techniques", "the list has no techniques");
  if (root.has("looks")) read_looks(root, list);
  root.finish();
  return list;
}

}  // namespace penumbra::shaders
