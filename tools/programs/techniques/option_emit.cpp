#include "techniques/option_emit.h"

#include <fmt/format.h>

#include <cctype>
#include <vector>

#include "techniques/csharp_literal.h"

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

}  // namespace penumbra::techniques
