#include "techniques/manifest_reader.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "hlsl/identifier.h"
#include "input/input_error.h"
#include "input/nearest_name.h"
#include "input/text_line.h"
#include "techniques/graph_reader.h"
#include "techniques/technique_values.h"

namespace penumbra::techniques {
namespace {

const std::vector<std::string> field_types = {"float", "float2", "float4", "int"};

// These names are reserved words of C# and HLSL, and members that an emitted struct has besides its fields.
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
  for (JsonObject& field : entries(object, "fields", 0, most_choices)) {
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

double number_up_to(JsonObject& object, const std::string& key, double largest) {
  const double value = object.number(key, 0.0);
  if (!(value > 0.0 && value <= largest))
    object.fail(key, "'" + key + "' is not above 0 and at most " + std::to_string(static_cast<int>(largest)));
  return value;
}

// The ranges are those of the renderer feature's options.
Look read_look(JsonObject object) {
  Look look{required_name(object), required_line(object, "title"), required_line(object, "doc"),
            number_up_to(object, "angularDiameterDegrees", 30.0),
            number_up_to(object, "maxPenumbraMetres", 100.0)};
  object.finish();
  return look;
}

// The check covers every text and every key: they become code, comments and documents of several languages.
// `name` is the name in messages of a text that is no key's value.
void require_lines(const LocatedJson& document, const LocatedJson::Pointer& at, const std::string& name) {
  const auto require = [&](const LocatedJson::Pointer& place, const std::string& text) {
    if (!is_one_line(text))
      throw InputError(document.where(place),
                       "'" + name + "' is one line, without control characters and marks of direction",
                       "write spaces in their place");
  };
  const nlohmann::json& value = document.at(at);
  if (value.is_string()) require(at, value.get_ref<const std::string&>());
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i) require_lines(document, at / i, name);
  if (!value.is_object()) return;
  for (const auto& member : value.items()) {
    require(at / member.key(), member.key());
    require_lines(document, at / member.key(), member.key());
  }
}

}  // namespace

void require_at_most(const JsonObject& object, const std::string& key, std::size_t count, std::size_t most,
                     const std::string& what) {
  if (count > most)
    object.fail(key,
                "there are " + std::to_string(count) + " " + what + ", and at most " + std::to_string(most) +
                    " can be checked",
                "leave some out, or split them");
}

std::vector<JsonObject> entries(JsonObject& root, const std::string& key, std::size_t before,
                                std::size_t most) {
  std::vector<JsonObject> objects = root.objects(key);
  require_at_most(root, key, before + objects.size(), most, key);
  return objects;
}

std::string required_text(JsonObject& object, const std::string& key) {
  std::string text = object.text(key, "");
  if (text.empty()) object.fail(key, "'" + key + "' is missing or empty");
  return text;
}

std::string required_name(JsonObject& object) {
  std::string name = required_text(object, "name");
  const bool plain =
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-") ==
      std::string::npos;
  if (!plain || name.size() > 100)
    object.fail("name", "a name has letters, digits, '.', '_' and '-', at most 100 of them");
  return name;
}

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

std::string required_line(JsonObject& object, const std::string& key) {
  std::string text = required_text(object, key);
  const std::size_t last = text.find_last_not_of(' ');
  if (last == std::string::npos) object.fail(key, "'" + key + "' is blank");
  if (text[last] == '\\')
    object.fail(key, "'" + key + "' is one line, and does not end in a backslash, which would continue it");
  return text;
}

std::vector<std::string> read_keywords(JsonObject& object, const std::string& key) {
  std::vector<std::string> keywords = object.texts(key);
  require_at_most(object, key, keywords.size(), 64, "keywords");
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
    object.fail(key, "unknown " + what + " '" + name + "'", unknown_name_remedy(name, known));
}

// Names and values belong to one look each: the inspector recognises by the values which look is set.
void add_looks(JsonObject& root, TechniqueList& list) {
  for (JsonObject& object : entries(root, "looks", list.looks.size(), most_choices)) {
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

Manifest open_manifest(const std::filesystem::path& file) {
  Manifest manifest{file, LocatedJson::read(file), 0};
  require_lines(manifest.document, LocatedJson::Pointer(), "manifest");
  JsonObject root(manifest.document);
  manifest.order = root.integer("order", 0);
  return manifest;
}

void add_structs(const Manifest& manifest, TechniqueList& list) {
  JsonObject root(manifest.document);
  for (JsonObject& object : entries(root, "structs", list.structs.size(), most_structs)) {
    ParameterStruct parameters = read_struct(object);
    if (list.find_struct(parameters.name) != nullptr)
      object.fail("name", "there are two structs '" + parameters.name + "'");
    parameters.manifest = ManifestFiles(manifest.file, list.package).named(manifest.file);
    list.structs.push_back(std::move(parameters));
  }
}

}  // namespace penumbra::techniques
