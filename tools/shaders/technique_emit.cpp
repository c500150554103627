#include "shaders/technique_list.h"

namespace penumbra::shaders {

namespace {

constexpr const char* structs_header =
    R"(// Parameter structs of the techniques, one per family of filters.
// Written by `penumbra validate --emit-parameters` from ShaderLibrary/techniques.json; do not edit.
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

std::string resource_declaration(const std::string& resource) {
  if (resource == "shadowMap") return "TEXTURE2D_SHADOW(_ShadowMap);\nSAMPLER_CMP(sampler_ShadowMap);\n";
  return "SAMPLER(sampler_PointClamp);\n";
}

std::string resource_argument(const std::string& resource) {
  return resource == "shadowMap" ? "TEXTURE2D_SHADOW_ARGS(_ShadowMap, sampler_ShadowMap)"
                                 : "sampler_PointClamp";
}

}  // namespace

std::string emit_parameter_structs_hlsl(const TechniqueList& list) {
  std::string text = structs_header;
  for (const ParameterStruct& parameters : list.structs) text += emit_struct(parameters);
  return text + "\n#endif\n";
}

TechniqueCall emit_technique_call(const TechniqueList& list, const Technique& technique,
                                  const std::string& uniform_prefix) {
  const TechniquePass& pass = technique.resolve();
  const ParameterStruct* parameters = list.find_struct(pass.parameters);
  TechniqueCall call;
  call.includes = "#include \"" + pass.file + "\"\n";
  std::string arguments;
  for (const std::string& resource : pass.resources) {
    call.declarations += resource_declaration(resource);
    arguments += resource_argument(resource) + ", ";
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
  call.function += "    return " + pass.function + "(" + arguments + ");\n}\n";
  return call;
}

}  // namespace penumbra::shaders
