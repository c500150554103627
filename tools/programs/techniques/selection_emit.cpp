#include "techniques/selection_emit.h"

#include <algorithm>
#include <vector>

#include "input/input_error.h"
#include "techniques/cascade_rules.h"
#include "techniques/csharp_literal.h"

namespace penumbra::techniques {
namespace {

constexpr const char* enum_begin = R"(using System;
using UnityEngine;

namespace Penumbra
{
    // Written by `penumbra validate --emit-selections` from the manifests, *.technique.json; do not edit.
    /// <summary>
    /// The technique of the resolve pass: one entry for each shader keyword of ShaderLibrary/Shadows.hlsl that the
    /// feature offers. Inspectors, documentation and reports use these names.
    /// </summary>
    public enum ShadowTechnique
    {
)";

constexpr const char* table_begin = R"(    }

    /// <summary>Properties of each technique, indexed by ShadowTechnique.</summary>
    internal static class TechniqueTable
    {
        /// <summary>Shader keywords; null for the technique that is used without one.</summary>
        internal static readonly string[] Keywords =
        {
)";

constexpr const char* cascades_begin = R"(        };

        /// <summary>Parameters that the technique's rules change from a cascade on; empty without rules.</summary>
        internal static readonly CascadeVector[][] Cascades =
        {
)";

constexpr const char* table_end = R"(        };

        /// <summary>The technique samples the light's disc: penumbrae widen with the disc, and are noisy.</summary>
        internal static bool TakesSamples(this ShadowTechnique technique) => Sampled[(int)technique];

        /// <summary>Whether this field of ShadowOptions sets a parameter of the technique's filter.</summary>
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

}  // namespace

std::string emit_selections_csharp(const TechniqueList& list) {
  const std::string indent(12, ' ');
  std::string entries, keywords, sampled, options, cascades;
  for (const Selection* selection : offered(list)) {
    entries += (entries.empty() ? "" : "\n") + ("        /// <summary>" + selection->doc) +
               "</summary>\n        [InspectorName(" + csharp_text(selection->title) + ")]\n        " +
               selection->name + " = " + std::to_string(*selection->value) + ",\n";
    keywords += indent + (selection->keyword.empty() ? "null" : csharp_text(selection->keyword)) + ",\n";
    sampled += (sampled.empty() ? "" : ", ") + std::string(selection->is_sampled ? "true" : "false");
    options += indent + options_of(*selection) + ",\n";
    cascades += emit_cascade_row(list, list.find(selection->technique));
  }
  return enum_begin + entries + table_begin + keywords +
         "        };\n\n        private static readonly bool[] Sampled = { " + sampled +
         " };\n\n        private static readonly string[][] Options =\n        {\n" + options +
         cascades_begin + cascades + table_end;
}

}  // namespace penumbra::techniques
