#include "cost/row_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "cost/families.h"
#include "input/visible_text.h"

namespace penumbra::cost {
namespace {

template <typename Value>
void add_once(std::vector<Value>& values, const Value& value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

bool shown(const CostReport& report, const std::string& family, const FigureName& name) {
  return std::any_of(report.rows.begin(), report.rows.end(), [&](const CostRow& row) {
    const Figure& figure = row.measured.figures.*name.value;
    return row.family == family && figure && *figure != 0;
  });
}

bool is_zero(const CostReport& report, const FigureName& name) {
  bool is_there = false;
  for (const CostRow& row : report.rows) {
    const Figure& figure = row.measured.figures.*name.value;
    if (figure && *figure != 0) return false;
    is_there |= figure.has_value();
  }
  return is_there;
}

}  // namespace

std::vector<std::string> technique_names(const CostRow& row) {
  std::vector<std::string> names;
  for (const CostVariant& variant : row.variants)
    if (!variant.technique.empty()) add_once(names, variant.technique);
  return names;
}

std::string keywords_text(const CostRow& row) {
  std::vector<std::string> sets;
  for (const CostVariant& variant : row.variants) {
    std::string set;
    for (const std::string& keyword : variant.keywords) set += " +" + keyword;
    add_once(sets, set);
  }
  std::string text = sets.empty() ? "" : sets.front();
  for (std::size_t i = 1; i < sets.size(); ++i) text += " or" + (sets[i].empty() ? " none" : sets[i]);
  return text;
}

std::string figure_text(const Figure& figure) {
  return figure ? std::to_string(*figure) : "-";
}

std::string row_name(const CostRow& row) {
  const std::vector<std::string> names = technique_names(row);
  std::string name = names.empty() ? row.file + " " + row.entry : names.front();
  if (names.size() > 1) name += fmt::format(" (and {} more)", names.size() - 1);
  // A technique has a row for each of its programs.
  if (!names.empty() && !row.file.ends_with(".hlsl")) name += ": " + row.entry;
  return visible(name + keywords_text(row));
}

std::vector<std::string> column_heads(const CostReport& report, const std::string& family) {
  std::vector<std::string> heads{"shader"};
  for (const FigureName& name : figure_names())
    if (shown(report, family, name)) heads.emplace_back(name.heading);
  if (family == direct3d_family.name) return heads;
  for (const char* head : {"lanes", "SPIR-V", "ALU", "texture"}) heads.emplace_back(head);
  return heads;
}

std::vector<std::string> column_cells(const CostReport& report, const CostRow& row) {
  std::vector<std::string> cells{row_name(row)};
  for (const FigureName& name : figure_names())
    if (shown(report, row.family, name)) cells.push_back(figure_text(row.measured.figures.*name.value));
  if (row.family == direct3d_family.name) return cells;
  for (const std::size_t count :
       {std::size_t{row.measured.subgroup_size}, row.spirv.instructions, row.spirv.alu, row.spirv.texture})
    cells.push_back(std::to_string(count));
  return cells;
}

std::string absent_figures(const CostReport& report) {
  if (report.failures() == report.rows.size()) return "";
  std::string names;
  for (const FigureName& name : figure_names())
    if (is_zero(report, name)) names += (names.empty() ? "" : ", ") + std::string(name.heading);
  return names.empty() ? "" : "0 in every row: " + names + "\n";
}

}  // namespace penumbra::cost
