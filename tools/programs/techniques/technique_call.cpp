#include "techniques/technique_call.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <set>
#include <stdexcept>

#include "techniques/parameter_packing.h"

namespace penumbra::techniques {

namespace {

// Returns the type of a fetch of an integer texture: "uint4" for rgba32ui. It is empty for other formats.
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

// Declares the resources that are not declared yet, and writes the call.
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
  std::set<std::string> declared_;  // the declared arguments
};

void add_vectors(const ParameterStruct& parameters, const CascadeRule& rule, const Technique& technique,
                 std::vector<CascadeVector>& vectors) {
  const std::size_t first = vectors.size();
  const std::vector<std::array<float, 4>> values = packed(parameters, values_of(rule, technique));
  for (std::size_t i = 0; i < values.size(); ++i) {
    CascadeVector vector{uniform_name(parameters, i, rule), "", {true, true, true, true}, values[i]};
    if (rule.technique.empty()) {
      vector.base = uniform_name(parameters, i);
      vector.own = {};
    }
    vectors.push_back(vector);
  }
  const std::vector<PackedPlace> places = packed_places(parameters);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const ParameterField& field = parameters.fields[i];
    if (rule.values.find(field.name) == rule.values.end()) continue;
    for (std::size_t k = 0; k < component_count(field); ++k)
      vectors[first + places[i].vector].own[places[i].component + k] = true;
  }
}

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
  return texel.empty() ? "TEXTURE2D(" + name + ");\n" : "Texture2D<" + texel + "> " + name + ";\n";
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

std::map<std::string, std::vector<double>> values_of(const CascadeRule& rule, const Technique& technique) {
  std::map<std::string, std::vector<double>> values = rule.values;
  if (rule.technique.empty()) values.insert(technique.values.begin(), technique.values.end());
  return values;
}

std::vector<CascadeVector> cascade_vectors(const TechniqueList& list, const Technique& technique) {
  std::vector<CascadeVector> vectors;
  for (const CascadeRule& rule : technique.cascades)
    if (const ParameterStruct* parameters = list.find_struct(rule.filter.parameters))
      add_vectors(*parameters, rule, technique, vectors);
  return vectors;
}

const std::vector<CascadeRule>& compiled_rules(const TechniqueList& list, const Technique& technique) {
  if (technique.graph.filter_pass() != nullptr || technique.graph.filter() == nullptr)
    return technique.cascades;
  const auto found =
      std::find_if(list.selections.begin(), list.selections.end(), [&](const Selection& selection) {
        return !selection.keyword.empty() &&
               std::count(technique.keywords.begin(), technique.keywords.end(), selection.keyword) > 0;
      });
  return found == list.selections.end() ? technique.cascades : list.find(found->technique).cascades;
}

}  // namespace penumbra::techniques
