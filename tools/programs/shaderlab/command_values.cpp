#include "shaderlab/command_values.h"

#include <charconv>
#include <optional>

#include "shaderlab/characters.h"
#include "shaderlab/cursor.h"

namespace penumbra::shaderlab {

namespace {

using Words = std::vector<std::string>;

const Words& words_of(Values values) {
  static const Words none;
  static const Words toggle{"On", "Off", "True", "False"};
  static const Words cull{"Back", "Front", "Off", "False"};
  static const Words comparison{"Never",  "Less",   "Equal", "LEqual", "Greater", "NotEqual",
                                "GEqual", "Always", "Off",   "False",  "Disabled"};
  static const Words blend_factor{"One",
                                  "Zero",
                                  "SrcColor",
                                  "SrcAlpha",
                                  "SrcAlphaSaturate",
                                  "DstColor",
                                  "DstAlpha",
                                  "OneMinusSrcColor",
                                  "OneMinusSrcAlpha",
                                  "OneMinusDstColor",
                                  "OneMinusDstAlpha",
                                  "Off",
                                  "False"};
  static const Words blend_operation{"Add",
                                     "Sub",
                                     "RevSub",
                                     "Min",
                                     "Max",
                                     "LogicalClear",
                                     "LogicalSet",
                                     "LogicalCopy",
                                     "LogicalCopyInverted",
                                     "LogicalNoop",
                                     "LogicalInvert",
                                     "LogicalAnd",
                                     "LogicalNand",
                                     "LogicalOr",
                                     "LogicalNor",
                                     "LogicalXor",
                                     "LogicalEquiv",
                                     "LogicalAndReverse",
                                     "LogicalAndInverted",
                                     "LogicalOrReverse",
                                     "LogicalOrInverted",
                                     "Multiply",
                                     "Screen",
                                     "Overlay",
                                     "Darken",
                                     "Lighten",
                                     "ColorDodge",
                                     "ColorBurn",
                                     "HardLight",
                                     "SoftLight",
                                     "Difference",
                                     "Exclusion",
                                     "HSLHue",
                                     "HSLSaturation",
                                     "HSLColor",
                                     "HSLLuminosity"};
  static const Words stencil_operation{"Keep",    "Zero",   "Replace",  "IncrSat",
                                       "DecrSat", "Invert", "IncrWrap", "DecrWrap"};
  static const Words color_material{"AmbientAndDiffuse", "Emission"};
  static const Words fog_mode{"Off", "False", "Global", "Linear", "Exp", "Exp2"};
  switch (values) {
    case Values::anything:
    case Values::color_mask:
    case Values::stencil_number:
    case Values::number:
      break;
    case Values::toggle:
      return toggle;
    case Values::cull:
      return cull;
    case Values::comparison:
      return comparison;
    case Values::blend_factor:
      return blend_factor;
    case Values::blend_operation:
      return blend_operation;
    case Values::stencil_operation:
      return stencil_operation;
    case Values::color_material:
      return color_material;
    case Values::fog_mode:
      return fog_mode;
  }
  return none;
}

// Returns the largest number of the values, which count from 0: those of UnityEngine.Rendering's
// enumerations.
std::optional<int> largest_number(Values values) {
  switch (values) {
    case Values::toggle:
      return 1;
    case Values::cull:
      return 2;
    case Values::stencil_operation:
      return 7;
    case Values::comparison:
      return 8;
    case Values::blend_factor:
      return 10;
    case Values::color_mask:
      return 15;
    case Values::blend_operation:
      return 35;
    case Values::stencil_number:
      return 255;
    default:
      return std::nullopt;
  }
}

ValueProblem number_problem(const std::string& command, Values values, std::string_view number) {
  const std::optional<int> largest = largest_number(values);
  const std::string shown(number.substr(0, 40));
  if (number.starts_with('+')) number.remove_prefix(1);
  double value = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), value);
  const bool in_range = read.ec == std::errc() && value >= 0 && largest && value <= *largest;
  if (!largest || in_range) return {};
  return {"'" + shown + "' is out of range: " + command + " takes 0 to " + std::to_string(*largest),
          hlsl::Severity::warning};
}

bool is_color_mask(const std::string& word) {
  return std::all_of(word.begin(), word.end(),
                     [](char c) { return std::string_view("RGBArgba").find(c) != std::string_view::npos; });
}

bool is_on(const std::string& word) {
  return same_keyword("On", word) || same_keyword("True", word);
}

std::string listed(const Words& words) {
  constexpr std::size_t most = 12;  // BlendOp has too many for a message
  std::string text;
  for (std::size_t i = 0; i < words.size() && i < most; ++i) text += (i == 0 ? "" : ", ") + words[i];
  return words.size() > most ? text + ", ..." : text;
}

}  // namespace

ValueProblem value_problem(const std::string& command, Values values, const Command::Value& value) {
  if (value.kind == Command::Value::Kind::number) return number_problem(command, values, value.text);
  const bool is_word = value.kind == Command::Value::Kind::identifier;
  if (values == Values::anything || (!is_word && value.kind != Command::Value::Kind::string)) return {};
  const std::string shown = "'" + value.text.substr(0, 40) + "' is not a value of " + command;
  if (values == Values::number || values == Values::stencil_number) return {shown + ": it takes a number"};
  if (values == Values::color_mask)
    return {is_word && is_color_mask(value.text) ? "" : shown + ": it takes 0 or letters of RGBA"};
  const Words& words = words_of(values);
  const bool known = std::any_of(words.begin(), words.end(),
                                 [&](const std::string& word) { return same_keyword(word, value.text); });
  if (known && is_word) return {};
  if (known) return {"write " + command + " " + value.text + " without quotation marks"};
  const std::string takes = "it takes " + listed(words);
  if (values == Values::comparison && is_word && is_on(value.text))
    return {"'" + value.text + "' is not a comparison, although Unity accepts it: " + takes,
            hlsl::Severity::warning};
  const std::string hint = near_name_hint(value.text, words);
  return {shown + ": " + (hint.empty() ? takes : hint)};
}

}  // namespace penumbra::shaderlab
