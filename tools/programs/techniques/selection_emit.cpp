#include "techniques/selection_emit.h"

#include <algorithm>
#include <vector>

#include "input/input_error.h"
#include "techniques/cascade_rules.h"
#include "techniques/csharp_literal.h"
#include "techniques/graph_emit.h"
#include "techniques/parameter_emit.h"

namespace penumbra::techniques {
namespace {

constexpr const char* enum_begin = R"(using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    // Written by `penumbra emit` from the manifests, *.technique.json; do not edit.
    /// <summary>
    /// The technique that computes the visibility: one entry for each shader keyword of ShaderLibrary/Shadows.hlsl that
    /// the feature offers, and for each that passes of its own draw. Inspectors, documentation and reports use these
    /// names.
    /// </summary>
    public enum ShadowTechnique
    {
)";

constexpr const char* table_begin = R"(    }

    /// <summary>Sets the parameters of a technique's passes and filter. Does not allocate.</summary>
    internal delegate void SetParameters(CommandBuffer commands, in ShadowOptions options);

    /// <summary>Sets some of the options.</summary>
    internal delegate void SetOptions(ref ShadowOptions options);

    /// <summary>Properties of each technique, indexed by ShadowTechnique.</summary>
    internal static class TechniqueTable
    {
        /// <summary>
        /// Shader keywords; null for the technique that is used without one. Passes that draw the visibility have their
        /// fallback's.
        /// </summary>
        internal static readonly string[] Keywords =
        {
)";

constexpr const char* cascades_begin = R"(        };

        /// <summary>Parameters that the technique's rules change from a cascade on; empty without rules.</summary>
        internal static readonly CascadeVector[][] Cascades =
        {
)";

constexpr const char* graphs_begin = R"(        };

        /// <summary>
        /// The passes before the filter, which make the maps that it reads, or those that draw the visibility without
        /// one; empty for a filter of the shadow map alone.
        /// Of two the second makes maps of 16 bits: index with ShadowOptions.GraphIndex.
        /// </summary>
        internal static readonly TechniqueGraph[][] Graphs =
        {
)";

constexpr const char* half_graphs_begin = R"(        };

        /// <summary>Passes that draw the visibility at half resolution, in place of those of Graphs; null: none.</summary>
        internal static readonly TechniqueGraph[] HalfGraphs =
        {
)";

constexpr const char* parameters_begin = R"(        };

        /// <summary>
        /// As Graphs, but one for a filter of the shadow map alone; empty where there are no parameters, or
        /// ShadowUniforms computes them.
        /// </summary>
        internal static readonly SetParameters[][] Parameters =
        {
)";

constexpr const char* measured_begin = R"(        };

        private static readonly SetOptions[] Measured =
        {
)";

constexpr const char* fallbacks_begin = R"(        };

        /// <summary>What is drawn where the technique cannot run; itself if it runs everywhere.</summary>
        internal static readonly ShadowTechnique[] Fallbacks =
        {
)";

constexpr const char* table_end = R"(        };

        /// <summary>The technique samples the light's disc, so that its penumbrae are noisy.</summary>
        internal static bool TakesSamples(this ShadowTechnique technique) => Sampled[(int)technique];

        /// <summary>Penumbrae are as wide as the light's disc makes them.</summary>
        internal static bool WidensWithDisc(this ShadowTechnique technique) => Widens[(int)technique];

        /// <summary>The filter gathers texels or searches for bits, which needs shader target 4.5.</summary>
        internal static bool NeedsTarget45(this ShadowTechnique technique) => Target45[(int)technique];

        /// <summary>The filter itself limits how wide penumbrae are, in metres.</summary>
        internal static bool LimitsWidth(this ShadowTechnique technique) => Limiting[(int)technique];

        /// <summary>The filter biases receivers itself: the light's own biases should be 0.</summary>
        internal static bool HasOwnBias(this ShadowTechnique technique) => Biased[(int)technique];

        /// <summary>Gives the technique's own options the values that it is measured with.</summary>
        internal static void SetMeasured(this ShadowTechnique technique, ref ShadowOptions options) =>
            Measured[(int)technique](ref options);

        /// <summary>Whether this field of ShadowOptions sets a parameter of the technique's passes or filter.</summary>
        internal static bool Takes(this ShadowTechnique technique, string option) =>
            Array.IndexOf(Options[(int)technique], option) >= 0;
    }
}
)";

