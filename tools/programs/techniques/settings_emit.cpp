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

// Returns null if the preset draws what it is named after.
const PresetChoice* choice_of(const TechniqueList& list, const Technique& preset) {
  for (const PresetChoice& choice : list.presets)
    if (choice.preset == preset.name) return &choice;
  return nullptr;
}

std::string technique_of(const TechniqueList& list, const Technique& preset) {
  if (const PresetChoice* choice = choice_of(list, preset)) return choice->selection;
  const std::string keyword = preset.keywords.empty() ? "" : preset.keywords.front();
  const auto found =
      std::find_if(list.selections.begin(), list.selections.end(), [&](const Selection& selection) {
        return selection.value && !selection.draws_visibility && selection.keyword == keyword;
      });
  if (found == list.selections.end() || preset.keywords.size() > 1 || preset.graph.filter() == nullptr)
    throw InputError(preset.where,
                     "the renderer feature has no technique for the keywords of '" + preset.name + "'",
                     "a preset of a selection's passes has an entry in \"presets\"");
  return found->name;
}

// Returns null if the preset needs none.
const Technique* fallback_of(const TechniqueList& list, const Technique& preset) {
  const PresetChoice* choice = choice_of(list, preset);
  return choice == nullptr ? nullptr : &list.find(choice->fallback);
}

// Returns "Preset High: Cell PCSS; else Fallback of High: PCSS 12+24".
std::string title_of(const TechniqueList& list, const Technique& preset) {
  const Technique* fallback = fallback_of(list, preset);
  return fallback == nullptr ? preset.title : preset.title + "; else " + fallback->title;
}

// Returns a value of the preset, or of its fallback.
std::string value_or(const TechniqueList& list, const Technique& preset, const char* field,
                     const std::string& otherwise) {
  const Technique* fallback = fallback_of(list, preset);
  const auto& values =
      fallback != nullptr && fallback->values.contains(field) ? fallback->values : preset.values;
  const auto found = values.find(field);
  if (found == values.end()) return otherwise;
  const double value = found->second.front();
  return otherwise.ends_with("f") ? csharp_float(value) : std::to_string(static_cast<int>(value));
}

// Returns the value of the field that the option sets; null where the preset's selection has no such option.
const double* drawn_value(const TechniqueList& list, const Technique& preset, const std::string& option) {
  const PresetChoice* choice = choice_of(list, preset);
  if (choice == nullptr) return nullptr;
  for (const Selection& selection : list.selections)
    if (selection.name == choice->selection && selection.options.contains(option))
      return &preset.values.at(selection.options.at(option)).front();
  return nullptr;
}

// Numbers that no preset chooses are those with which the first technique with the option is measured.
std::vector<std::pair<std::string, std::string>> of_other_techniques(const TechniqueList& list,
                                                                     const Technique& preset) {
  const std::vector<std::string> chosen = {"blockerSamples", "filterSamples", "softnessCapMetres",
                                           "minFilterTexels"};
  std::vector<std::pair<std::string, std::string>> values;
  for (const FeatureOption& option : list.options) {
    if (!option.range || std::find(chosen.begin(), chosen.end(), option.name) != chosen.end()) continue;
    const auto found =
        std::find_if(list.selections.begin(), list.selections.end(),
                     [&](const Selection& selection) { return selection.options.contains(option.name); });
    if (found == list.selections.end()) continue;
    const double* drawn = drawn_value(list, preset, option.name);
    const double value = drawn != nullptr
                             ? *drawn
                             : list.find(found->technique).values.at(found->options.at(option.name)).front();
    values.emplace_back(option.name,
                        option.type == "int" ? std::to_string(static_cast<int>(value)) : csharp_float(value));
  }
  return values;
}

std::string row(const TechniqueList& list, const Technique& preset) {
  const auto flag = [](bool on) { return std::string(on ? "true" : "false"); };
  std::vector<std::string> options;
  const auto set = [&](const std::string& field, const std::string& value) {
    options.push_back(field + " = " + value);
  };
  set("technique", "ShadowTechnique." + technique_of(list, preset));
  set("angularDiameterDegrees", "AngularDiameter.SunDegrees");
  set("blockerSamples", value_or(list, preset, "blockerSamples", "1"));
  set("filterSamples", value_or(list, preset, "filterSamples", "1"));
  set("softnessCapMetres", value_or(list, preset, "maxPenumbraMetres", "100.0f"));
  set("minFilterTexels", value_or(list, preset, "minFilterTexels", "1.25f"));
  for (const auto& [option, value] : of_other_techniques(list, preset)) set(option, value);
  set("mapFormat", "MapFormat.Bits32");
  const auto has_pass = [&](const char* name) {
    const auto in = [&](const Technique& technique) {
      const std::vector<GraphPass>& passes = technique.graph.passes;
      return std::any_of(passes.begin(), passes.end(),
                         [&](const GraphPass& pass) { return pass.name == name; });
    };
    const Technique* fallback = fallback_of(list, preset);
    return in(preset) || (fallback != nullptr && in(*fallback));
  };
  const bool conservative = has_pass("ConservativeMask");
  set("mask", flag(conservative || has_pass("PenumbraMask")));
  set("conservativeMask", flag(conservative));
  set("halfResolution", flag(has_pass(upsampling_pass)));
  set("denoise", flag(has_pass("DenoiseHorizontal")));
  return fmt::format(kPresetRow, fmt::arg("title", title_of(list, preset)),
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
