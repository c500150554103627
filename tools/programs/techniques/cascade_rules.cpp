#include "techniques/cascade_rules.h"

#include <algorithm>

#include "techniques/parameter_packing.h"
#include "techniques/technique_call.h"

namespace penumbra::techniques {
namespace {

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
