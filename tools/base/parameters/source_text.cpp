#include "parameters/source_text.h"

#include <fmt/format.h>

#include <cctype>

namespace penumbra::parameters {

namespace {

// Turns "DiskTables" into "DISK_TABLES" or "disk_tables".
std::string split_words(const std::string& pascal, bool upper) {
  std::string text;
  for (const char c : pascal) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isupper(letter) != 0 && !text.empty()) text += '_';
    text += static_cast<char>(upper ? std::toupper(letter) : std::tolower(letter));
  }
  return text;
}

std::string joined(const FloatTable& table, std::size_t row, const char* suffix) {
  std::string text;
  for (int column = 0; column < table.columns; ++column) {
    const std::size_t at = row * static_cast<std::size_t>(table.columns) + static_cast<std::size_t>(column);
    text += fmt::format("{}{}{}", column == 0 ? "" : ", ", float_literal(table.values[at]), suffix);
  }
  return text;
}

// Returns the entries, a few to a line so that lines stay below 110 columns.
std::string entries(const FloatTable& table, const std::string& open, const std::string& close,
                    const char* suffix, const std::string& indent) {
  std::string text;
  std::string line;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const bool last = row + 1 == table.rows();
    const std::string entry =
        fmt::format("{}{}{}{}", open, joined(table, row, suffix), close, last ? "" : ",");
    if (!line.empty() && indent.size() + line.size() + entry.size() > 108) {
      text += indent + line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + entry;
  }
  return text + indent + line + "\n";
}

std::string comment_block(const SourceFile& file) {
  std::string text;
  for (const std::string& line : file.comment) text += line.empty() ? "//\n" : "// " + line + "\n";
  return text;
}

std::string hlsl_text(const SourceFile& file) {
  const std::string guard = "PENUMBRA_" + split_words(file.name, true) + "_INCLUDED";
  std::string text = fmt::format("{}#ifndef {}\n#define {}\n", comment_block(file), guard, guard);
  for (const FloatTable& table : file.tables) {
    const std::string type = table.columns == 1    ? "float"
                             : table.columns == 16 ? "float4x4"
                                                   : fmt::format("float{}", table.columns);
    text += fmt::format(
        "\n// {}\nstatic const {} kPenumbra{}[{}] =\n{{\n{}}};\n", table.comment, type, table.name,
        table.rows(),
        entries(table, table.columns == 1 ? "" : type + "(", table.columns == 1 ? "" : ")", "", "    "));
  }
  return text + fmt::format("\n#endif // {}\n", guard);
}

std::string csharp_text(const SourceFile& file) {
  std::string text = fmt::format("{}namespace Penumbra\n{{\n    public static class {}\n    {{\n",
                                 comment_block(file), file.name);
  for (std::size_t i = 0; i < file.tables.size(); ++i) {
    const FloatTable& table = file.tables[i];
    const std::string what = table.columns == 1 ? "" : fmt::format(" {} floats an entry.", table.columns);
    text += fmt::format(
        "{}        /// <summary>{}{}</summary>\n        public static readonly float[] {} =\n        {{\n{}"
        "        }};\n",
        i == 0 ? "" : "\n", table.comment, what, table.name, entries(table, "", "", "f", "            "));
  }
  return text + "    }\n}\n";
}

std::string cpp_text(const SourceFile& file) {
  std::string text =
      fmt::format("{}#pragma once\n\n// clang-format off\n\n#include <array>\n\nnamespace penumbra::{} {{\n",
                  comment_block(file), split_words(file.name, false));
  for (const FloatTable& table : file.tables) {
    const bool flat = table.columns == 1;
    const std::string type = flat ? "float" : fmt::format("std::array<float, {}>", table.columns);
    text += fmt::format("\n// {}\ninline constexpr std::array<{}, {}> k{} = {{{{\n{}}}}};\n", table.comment,
                        type, table.rows(), table.name,
                        entries(table, flat ? "" : "{{", flat ? "" : "}}", "f", "    "));
  }
  return text + fmt::format("\n}}  // namespace penumbra::{}\n", split_words(file.name, false));
}

}  // namespace

std::string float_literal(float value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string source_text(const SourceFile& file, Language language) {
  switch (language) {
    case Language::hlsl:
      return hlsl_text(file);
    case Language::csharp:
      return csharp_text(file);
    case Language::cpp:
      return cpp_text(file);
  }
  return {};
}

}  // namespace penumbra::parameters
