#include "techniques/technique_call.h"

#include <stdexcept>

namespace penumbra::techniques {

namespace {

constexpr const char* structs_header =
    R"(// Parameter structs of the techniques, one per family of filters.
// Written by `penumbra validate --emit-parameters` from the techniques' manifests; do not edit.
//
// Each comment gives the field's unit, then its meaning. Cost: no fetch.
#ifndef PENUMBRA_TECHNIQUE_PARAMETERS_HLSL
#define PENUMBRA_TECHNIQUE_PARAMETERS_HLSL
)";

std::string emit_struct(const ParameterStruct& parameters) {
  std::string text = "\n// " + parameters.doc + "\nstruct " + parameters.name + "\n{\n";
  for (const ParameterField& field : parameters.fields)
    text += "    " + field.type + " " + field.name + "; // " + field.unit + ": " + field.doc + "\n";
  return text + "};\n";
}

std::string uniform(const std::string& prefix, const ParameterStruct& parameters,
                    const ParameterField& field) {
  return prefix + parameters.name + "_" + field.name;
}

// A texture of the graph by its name in the call.
std::string argument_name(const std::string& texture) {
  return "_Penumbra_" + texture;
}

std::string argument_declaration(const std::string& argument) {
  if (argument == "shadowMap") return "TEXTURE2D_SHADOW(_ShadowMap);\nSAMPLER_CMP(sampler_ShadowMap);\n";
  if (argument == "pointSampler") return "SAMPLER(sampler_PointClamp);\n";
  if (argument == "linearSampler") return "SAMPLER(sampler_LinearClamp);\n";
  return "TEXTURE2D(" + argument_name(argument) + ");\n";
}

std::string argument_expression(const std::string& argument) {
  if (argument == "shadowMap") return "TEXTURE2D_SHADOW_ARGS(_ShadowMap, sampler_ShadowMap)";
  if (argument == "pointSampler") return "sampler_PointClamp";
  if (argument == "linearSampler") return "sampler_LinearClamp";
  return argument_name(argument);
}

}  // namespace

std::string emit_parameter_structs_hlsl(const TechniqueList& list) {
  std::string text = structs_header;
  for (const ParameterStruct& parameters : list.structs) text += emit_struct(parameters);
  return text + "\n#endif\n";
}

TechniqueCall emit_technique_call(const TechniqueList& list, const Technique& technique,
                                  const std::string& uniform_prefix) {
  const FilterCall* filter = technique.graph.filter();
  if (filter == nullptr) throw std::invalid_argument("'" + technique.name + "' calls no filter");
  const ParameterStruct* parameters = list.find_struct(filter->parameters);
  TechniqueCall call;
  call.includes = "#include \"" + filter->file + "\"\n";
  std::string arguments;
  for (const std::string& argument : filter->arguments) {
    call.declarations += argument_declaration(argument);
    arguments += argument_expression(argument) + ", ";
  }
  arguments += "receiver, tile";
  call.function = "float ResolveTechnique(ShadowReceiver receiver, ShadowTile tile)\n{\n";
  if (parameters != nullptr) {
    call.function += "    " + parameters->name + " parameters;\n";
    for (const ParameterField& field : parameters->fields) {
      const std::string name = uniform(uniform_prefix, *parameters, field);
      call.declarations += field.type + " " + name + ";\n";
      call.function += "    parameters." + field.name + " = " + name + ";\n";
    }
    arguments += ", parameters";
  }
  call.function += "    return " + filter->function + "(" + arguments + ");\n}\n";
  return call;
}

}  // namespace penumbra::techniques
