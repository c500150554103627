#include "techniques/look_emit.h"

#include "techniques/csharp_literal.h"

namespace penumbra::techniques {

namespace {

constexpr const char* looks_begin =
    R"(using UnityEngine;

namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraShadows.technique.json; do not edit.
    /// <summary>
    /// The appearance of the light: the size of its disc and the widest penumbra. Looks do not affect quality, and
    /// quality presets do not affect the look.
    /// </summary>
    public enum ShadowLook
    {
)";

constexpr const char* custom = R"(        /// <summary>Other values, set by hand.</summary>
        Custom,
    }

)";

constexpr const char* look_table_begin = R"(    internal static class LookTable
    {
        /// <summary>In ShadowLook's order.</summary>
        internal static readonly LookValues[] Rows =
        {
)";

constexpr const char* look_table_end = R"(        };
    }
}
)";

std::string enum_value(const Look& look) {
  return "        /// <summary>" + look.doc + "</summary>\n        [InspectorName(" +
         csharp_text(look.title) + ")]\n        " + csharp_name(look.name) + ",\n\n";
}

std::string row(const Look& look) {
  return "            new LookValues(" + csharp_text(look.title) + ", " +
         csharp_float(look.angular_diameter_degrees) + ", " + csharp_float(look.max_penumbra_metres) +
         ",\n                           " + csharp_text(look.doc) + "),\n";
}

}  // namespace

std::string emit_looks_csharp(const TechniqueList& list) {
  std::string text = looks_begin;
  for (const Look& look : list.looks) text += enum_value(look);
  text.append(custom).append(look_table_begin);
  for (const Look& look : list.looks) text += row(look);
  return text + look_table_end;
}

}  // namespace penumbra::techniques
