#include "techniques/option_emit.h"

#include <cctype>

#include "techniques/csharp_literal.h"

namespace penumbra::techniques {
namespace {

constexpr const char* begin = R"(namespace Penumbra
{
    // Written by `penumbra emit` from Shaders/PenumbraShadows.technique.json; do not edit.
    /// <summary>Labels, tooltips and ranges of the options, for the inspectors of the feature and of the Volume.</summary>
    internal static class OptionTable
    {
)";

constexpr const char* end = R"(    }
}
)";

constexpr std::size_t widest = 96;  // characters of a text in one line

// On lines of their own, broken between words.
std::string wrapped(const std::string& text) {
  const std::string indent(16, ' ');
  std::string lines;
  std::size_t at = 0;
  while (text.size() - at > widest) {
    const std::size_t space = text.rfind(' ', at + widest);
    if (space == std::string::npos || space <= at) break;
    lines += "\n" + indent + csharp_text(text.substr(at, space + 1 - at)) + " +";
    at = space + 1;
  }
  return lines + "\n" + indent + csharp_text(text.substr(at));
}

std::string class_of(const FeatureOption& option) {
  std::string name = option.name;
  name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  const std::string indent(12, ' ');
  std::string text = "        internal static class " + name + "\n        {\n" + indent +
                     "internal const string Label = " + csharp_text(option.label) + ";\n" + indent +
                     "internal const string Tooltip =" + wrapped(option.tooltip) + ";\n";
  const auto constant = [&](const char* of, double value) {
    const bool whole = option.type == "int";
    text += indent + "internal const " + option.type + " " + of + " = " +
            (whole ? std::to_string(static_cast<int>(value)) : csharp_float(value)) + ";\n";
  };
  if (option.range) {
    constant("Min", option.range->smallest);
    constant("Max", option.range->largest);
  }
  return text + "        }\n";
}

}  // namespace

std::string emit_options_csharp(const TechniqueList& list) {
  std::string text;
  for (const FeatureOption& option : list.options) text += (text.empty() ? "" : "\n") + class_of(option);
  return begin + text + end;
}

}  // namespace penumbra::techniques
