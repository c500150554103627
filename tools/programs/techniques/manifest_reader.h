// Reads one manifest. Internal to this folder. The readers check what its schema cannot say: names that refer
// to something, names that may not repeat, values of declared fields, and files.
#pragma once

#include <cstddef>

#include "input/located_json.h"
#include "techniques/technique_list.h"

namespace penumbra::techniques {

// A manifest whose structs are known and whose techniques are not read yet: they may use another's structs.
struct Manifest {
  std::filesystem::path file;
  LocatedJson document;
  int order = 0;  // its place among the manifests of a package
};

// Throws InputError with file:line:column, as all of this file does. What it returns has been checked
// (manifest_check.h).
Manifest open_manifest(const std::filesystem::path& file);

using Graphs = std::map<std::string, PassGraph>;

// Adds what the manifest has to the list. All manifests' structs and options come before the first's
// techniques. add_techniques() adds its looks and selections, too; it returns the graphs of its library and
// of its own.
void add_structs(const Manifest& manifest, TechniqueList& list);
void add_options(const Manifest& manifest, TechniqueList& list);
Graphs add_techniques(const Manifest& manifest, TechniqueList& list, Graphs of_library);

// The largest number of techniques in a list: beyond it the checks, which compare each entry with the others,
// take minutes.
inline constexpr std::size_t most_techniques = 4096;
inline constexpr std::size_t most_graphs = 4096;
inline constexpr std::size_t most_structs = 1024;
inline constexpr std::size_t most_choices = 256;  // limit for each of options, selections, presets and looks
inline constexpr std::size_t most_graph_items =
    65536;  // limit for passes and textures of all techniques together

// The functions below serve several readers of a manifest's objects. entries() returns the objects of one of
// its lists; `before` is their number in earlier manifests.
std::vector<JsonObject> entries(JsonObject& root, const std::string& key, std::size_t before,
                                std::size_t most);
void require_at_most(const JsonObject& object, const std::string& key, std::size_t count, std::size_t most,
                     const std::string& what);
std::vector<std::string> read_keywords(JsonObject& object);
void require_known(JsonObject& object, const std::string& key, const std::string& what,
                   const std::string& name, const std::vector<std::string>& known);
// Returns the technique that the key names, one of the list so far that `fits`; without `fits`, any. Throws
// InputError with the nearest of their names.
const Technique& named_technique(JsonObject& object, const std::string& key, const TechniqueList& list,
                                 const std::string& kind = "technique",
                                 bool (*fits)(const Technique&) = nullptr);
void add_looks(JsonObject& root, TechniqueList& list);
void add_selections(JsonObject& root, TechniqueList& list);  // called after the techniques
void add_presets(JsonObject& root, TechniqueList& list);     // called after the selections

// Returns a parameter's value: one number for each component. require_value() throws where value_problem()
// has one.
std::vector<double> components(JsonObject& object, const std::string& key, const ParameterField& field);
void require_value(JsonObject& object, const std::string& key, const ParameterField& field,
                   const std::vector<double>& components);

}  // namespace penumbra::techniques