std::vector<const Selection*> offered(const TechniqueList& list) {
  std::vector<const Selection*> selections;
  for (const Selection& selection : list.selections)
    if (selection.value) selections.push_back(&selection);
  std::sort(selections.begin(), selections.end(),
            [](const Selection* a, const Selection* b) { return *a->value < *b->value; });
  for (std::size_t i = 0; i < selections.size(); ++i)
    if (*selections[i]->value != static_cast<int>(i))
      throw InputError(selections[i]->where, "no selection has the value " + std::to_string(i),
                       "values are 0, 1, 2 and so on, each once");
  return selections;
}

std::string options_of(const Selection& selection) {
  if (selection.options.empty()) return "new string[0]";
  const std::string indent(12, ' ');
  std::string text = "new[]\n" + indent + "{\n";
  for (const auto& [option, field] : selection.options)
    text += indent + "    nameof(ShadowOptions." + option + "),\n";
  return text + indent + "}";
}

// The techniques of a selection, by the formats of their maps.
std::vector<const Technique*> techniques_of(const TechniqueList& list, const Selection& selection) {
  std::vector<const Technique*> techniques{&list.find(selection.technique)};
  if (!selection.technique_16_bits.empty()) techniques.push_back(&list.find(selection.technique_16_bits));
  return techniques;
}

std::string graphs_of(const TechniqueList& list, const Selection& selection) {
  std::string names;
  for (const Technique* technique : techniques_of(list, selection))
    if (!technique->graph_name.empty()) names += (names.empty() ? "" : ", ") + csharp_graph_of(*technique);
  return names.empty() ? "new TechniqueGraph[0]" : "new[] { " + names + " }";
}

std::string half_graph_of(const TechniqueList& list, const Selection& selection) {
  const std::string& name = selection.technique_half_resolution;
  return name.empty() ? "null" : csharp_graph_of(list.find(name));
}

std::string option_that_sets(const Selection& selection, const std::string& field) {
  for (const auto& [option, set] : selection.options)
    if (set == field) return option;
  return {};
}

// A struct of the technique's with the values that it is measured with, and the options in the place of some.
std::string set_struct(const ParameterStruct& parameters, const Technique& technique,
                       const Selection& selection) {
  const std::string indent(20, ' ');
  std::string text = indent + "new " + parameters.name + "\n" + indent + "{\n";
  for (const ParameterField& field : parameters.fields) {
    const std::string option = option_that_sets(selection, field.name);
    text += indent + "    " + field.name + " = " +
            (option.empty() ? csharp_value(field, technique.values.at(field.name)) : "options." + option) +
            ",\n";
  }
  return text + indent + "}.SetGlobal(commands);\n";
}

bool is_computed(const Selection& selection, const std::string& parameters) {
  return std::find(selection.computed_parameters.begin(), selection.computed_parameters.end(), parameters) !=
         selection.computed_parameters.end();
}

std::string parameters_of(const TechniqueList& list, const Selection& selection) {
  std::string setters;
  const std::string indent(16, ' ');
  for (const Technique* technique : techniques_of(list, selection)) {
    std::string structs;
    for (const ParameterStruct* parameters : list.structs_of(*technique))
      if (!is_computed(selection, parameters->name))
        structs += set_struct(*parameters, *technique, selection);
    if (!structs.empty())
      setters += indent + "(CommandBuffer commands, in ShadowOptions options) =>\n" + indent + "{\n" +
                 structs + indent + "},\n";
  }
  if (setters.empty()) return "new SetParameters[0]";
  return "new SetParameters[]\n            {\n" + setters + "            }";
}

std::string measured_of(const TechniqueList& list, const Selection& selection) {
  const Technique& technique = list.find(selection.technique);
  const std::vector<ParameterField> fields = list.fields_of(technique);
  const std::string indent(12, ' ');
  std::string settings;
  for (const auto& [option, set] : selection.options)
    for (const ParameterField& field : fields)
      if (field.name == set)
        settings +=
            indent + "    options." + option + " = " + csharp_value(field, technique.values.at(set)) + ";\n";
  if (settings.empty()) return "(ref ShadowOptions options) => { }";
  return "(ref ShadowOptions options) =>\n" + indent + "{\n" + settings + indent + "}";
}

