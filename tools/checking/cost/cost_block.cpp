#include "cost/cost_block.h"

#include <algorithm>
#include <array>

#include "cost/families.h"
#include "input/markdown.h"

namespace penumbra::cost {
namespace {

constexpr const char* full_block = "cost";
constexpr const char* summary_block = "cost-summary";

std::string head_of(const CostReport& report) {
  std::string bytecode;
  for (const RadvFamily& family : report.families)
    if (family.name == direct3d_family.name) bytecode = " Direct3D: " + markdown_cell(family.driver) + ".";
  return "Driver: " + markdown_cell(report.driver) +
         ", without hardware. SPIR-V: " + markdown_cell(report.compiler) + "." + bytecode +
         "  \nCommand: " + markdown_code(report.command) + "\n\n";
}

std::string family_table(const CostReport& report, const RadvFamily& family) {
  std::vector<std::vector<std::string>> rows;
  for (const CostRow& row : report.rows) {
    if (row.family != family.name) continue;
    std::vector<std::string>& cells = rows.emplace_back();
    for (const std::string& cell : column_cells(report, row)) cells.push_back(markdown_cell(cell));
  }
  return markdown_table(column_heads(report, family.name), rows);
}

const CostRow* find_row(const CostReport& report, const std::string& family, const CostVariant& variant) {
  for (const CostRow& row : report.rows)
    if (row.family == family &&
        std::find(row.variants.begin(), row.variants.end(), variant) != row.variants.end())
      return &row;
  return nullptr;
}

bool has_block(const std::string& text, const char* name) {
  return text.find(block_begin(name)) != std::string::npos || text.find(block_end(name)) != std::string::npos;
}

}  // namespace

std::string cost_block(const CostReport& report) {
  std::string text = head_of(report);
  for (const RadvFamily& family : report.families)
    text += "**" + markdown_cell(family.name) + "** (" + markdown_cell(family.device) + ")\n\n" +
            family_table(report, family) + "\n";
  return text + absent_figures(report);
}

std::string cost_summary_block(const CostReport& report) {
  static constexpr std::array shown{"hard",   "tent-3",          "tent-5",
                                    "tent-7", "pcss-poisson-25", "pcss-angular-24-16"};
  static constexpr std::array figures{&Figures::instructions, &Figures::inverse_throughput_cycles};
  std::vector<std::string> heads{"Technique"};
  const auto of_figures = [&](const auto& add) {
    for (const auto figure : figures)
      for (const RadvFamily& family : report.families)
        // Bytecode has no cycles.
        if (figure == &Figures::instructions || family.name != direct3d_family.name) add(figure, family.name);
  };
  of_figures([&](const auto figure, const std::string& family) {
    heads.push_back((figure == &Figures::instructions ? "instructions, " : "cycles per 64 lanes, ") +
                    markdown_cell(family));
  });
  std::vector<std::vector<std::string>> rows;
  for (const char* technique : shown) {
    std::vector<std::string>& cells = rows.emplace_back(1, technique);
    of_figures([&](const auto figure, const std::string& family) {
      const CostRow* row = find_row(report, family, {technique, {"UNITY_REVERSED_Z"}});
      cells.push_back(row == nullptr ? "-" : figure_text(row->measured.figures.*figure));
    });
  }
  return head_of(report) + markdown_table(heads, rows);
}

std::string replace_cost_blocks(const std::string& text, const CostReport& report, const std::string& file) {
  const bool summary = has_block(text, summary_block);
  const bool full = has_block(text, full_block) || !summary;
  std::string replaced = text;
  if (full) replaced = replace_block(replaced, full_block, cost_block(report), file);
  if (summary) replaced = replace_block(replaced, summary_block, cost_summary_block(report), file);
  return replaced;
}

}  // namespace penumbra::cost
