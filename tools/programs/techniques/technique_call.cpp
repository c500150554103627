#include "techniques/technique_call.h"

#include <cctype>
#include <stdexcept>

#include "techniques/parameter_packing.h"

namespace penumbra::techniques {
namespace {

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

std::string argument_name(const std::string& texture) {
  std::string name = texture;
  name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  return "_Penumbra" + name + "Texture";
}

TechniqueCall emit_technique_call(const TechniqueList& list, const Technique& technique) {
  const FilterCall* filter = technique.graph.filter();
  if (filter == nullptr) throw std::invalid_argument("'" + technique.name + "' calls no filter");
  TechniqueCall call;
  call.includes = "#include \"" + filter->file + "\"\n";
  std::string arguments;
  for (const std::string& argument : filter->arguments) {
    call.declarations += argument_declaration(argument);
    arguments += argument_expression(argument) + ", ";
  }
  arguments += "receiver, tile";
  if (const ParameterStruct* parameters = list.find_struct(filter->parameters)) {
    std::string vectors;
    for (std::size_t i = 0; i < vector_count(*parameters); ++i) {
      call.declarations += "float4 " + uniform_name(*parameters, i) + ";\n";
      vectors += (i == 0 ? "" : ", ") + uniform_name(*parameters, i);
    }
    arguments += ", Unpack" + parameters->name + "(" + vectors + ")";
  }
  call.function = "float ResolveTechnique(ShadowReceiver receiver, ShadowTile tile)\n{\n    return " +
                  filter->function + "(" + arguments + ");\n}\n";
  return call;
}

}  // namespace penumbra::techniques
