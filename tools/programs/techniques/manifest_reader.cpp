#include "techniques/manifest_reader.h"

#include <algorithm>
#include <set>

#include "input/input_error.h"
#include "input/nearest_name.h"
#include "techniques/graph_reader.h"
#include "techniques/manifest_check.h"
#include "techniques/technique_list.h"

namespace penumbra::techniques {
namespace {

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
  ParameterField field{object.text("name", ""),
                       object.text("type", ""),
                       object.text("unit", ""),
                       object.text("doc", ""),
                       {},
                       {}};
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
  return field;
}

ParameterStruct read_struct(JsonObject object) {
  ParameterStruct parameters{object.text("name", ""), object.text("doc", ""), {}, {}};
  std::set<std::string> seen;
  for (JsonObject& field : object.objects("fields")) {
    parameters.fields.push_back(read_field(field));
    const std::string& name = parameters.fields.back().name;
    if (!seen.insert(name).second) field.fail("name", "there are two fields '" + name + "'");
    if (name == parameters.name || is_reserved(name))
      field.fail("name", "'" + name + "' is a word of C#, of HLSL or of the emitted struct",
                 "choose another");
  }
  return parameters;
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

std::vector<std::string> read_keywords(JsonObject& object) {
  std::vector<std::string> keywords = object.texts("keywords");
  for (const std::string& keyword : keywords)
    if (keyword == "UNITY_REVERSED_Z")
      object.fail("keywords", "'UNITY_REVERSED_Z' is the platform's to define");
  return keywords;
}

void require_known(JsonObject& object, const std::string& key, const std::string& what,
                   const std::string& name, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) == known.end())
    object.fail(key, "unknown " + what + " '" + name + "'", unknown_name_remedy(name, known));
}

const Technique& named_technique(JsonObject& object, const std::string& key, const TechniqueList& list,
                                 const std::string& kind, bool (*fits)(const Technique&)) {
  const std::string name = object.text(key, "");
  const auto is_fit = [fits](const Technique& technique) { return fits == nullptr || fits(technique); };
  for (const Technique& technique : list.techniques)
    if (technique.name == name && is_fit(technique)) return technique;
  std::vector<std::string> known;
  for (const Technique& technique : list.techniques)
    if (is_fit(technique)) known.push_back(technique.name);
  object.fail(key, "unknown " + kind + " '" + name + "'", unknown_name_remedy(name, known));
}

// Names and values belong to one look each: the inspector recognises by the values which look is set.
void add_looks(JsonObject& root, TechniqueList& list) {
  for (JsonObject& object : entries(root, "looks", list.looks.size(), most_choices)) {
    const Look look{object.text("name", ""), object.text("title", ""), object.text("doc", ""),
                    object.number("angularDiameterDegrees", 0.0), object.number("maxPenumbraMetres", 0.0)};
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
  check_manifest(manifest.document);
  manifest.order = JsonObject(manifest.document).integer("order", 0);
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
