#include "techniques/settings_emit.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "input/input_error.h"
#include "techniques/emitted_text.h"

namespace penumbra::techniques {

namespace {

constexpr const char* kOptionTable = R"(using System;

namespace Penumbra
{{
    // Written by `penumbra emit` from Shaders/PenumbraShadows.technique.json; do not edit.
    /// <summary>The options that are numbers, by the names of their fields.</summary>
    internal enum NumberOption
    {{
        {names}
    }}

    /// <summary>Labels, tooltips and ranges of the options, for the inspectors of the feature and of the Volume.</summary>
    internal static class OptionTable
    {{
        internal static float Get(in ShadowOptions options, NumberOption option)
        {{
            switch (option)
            {{
{gets}                default: throw new ArgumentOutOfRangeException(nameof(option));
            }}
        }}

        internal static void Set(ref ShadowOptions options, NumberOption option, float value)
        {{
            switch (option)
            {{
{sets}                default: throw new ArgumentOutOfRangeException(nameof(option));
            }}
        }}

{texts}    }}
}}
)";

constexpr const char* kOptionGet = R"(                case NumberOption.{name}: return options.{name};
)";

constexpr const char* kOptionSet =
    R"(                case NumberOption.{name}: options.{name} = {value}; break;
)";

constexpr const char* kOptionTexts = R"(        internal static class {name}
        {{
            internal const string Label = {label}, Tooltip =
                {tooltip};
{range}        }}
)";

constexpr const char* kOptionRange = R"(            internal const {type} Min = {low}, Max = {high};
)";

constexpr std::size_t kWidestText = 98;  // characters of a text in one line

// The text is broken between words.
std::string wrapped(const std::string& text) {
  std::string lines;
  std::size_t at = 0;
  while (text.size() - at > kWidestText) {
    const std::size_t space = text.rfind(' ', at + kWidestText);
    if (space == std::string::npos || space <= at) break;
    lines += csharp_text(text.substr(at, space + 1 - at)) + " +\n" + std::string(16, ' ');
    at = space + 1;
  }
  return lines + csharp_text(text.substr(at));
}

std::string number(const FeatureOption& option, double value) {
  return option.type == "int" ? std::to_string(static_cast<int>(value)) : csharp_float(value);
}

std::string texts(const FeatureOption& option) {
  std::string name = option.name;
  name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  const std::string range = option.range
                                ? fmt::format(kOptionRange, fmt::arg("type", option.type),
                                              fmt::arg("low", number(option, option.range->smallest)),
                                              fmt::arg("high", number(option, option.range->largest)))
                                : "";
  return fmt::format(kOptionTexts, fmt::arg("name", name), fmt::arg("label", csharp_text(option.label)),
                     fmt::arg("tooltip", wrapped(option.tooltip)), fmt::arg("range", range));
}

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

constexpr const char* kPresetTable = R"(namespace Penumbra
{{
    // Written by `penumbra emit` from the technique list; do not edit.
    /// <summary>The options of the quality presets, in QualityPreset's order.</summary>
    internal static class PresetTable
    {{
        internal static readonly ShadowOptions[] Rows =
        {{
{}        }};
    }}
}}
)";

constexpr const char* kPresetRow = R"(            // {title}
            new ShadowOptions
            {{
                {options}
            }},
)";

const PresetChoice& choice_of(const TechniqueList& list, const Technique& preset) {
  for (const PresetChoice& choice : list.presets)
    if (choice.preset == preset.name) return choice;
  throw InputError(preset.where, "the preset '" + preset.name + "' has no fallback",
                   "give it an entry in \"presets\", with what is drawn where its passes cannot run");
}

// Returns the values of the options that are numbers. Those that the preset's selection lacks are those with
// which the first selection with the option is measured.
std::vector<std::pair<std::string, std::string>> numbers_of(const TechniqueList& list,
                                                            const Technique& preset) {
  const std::string& own = choice_of(list, preset).selection;
  std::vector<std::pair<std::string, std::string>> values;
  for (const FeatureOption& option : list.options) {
    const Selection* with_option = nullptr;
    for (const Selection& selection : list.selections)
      if (selection.options.contains(option.name) && (with_option == nullptr || selection.name == own))
        with_option = &selection;
    if (!option.range || with_option == nullptr) continue;
    const Technique& measured = with_option->name == own ? preset : list.find(with_option->technique);
    values.emplace_back(option.name,
                        number(option, measured.values.at(with_option->options.at(option.name)).front()));
  }
  return values;
}

std::string row(const TechniqueList& list, const Technique& preset) {
  const auto flag = [](bool on) { return std::string(on ? "true" : "false"); };
  std::vector<std::string> options;
  const auto set = [&](const std::string& field, const std::string& value) {
    options.push_back(field + " = " + value);
  };
  set("technique", "ShadowTechnique." + choice_of(list, preset).selection);
  set("angularDiameterDegrees", "AngularDiameter.SunDegrees");
  for (const auto& [option, value] : numbers_of(list, preset)) set(option, value);
  set("mapFormat", "MapFormat.Bits32");
  const Technique& fallback = list.find(choice_of(list, preset).fallback);
  const auto has_pass = [&](const char* name) {
    const auto in = [&](const Technique& technique) {
      const std::vector<GraphPass>& passes = technique.graph.passes;
      return std::any_of(passes.begin(), passes.end(),
                         [&](const GraphPass& pass) { return pass.name == name; });
    };
    return in(preset) || in(fallback);
  };
  const bool conservative = has_pass("ConservativeMask");
  set("mask", flag(conservative || has_pass("PenumbraMask")));
  set("conservativeMask", flag(conservative));
  set("halfResolution", flag(has_pass(upsampling_pass)));
  set("denoise", flag(has_pass("DenoiseHorizontal")));
  return fmt::format(kPresetRow, fmt::arg("title", preset.title),
                     fmt::arg("options", csharp_list(options, 16)));
}

}  // namespace

std::string emit_options_csharp(const TechniqueList& list) {
  std::vector<std::string> names;
  std::string gets, sets, all;
  for (const FeatureOption& option : list.options) {
    all += texts(option);
    if (!option.range) continue;
    names.push_back(option.name);
    gets += fmt::format(kOptionGet, fmt::arg("name", option.name));
    sets += fmt::format(kOptionSet, fmt::arg("name", option.name),
                        fmt::arg("value", option.type == "int" ? "(int)value" : "value"));
  }
  return fmt::format(kOptionTable, fmt::arg("names", csharp_list(names, 8)), fmt::arg("gets", gets),
                     fmt::arg("sets", sets), fmt::arg("texts", all));
}

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

std::string emit_presets_csharp(const TechniqueList& list) {
  std::string rows;
  for (const Technique& technique : list.techniques)
    if (technique.name.starts_with(preset_prefix)) rows += row(list, technique);
  return fmt::format(kPresetTable, rows);
}

}  // namespace penumbra::techniques
