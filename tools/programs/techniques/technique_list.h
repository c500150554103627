// The techniques, their passes and their needs, as the manifests list them.
//
// A manifest, NAME.technique.json, stands beside the HLSL that it describes, so that a technique is added by
// adding its files. technique.schema.json says what its keys are. Files that it names are relative to it.
#pragma once

#include <filesystem>

#include "techniques/parameter_packing.h"
#include "techniques/pass_graph.h"
#include "techniques/selection.h"

namespace penumbra::techniques {

// The package's advice to its users: filters that follow the receiver's plane need no normal bias.
struct TechniqueBias {
  double depth = 1.0;  // URP's settings of the casters
  double normal = 0.0;
  std::string soft_quality = "medium";  // off, low, medium or high: it scales both
  double slope = 2.5;                   // the rasteriser's slope-scaled depth bias; URP's by default

  bool operator==(const TechniqueBias&) const = default;
};

// The settings that hold from a cascade on, up to the next rule: other values of the technique's parameters,
// or another technique's filter with its own.
struct CascadeRule {
  int from = 1;           // index of the first cascade
  std::string technique;  // the technique that has the filter; if empty, the same one
  FilterCall filter;      // filter of that technique
  std::map<std::string, std::vector<double>> values;  // for the same filter, only those that differ
  std::map<std::string, double> unlimited;            // see Technique::unlimited
};

// The light of a technique's map: a sun, in parallel and in cascades, or a spot light, in perspective.
enum class LightKind { directional, spot };

const char* name_of(LightKind kind);  // the name in manifests

struct Technique {
  std::string name;      // for example pcss-angular-24-16
  std::string title;     // title in tables
  std::string family;    // techniques of one family differ in parameters alone
  std::string source;    // paper, year
  std::string use_when;  // one line each, may be empty: the use for which its figures recommend it
  std::string not_when;  // and the use for which they do not
  TechniqueBias bias;    // the casters' bias that it should have, and at which it is measured
  std::vector<LightKind> lights{LightKind::directional};  // the lights that it supports
  PassGraph graph;
  std::map<std::string, std::vector<double>> values;   // parameter values by field
  std::vector<std::string> keywords;                   // keywords that this technique switches on
  std::vector<std::vector<std::string>> keyword_sets;  // every set validate compiles
  std::map<std::string, double> unlimited;             // fields to override for T3
  std::vector<CascadeRule> cascades;                   // by rising index; if empty, all cascades are alike
  std::map<std::string, std::string> targets_absent;   // target -> reason
  std::string where;                                   // file:line:column of its name
  std::string manifest{};                              // the declaring file, as in NamedGraph
  std::string graph_name{};  // one of that manifest's graphs; empty for a filter alone

  // Returns the file that reports name: that of its filter or, where it runs over the screen, of its last
  // pass.
  const std::string& file() const;
  std::vector<std::string> all_keywords() const;  // its own, then its graph's
  bool is_for(LightKind kind) const;
  bool is_sampled() const;  // has unlimited values, in some cascade at least
};

// A graph of a manifest by its own name, whether a technique of the list has it or not.
struct NamedGraph {
  std::string name;
  std::string manifest;  // path, relative to the list's package if it lies in it
  std::string where;     // file:line:column of its name
  PassGraph graph;       // checked, and in running order
};

// The appearance of a light, whatever technique draws its shadows: an artist's choice beside the quality
// presets.
struct Look {
  std::string name;                       // for example crisp-noon
  std::string title;                      // for inspectors and pages
  std::string doc;                        // the description, one sentence
  double angular_diameter_degrees = 0.0;  // full angle of the light's disc, above 0 to 30
  double max_penumbra_metres = 0.0;       // widest penumbra, full width, above 0 to 100
};

struct TechniqueList {
  std::filesystem::path package;  // its folder; files that lie in it are named relative to it
  std::string addition{};         // a manifest that adds to the package's, as in NamedGraph; or empty
  std::vector<ParameterStruct> structs;
  std::vector<Technique> techniques;
  std::vector<NamedGraph> graphs;  // all graphs but those that are parts of others
  std::vector<Look> looks;
  std::vector<FeatureOption> options;  // options in the order in which inspectors show them
  std::vector<Selection> selections;
  std::vector<PresetChoice> presets;  // choices of presets that draw passes of a selection

  const Technique& find(const std::string& name) const;  // throws InputError with the nearest name
  const Technique& first() const;                        // of the addition, or of all without one
  const ParameterStruct* find_struct(const std::string& name) const;
  // Returns the folders for the includes of technique_call.h.
  std::vector<std::filesystem::path> include_directories() const;
  // Returns the structs of the technique's passes, each once, in their order.
  std::vector<const ParameterStruct*> structs_of(const Technique& technique) const;
  std::vector<ParameterField> fields_of(const Technique& technique) const;  // fields of these structs
};

inline constexpr const char* manifest_ending = ".technique.json";

// Reads every manifest in ShaderLibrary/ and Shaders/ of a package's folder, in the order that they give, and
// its looks; or one manifest alone, or with those of the package that its "library" names. Throws InputError
// with file:line:column.
TechniqueList read_technique_list(const std::filesystem::path& package_or_manifest);

// Reads those of this program's own package.
TechniqueList read_own_techniques();

// A technique with other values than the list gives it.
//
// Describes the problem of a value of the field: no finite number, not whole where the field is an int, out
// of range. The result is empty if there is none.
std::string value_problem(const ParameterField& field, double value);

// Throws InputError, naming the technique and its parameters, when it has none of that name, and for a value
// that value_problem() refuses.
Technique with_value(const TechniqueList& list, Technique technique, const std::string& parameter,
                     double value);

}  // namespace penumbra::techniques
