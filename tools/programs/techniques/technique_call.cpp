#include "techniques/technique_call.h"

#include <cctype>
#include <functional>
#include <set>
#include <stdexcept>

#include "techniques/parameter_packing.h"

namespace penumbra::techniques {
namespace {

// What a fetch of an integer texture gives: "uint4" of rgba32ui. Empty of others.
std::string integer_texel(const GraphTexture& texture) {
  if (!texture.format.ends_with("ui")) return {};
  const std::size_t channels = texture.format.find_first_of("0123456789");
  return channels == 1 ? "uint" : "uint" + std::to_string(channels);
}

std::string argument_declaration(const std::string& argument, const PassGraph& graph) {
  if (argument == "shadowMap") return "TEXTURE2D_SHADOW(_ShadowMap);\nSAMPLER_CMP(sampler_ShadowMap);\n";
  if (argument == "pointSampler") return "SAMPLER(sampler_PointClamp);\n";
  if (argument == "linearSampler") return "SAMPLER(sampler_LinearClamp);\n";
  if (argument == spot_light_name) return "float4 _PenumbraSpotLight;\n";
  const GraphTexture* texture = graph.texture(argument);
  return texture == nullptr ? "TEXTURE2D(" + argument_name(argument) + ");\n" : declaration_of(*texture);
}

std::string argument_expression(const std::string& argument) {
  if (argument == "shadowMap") return "TEXTURE2D_SHADOW_ARGS(_ShadowMap, sampler_ShadowMap)";
  if (argument == "pointSampler") return "sampler_PointClamp";
  if (argument == "linearSampler") return "sampler_LinearClamp";
  if (argument == spot_light_name) return "BoundedSpotMap(_PenumbraSpotLight)";
  return argument_name(argument);
}

using UniformName = std::function<std::string(const ParameterStruct&, std::size_t)>;

// Declares what is not declared yet, and gives the call.
class CallWriter {
 public:
  CallWriter(const TechniqueList& list, const PassGraph& graph, TechniqueCall& call)
      : list_(list), graph_(graph), call_(call) {}

  std::string expression(const FilterCall& filter, const UniformName& name) {
    if (included_.insert(filter.file).second) call_.includes += "#include \"" + filter.file + "\"\n";
    std::string arguments;
    for (const std::string& argument : filter.arguments) {
      if (declared_.insert(argument).second) call_.declarations += argument_declaration(argument, graph_);
      arguments += argument_expression(argument) + ", ";
    }
    std::string receiver = "receiver, tile";
    if (const ParameterStruct* parameters = list_.find_struct(filter.parameters)) {
      std::string vectors;
      for (std::size_t i = 0; i < vector_count(*parameters); ++i) {
        call_.declarations += "float4 " + name(*parameters, i) + ";\n";
        vectors += (i == 0 ? "" : ", ") + name(*parameters, i);
      }
      receiver += ", Unpack" + parameters->name + "(" + vectors + ")";
    }
    return filter.function + "(" + arguments + receiver + ")";
  }

 private:
  const TechniqueList& list_;
  const PassGraph& graph_;
  TechniqueCall& call_;
  std::set<std::string> included_;
  std::set<std::string> declared_;  // arguments
};

}  // namespace

std::string TechniqueCall::source() const {
  return "#include \"Platform/Platform.hlsl\"\n" + includes + "#include \"Core/ShadowStructs.hlsl\"\n" +
         declarations + function;
}

std::string uniform_name(const ParameterStruct& parameters, std::size_t vector, const CascadeRule& rule) {
  return uniform_name(parameters, vector) + "From" + std::to_string(rule.from);
}

std::string argument_name(const std::string& texture) {
  std::string name = texture;
  name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  return "_Penumbra" + name + "Texture";
}

std::string declaration_of(const GraphTexture& texture) {
  const std::string texel = integer_texel(texture);
  const std::string name = argument_name(texture.name);
  return texel.empty() ? "TEXTURE2D(" + name + ");\n" : "TYPED_TEXTURE2D(" + texel + ", " + name + ");\n";
}

TechniqueCall emit_technique_call(const TechniqueList& list, const Technique& technique) {
  const FilterCall* filter = technique.graph.filter();
  if (filter == nullptr) throw std::invalid_argument("'" + technique.name + "' calls no filter");
  TechniqueCall call;
  CallWriter writer(list, technique.graph, call);
  const std::string first = writer.expression(
      *filter, [](const ParameterStruct& parameters, std::size_t i) { return uniform_name(parameters, i); });
  std::string branches;
  for (const CascadeRule& rule : technique.cascades) {
    const auto name = [&](const ParameterStruct& parameters, std::size_t i) {
      return uniform_name(parameters, i, rule);
    };
    const std::string value = writer.expression(rule.filter, name);
    branches.insert(0, "    if (cascade >= " + std::to_string(rule.from) + ") return " + value + ";\n");
  }
  call.function = "float ResolveTechnique(ShadowReceiver receiver, ShadowTile tile, int cascade)\n{\n" +
                  branches + "    return " + first + ";\n}\n";
  return call;
}

}  // namespace penumbra::techniques