// By the parameters of the filter, or of the passes that draw the visibility.
bool limits_width(const TechniqueList& list, const Selection& selection) {
  const ParameterStruct* parameters = list.find_struct(selection.filter.parameters);
  std::vector<ParameterField> fields;
  if (selection.draws_visibility)
    fields = list.fields_of(list.find(selection.technique));
  else if (parameters != nullptr)
    fields = parameters->fields;
  return std::any_of(fields.begin(), fields.end(),
                     [](const ParameterField& field) { return field.name == "maxPenumbraMetres"; });
}

bool has_own_bias(const TechniqueList& list, const Selection& selection) {
  const TechniqueBias& bias = list.find(selection.technique).bias;
  return bias.depth == 0.0 && bias.normal == 0.0;
}

// A rule's vectors are copies of those that ShadowUniforms computes.
void require_fitting_rules(const TechniqueList& list, const Selection& selection) {
  for (const CascadeRule& rule : list.find(selection.technique).cascades)
    if (rule.technique.empty() && selection.computed_parameters.empty() && !selection.options.empty())
      throw InputError(
          selection.where,
          "'" + selection.name + "' has options, and rules for cascades that change its own parameters",
          "sliders would not reach far cascades: let ShadowUniforms compute the parameters, and say "
          "\"computed_parameters\": [the struct's name]");
}

std::string fallback_of(const std::vector<const Selection*>& selections, const Selection& selection) {
  const std::string& name = !selection.fallback.empty() ? selection.fallback : selection.name;
  for (const Selection* other : selections)
    if (other->name == name) return "ShadowTechnique." + name;
  throw InputError(selection.where, "the renderer feature does not offer '" + name +
                                        "', which is drawn where '" + selection.name + "' cannot run");
}

std::string table(const std::string& values) {
  return "        };\n\n" + values;
}

// Ten in a line.
std::string flags(const char* name, const std::vector<bool>& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool ends = i % 10 == 9 || i + 1 == values.size();
    text +=
        (i % 10 == 0 ? std::string(12, ' ') : " ") + (values[i] ? "true," : "false,") + (ends ? "\n" : "");
  }
  return "        private static readonly bool[] " + std::string(name) + " =\n        {\n" + text;
}

}  // namespace

std::string emit_selections_csharp(const TechniqueList& list) {
  const std::string indent(12, ' ');
  std::string entries, keywords, options, cascades, graphs, half_graphs, parameters, measured, fallbacks;
  std::vector<bool> sampled, widens, target_45, limiting, biased;
  const std::vector<const Selection*> selections = offered(list);
  for (const Selection* selection : selections) {
    require_fitting_rules(list, *selection);
    entries += (entries.empty() ? "" : "\n") + ("        /// <summary>" + selection->doc) +
               "</summary>\n        [InspectorName(" + csharp_text(selection->title) + ")]\n        " +
               selection->name + " = " + std::to_string(*selection->value) + ",\n";
    keywords += indent + (selection->keyword.empty() ? "null" : csharp_text(selection->keyword)) + ",\n";
    options += indent + options_of(*selection) + ",\n";
    cascades += emit_cascade_row(list, list.find(selection->technique));
    graphs += indent + graphs_of(list, *selection) + ",\n";
    half_graphs += indent + half_graph_of(list, *selection) + ",\n";
    parameters += indent + parameters_of(list, *selection) + ",\n";
    measured += indent + measured_of(list, *selection) + ",\n";
    fallbacks += indent + fallback_of(selections, *selection) + ",\n";
    sampled.push_back(selection->is_sampled);
    widens.push_back(selection->widens_with_disc);
    target_45.push_back(selection->needs_target_45);
    limiting.push_back(limits_width(list, *selection));
    biased.push_back(has_own_bias(list, *selection));
  }
  return enum_begin + entries + table_begin + keywords + table(flags("Sampled", sampled)) +
         table(flags("Widens", widens)) + table(flags("Target45", target_45)) +
         table(flags("Limiting", limiting)) + table(flags("Biased", biased)) +
         table("        private static readonly string[][] Options =\n        {\n" + options) +
         cascades_begin + cascades + graphs_begin + graphs + half_graphs_begin + half_graphs +
         parameters_begin + parameters + measured_begin + measured + fallbacks_begin + fallbacks + table_end;
}

}  // namespace penumbra::techniques
