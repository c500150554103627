#include "techniques/look_emit.h"

#include <fmt/format.h>

#include "techniques/csharp_literal.h"

namespace penumbra::techniques {

namespace {

constexpr const char* kLooks = R"(using UnityEngine;

namespace Penumbra
{{
    // Written by `penumbra emit` from Shaders/PenumbraShadows.technique.json; do not edit.
    /// <summary>
    /// The appearance of the light: the size of its disc and the widest penumbra. Looks do not affect quality, and
    /// quality presets do not affect the look.
    /// </summary>
    public enum ShadowLook
    {{
{entries}        /// <summary>Other values, set by hand.</summary>
        Custom,
    }}

    internal static class LookTable
    {{
        /// <summary>In ShadowLook's order.</summary>
        internal static readonly LookValues[] Rows =
        {{
{rows}        }};
    }}
}}
)";

constexpr const char* kLookEntry = R"(        /// <summary>{doc}</summary>
        [InspectorName({title})] {name},

)";

constexpr const char* kLookRow = R"(            new LookValues({title}, {degrees}, {metres},
                           {doc}),
)";

}  // namespace

std::string emit_looks_csharp(const TechniqueList& list) {
  std::string entries, rows;
  for (const Look& look : list.looks) {
    const std::string title = csharp_text(look.title);
    entries += fmt::format(kLookEntry, fmt::arg("doc", xml_text(look.doc)), fmt::arg("title", title),
                           fmt::arg("name", csharp_name(look.name)));
    rows += fmt::format(
        kLookRow, fmt::arg("title", title), fmt::arg("degrees", csharp_float(look.angular_diameter_degrees)),
        fmt::arg("metres", csharp_float(look.max_penumbra_metres)), fmt::arg("doc", csharp_text(look.doc)));
  }
  return fmt::format(kLooks, fmt::arg("entries", entries), fmt::arg("rows", rows));
}

}  // namespace penumbra::techniques
