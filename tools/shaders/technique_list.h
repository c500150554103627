// ShaderLibrary/techniques.json: which techniques there are, how their functions are called, what they need.
//
// {"structs": [{name, doc, fields: [{name, type, unit, doc, range: [smallest, largest]}]}],
//  "techniques": [{name, title, family, source, screen,
//                  bias: {depth, normal, soft_quality},
//                  chain: [{kind, file, function, resources, parameters, scale}],
//                  values: {field: number or numbers}, keywords, keyword_sets: [[...]],
//                  unlimited: {field: number or its text}, targets_absent: {target: reason}}],
//  "looks": [{name, title, doc, angularDiameterDegrees, maxPenumbraMetres}]}
// Keys are the members' names below; screen is false, bias TechniqueBias's own, scale 1 and there are no
// looks where they are left out. Every field of the structs a chain uses has a value, within the field's
// range where it has one, and every value a field; without keyword_sets there is one set, the empty one.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace penumbra::shaders {

struct ParameterRange {
  double smallest = 0.0;
  double largest = 0.0;
};

// One field of a parameter struct; `unit` and `doc` go into the emitted HLSL.
struct ParameterField {
  std::string name;
  std::string type;  // float, float2, float4 or int
  std::string unit;
  std::string doc;
  std::optional<ParameterRange> range;  // absent: any finite value
};

struct ParameterStruct {
  std::string name;
  std::string doc;
  std::vector<ParameterField> fields;
};

// One pass of a technique's chain, of a kind that technique_chain.h knows. For "resolve" the function's
// arguments are the resources in order, then ShadowReceiver, ShadowTile and, when `parameters` is not empty,
// that struct.
struct TechniquePass {
  std::string kind;
  std::string file;  // relative to ShaderLibrary/
  std::string function;
  std::vector<std::string> resources;  // of: shadowMap+compare ("shadowMap"), "pointSampler", "cameraDepth",
                                       // "mask", and what the pass before wrote ("source")
  std::string parameters;              // struct name, may be empty
  int scale = 1;                       // pixels of the screen per pixel of what it writes, each way
};

// The package's advice to its users: filters that follow the receiver's plane need no normal bias.
struct TechniqueBias {
  double depth = 1.0;  // URP's settings of the casters
  double normal = 0.0;
  std::string soft_quality = "medium";  // off, low, medium or high: what scales both

  bool operator==(const TechniqueBias&) const = default;
};

struct Technique {
  std::string name;    // for example pcss-angular-24-16
  std::string title;   // for tables
  std::string family;  // techniques of one family differ in parameters alone
  std::string source;  // paper, year
  // Runs over the screen as the passes of Shaders/PenumbraShadows.shader, from the camera's depth; else a
  // function that is called for a surface known exactly.
  bool screen = false;
  TechniqueBias bias;  // the casters' that it should have, and is measured at
  std::vector<TechniquePass> chain;
  std::map<std::string, std::vector<double>> values;   // parameter values by field
  std::vector<std::string> keywords;                   // that this technique switches on
  std::vector<std::vector<std::string>> keyword_sets;  // every set validate compiles
  std::map<std::string, std::string> unlimited;        // fields to override for T3 -> value
  std::map<std::string, std::string> targets_absent;   // target -> reason

  const TechniquePass& resolve() const;  // the one pass of that kind
};

// How a light looks, whatever technique draws its shadows: an artist's choice beside the quality presets.
struct Look {
  std::string name;                       // for example crisp-noon
  std::string title;                      // for inspectors and pages
  std::string doc;                        // one sentence: what it stands for
  double angular_diameter_degrees = 0.0;  // full angle of the light's disc, above 0 to 30
  double max_penumbra_metres = 0.0;       // widest penumbra, full width, above 0 to 100
};

struct TechniqueList {
  std::filesystem::path file;
  std::vector<ParameterStruct> structs;
  std::vector<Technique> techniques;
  std::vector<Look> looks;

  const Technique& find(const std::string& name) const;  // throws InputError with the nearest name
  const ParameterStruct* find_struct(const std::string& name) const;
};

// Reads and checks the list; throws InputError with file:line:column.
TechniqueList read_technique_list(const std::filesystem::path& file);

// The checked-in copy of the parameter structs, ShaderLibrary/Core/TechniqueParameters.hlsl.
std::string emit_parameter_structs_hlsl(const TechniqueList& list);

// The expression that calls the technique's resolve function, given expressions for receiver and tile and a
// prefix for the uniforms that hold its parameters; and the declarations of those uniforms.
struct TechniqueCall {
  std::string includes;      // #include lines
  std::string declarations;  // uniforms, one per field: <prefix><Struct>_<field>
  std::string function;      // defines: float ResolveTechnique(ShadowReceiver receiver, ShadowTile tile)
};
TechniqueCall emit_technique_call(const TechniqueList& list, const Technique& technique,
                                  const std::string& uniform_prefix);

}  // namespace penumbra::shaders
