#include "techniques/technique_list.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <system_error>

#include "input/input_error.h"
#include "input/nearest_name.h"
#include "platform/data_directory.h"
#include "project/include_bounds.h"
#include "techniques/graph_reader.h"
#include "techniques/manifest_reader.h"

namespace penumbra::techniques {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> manifests_in(const fs::path& package) {
  std::vector<fs::path> files;
  for (const char* folder : {"ShaderLibrary", "Shaders"}) {
    std::error_code error;
    for (fs::recursive_directory_iterator entry(package / folder, error), end; !error && entry != end;
         entry.increment(error))
      if (entry->path().filename().string().ends_with(manifest_ending)) files.push_back(entry->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// Suggests a technique for a name that pages and the inspector use, such as "VSM"; empty if none has it.
std::string titled(const std::string& given, const std::vector<Technique>& techniques) {
  constexpr std::size_t kMostListed = 4;
  std::string names;
  std::size_t count = 0;
  for (const Technique& technique : techniques) {
    const std::string title = technique.title.substr(0, technique.title.find_first_of(",("));
    if (lower(title) != lower(given) || ++count > kMostListed) continue;
    names += (names.empty() ? "'" : ", '") + technique.name + "'";
  }
  if (names.empty()) return {};
  return "did you mean " + names + (count > kMostListed ? " or others of that title?" : "?");
}

// Adds the manifests in their order, and returns their graphs by name; of two with one name, the first.
Graphs add_package(std::vector<Manifest> manifests, TechniqueList& list) {
  std::stable_sort(manifests.begin(), manifests.end(),
                   [](const Manifest& a, const Manifest& b) { return a.order < b.order; });
  for (const Manifest& manifest : manifests) add_structs(manifest, list);
  for (const Manifest& manifest : manifests) add_options(manifest, list);
  Graphs graphs;
  for (const Manifest& manifest : manifests) graphs.merge(add_techniques(manifest, list, {}));
  return graphs;
}

// Returns the folder of the package. A manifest may come from an untrusted source, and messages quote lines
// of the files that it leads to: they lie in the manifest's own tree.
fs::path library_of(const Manifest& manifest, const project::IncludeBounds& tree) {
  JsonObject root(manifest.document);
  const std::string name = root.text("library", "");
  const fs::path folder =
      (fs::absolute(manifest.file).parent_path() / name / "").lexically_normal().parent_path();
  if (!tree.contain_package(folder))
    root.fail("library",
              "'" + name + "' lies outside of '" + project::own_tree(manifest.file).string() +
                  "', to which the manifest belongs",
              "name a package in the folder of the manifest, its package or its git repository");
  std::error_code error;
  if (!fs::is_regular_file(folder / "package.json", error))
    root.fail("library", "there is no package in '" + folder.string() + "'",
              "name the folder that holds a package.json, relative to the manifest");
  return folder;
}

// Adds the manifest to those of its library, at the place that its order has among them.
void add_with_library(const Manifest& manifest, TechniqueList& list) {
  project::IncludeBounds tree;
  tree.add(project::own_tree(manifest.file));
  list.package = library_of(manifest, tree);
  list.addition = ManifestFiles(manifest.file, list.package).named(manifest.file);
  std::vector<Manifest> manifests;
  for (const fs::path& file : manifests_in(list.package)) {
    tree.require(file);
    manifests.push_back(open_manifest(file));
    if (JsonObject root(manifests.back().document); root.has("library"))
      root.fail("library", "a manifest of the package '" + list.package.string() + "' has no library itself",
                "leave it out: manifests in ShaderLibrary and Shaders know each other");
  }
  std::map<std::string, int> orders;
  for (const Manifest& each : manifests)
    orders[ManifestFiles(each.file, list.package).named(each.file)] = each.order;
  Graphs graphs = add_package(std::move(manifests), list);
  const auto of_library = static_cast<std::ptrdiff_t>(list.techniques.size());
  add_structs(manifest, list);
  add_options(manifest, list);
  add_techniques(manifest, list, std::move(graphs));
  const auto begin = list.techniques.begin();
  const auto later = std::find_if(begin, begin + of_library, [&](const Technique& technique) {
    return orders.at(technique.manifest) > manifest.order;
  });
  std::rotate(later, begin + of_library, list.techniques.end());
}

// Suggests the nearest name and lists all of them, because they differ from technique to technique.
std::string known_parameters(const std::string& given, const std::vector<ParameterField>& fields) {
  if (fields.empty()) return "it has no parameters";
  std::vector<std::string> names;
  std::string list;
  for (const ParameterField& field : fields) {
    names.push_back(field.name);
    list += (list.empty() ? "" : ", ") + field.name;
  }
  const std::string nearest = nearest_name(given, names);
  return (nearest.empty() ? "" : "did you mean '" + nearest + "'? ") + "its parameters are: " + list;
}

}  // namespace

const std::string& Technique::file() const {
  const GraphPass& last = graph.passes.back();
  return last.kind == PassKind::filter ? last.filter->file : last.file;
}

std::vector<std::string> Technique::all_keywords() const {
  std::vector<std::string> all = keywords;
  all.insert(all.end(), graph.keywords.begin(), graph.keywords.end());
  return all;
}

const char* name_of(LightKind kind) {
  return kind == LightKind::spot ? "spot" : "directional";
}

bool Technique::is_for(LightKind kind) const {
  return std::find(lights.begin(), lights.end(), kind) != lights.end();
}

bool Technique::is_sampled() const {
  return !unlimited.empty() || std::any_of(cascades.begin(), cascades.end(),
                                           [](const CascadeRule& rule) { return !rule.unlimited.empty(); });
}

const Technique& TechniqueList::find(const std::string& name) const {
  std::vector<std::string> known;
  for (const Technique& technique : techniques) {
    if (technique.name == name) return technique;
    known.push_back(technique.name);
  }
  std::string remedy = titled(name, techniques);
  if (remedy.empty()) remedy = unknown_name_remedy(name, known) + "\n--list-techniques prints them all";
  throw InputError("", "unknown technique '" + name + "'", remedy);
}

const Technique& TechniqueList::first() const {
  const auto is_of_it = [&](const Technique& technique) { return technique.manifest == addition; };
  const auto found = std::find_if(techniques.begin(), techniques.end(), is_of_it);
  return found == techniques.end() ? techniques.front() : *found;
}

const ParameterStruct* TechniqueList::find_struct(const std::string& name) const {
  const auto found = std::find_if(structs.begin(), structs.end(),
                                  [&](const ParameterStruct& parameters) { return parameters.name == name; });
  return found == structs.end() ? nullptr : &*found;
}

std::vector<fs::path> TechniqueList::include_directories() const {
  std::error_code error;
  const bool has_library = fs::is_directory(package / "ShaderLibrary", error);
  const fs::path library = (has_library ? package : platform::data_directory()) / "ShaderLibrary";
  if (project::no_file_owns(package)) return {library};
  return {package, library};
}

std::vector<const ParameterStruct*> TechniqueList::structs_of(const Technique& technique) const {
  std::vector<const ParameterStruct*> used;
  const auto add = [&](const std::string& name) {
    const ParameterStruct* parameters = find_struct(name);
    if (parameters != nullptr && std::find(used.begin(), used.end(), parameters) == used.end())
      used.push_back(parameters);
  };
  for (const GraphPass& pass : technique.graph.passes) {
    for (const std::string& name : pass.parameters) add(name);
    if (pass.filter) add(pass.filter->parameters);
  }
  return used;
}

std::vector<ParameterField> TechniqueList::fields_of(const Technique& technique) const {
  std::vector<ParameterField> fields;
  for (const ParameterStruct* parameters : structs_of(technique))
    fields.insert(fields.end(), parameters->fields.begin(), parameters->fields.end());
  return fields;
}

TechniqueList read_technique_list(const fs::path& package_or_manifest) {
  TechniqueList list;
  std::error_code error;
  if (fs::is_directory(package_or_manifest, error)) {
    list.package = package_or_manifest;
    project::IncludeBounds tree;
    tree.add(list.package);
    tree.add(project::own_tree(list.package / "package.json"));
    std::vector<Manifest> manifests;
    for (const fs::path& file : manifests_in(list.package)) {
      tree.require(file);
      manifests.push_back(open_manifest(file));
    }
    add_package(std::move(manifests), list);
  } else {
    const Manifest manifest = open_manifest(package_or_manifest);
    list.package = fs::absolute(package_or_manifest).parent_path();
    if (JsonObject(manifest.document).has("library"))
      add_with_library(manifest, list);
    else
      add_package({manifest}, list);
  }
  if (list.techniques.empty())
    throw InputError(package_or_manifest.string(), "there are no techniques",
                     std::string("a manifest, NAME") + manifest_ending + ", lists them under \"techniques\"");
  return list;
}

TechniqueList read_own_techniques() {
  return read_technique_list(platform::data_directory());
}

std::string value_problem(const ParameterField& field, double value) {
  const bool whole = field.type != "int" || value == std::floor(value);
  const bool within = !field.range || (value >= field.range->smallest && value <= field.range->largest);
  const double most =
      field.type == "int" ? 16777216.0 : static_cast<double>(std::numeric_limits<float>::max());
  if (std::abs(value) <= most && whole && within) return {};
  std::ostringstream text;
  text << "'" << field.name << "' is a " << (field.type == "int" ? "whole number" : "number");
  if (field.range) text << " from " << field.range->smallest << " to " << field.range->largest;
  text << ", not " << value;
  return text.str();
}

Technique with_value(const TechniqueList& list, Technique technique, const std::string& parameter,
                     double value) {
  const std::vector<ParameterField> fields = list.fields_of(technique);
  for (const ParameterField& field : fields) {
    if (field.name != parameter) continue;
    if (technique.values.at(parameter).size() != 1)
      throw InputError("", "'" + parameter + "' of technique '" + technique.name + "' is a " + field.type +
                               ", and only single numbers can be set");
    const std::string problem = value_problem(field, value);
    if (!problem.empty()) throw InputError("", "technique '" + technique.name + "': " + problem);
    technique.values[parameter] = {value};
    return technique;
  }
  throw InputError("", "technique '" + technique.name + "' has no parameter '" + parameter + "'",
                   known_parameters(parameter, fields));
}

}  // namespace penumbra::techniques
