#include "techniques/technique_values.h"

#include <cmath>
#include <limits>
#include <sstream>

#include "input/input_error.h"
#include "input/nearest_name.h"

namespace penumbra::techniques {
namespace {

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
    if (technique.values.at(parameter).size() != 1) {
      throw InputError("", "'" + parameter + "' of technique '" + technique.name + "' is a " + field.type +
                               ", and only single numbers can be set");
    }
    const std::string problem = value_problem(field, value);
    if (!problem.empty()) throw InputError("", "technique '" + technique.name + "': " + problem);
    technique.values[parameter] = {value};
    return technique;
  }
  throw InputError("", "technique '" + technique.name + "' has no parameter '" + parameter + "'",
                   known_parameters(parameter, fields));
}

}  // namespace penumbra::techniques
