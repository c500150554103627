#include "cost/cost_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

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

// A set of keywords, such as "+DARK +FOG", consists of names alone, which compute nothing.
bool is_keyword_set(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' ||
           c == '+' || c == ' ';
  });
}

// Spreadsheets run what begins as a formula does, quoted or not: such a text begins with an apostrophe. They
// also split at a semicolon, where the comma separates decimals.
std::string csv_cell(const std::string& any_text) {
  std::string text = visible(any_text);
  if (text.find_first_of("=+-@") == 0 && !is_keyword_set(text)) text.insert(0, 1, '\'');
  if (text.find_first_of(",;\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

// Each column is as wide as its widest cell; the first is left-aligned, the others are right-aligned.
std::string aligned(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& line : lines) {
    widths.resize(std::max(widths.size(), line.size()));
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text;
  for (const std::vector<std::string>& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i)
      text +=
          i == 0 ? fmt::format("{:<{}}", line[i], widths[i]) : fmt::format("  {:>{}}", line[i], widths[i]);
    text += "\n";
  }
  return text;
}

// Returns each once, in order; none for a user's file.
std::vector<std::string> technique_names(const CostRow& row) {
  std::vector<std::string> names;
  for (const CostVariant& variant : row.variants)
    if (!variant.technique.empty()) add_once(names, variant.technique);
  return names;
}

// Returns " +A +B or none", or nothing.
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

// A family's columns are every figure but those that are 0 in all its rows, and the lanes of a subgroup.
std::vector<std::string> column_heads(const CostReport& report, const std::string& family) {
  std::vector<std::string> heads{"shader"};
  for (const FigureName& name : figure_names())
    if (shown(report, family, name)) heads.emplace_back(name.heading);
  if (family != direct3d_family.name) heads.emplace_back("lanes");
  return heads;
}

std::vector<std::string> column_cells(const CostReport& report, const CostRow& row) {
  std::vector<std::string> cells{row_name(row)};
  for (const FigureName& name : figure_names())
    if (shown(report, row.family, name)) cells.push_back(figure_text(row.measured.figures.*name.value));
  if (row.family != direct3d_family.name) cells.push_back(std::to_string(row.measured.subgroup_size));
  return cells;
}

// Returns the names of the figures that are 0 in all tables.
std::string absent_figures(const CostReport& report) {
  if (report.failures() == report.rows.size()) return "";
  std::string names;
  for (const FigureName& name : figure_names())
    if (is_zero(report, name)) names += (names.empty() ? "" : ", ") + std::string(name.heading);
  return names.empty() ? "" : "0 in every row: " + names + "\n";
}

// Lists the techniques that "(and 3 more)" omits.
std::string shared_modules(const CostReport& report) {
  std::set<std::string> said;
  std::string text;
  for (const CostRow& row : report.rows) {
    const std::vector<std::string> names = technique_names(row);
    if (names.size() < 2 || !said.insert(names.front()).second) continue;
    std::string others;
    for (std::size_t i = 1; i < names.size(); ++i) others += (i == 1 ? " " : ", ") + names[i];
    text += visible(names.front() + " is the same shader as" + others) + ": they differ in uniforms\n";
  }
  return text;
}

}  // namespace

const std::string& driver_of(const CostReport& report, const std::string& name) {
  for (const RadvFamily& family : report.families)
    if (family.name == name) return family.driver;
  return report.driver;
}

std::size_t CostReport::failures() const {
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [](const CostRow& row) { return !row.measured.failure.empty(); }));
}

std::string cost_csv(const CostReport& report) {
  std::string text = "family,techniques,file,entry,stage,keywords";
  for (const FigureName& name : figure_names()) text.append(",").append(name.key);
  text += ",subgroup_size,failure,driver\n";
  for (const CostRow& row : report.rows) {
    std::string names;
    for (const std::string& name : technique_names(row)) names += (names.empty() ? "" : " ") + name;
    const std::string keywords = keywords_text(row);
    for (const std::string& cell : {row.family, names, row.file, row.entry, row.stage,
                                    keywords.empty() ? keywords : keywords.substr(1)})
      text += csv_cell(cell) + ",";
    for (const FigureName& name : figure_names()) {
      const Figure& figure = row.measured.figures.*name.value;
      text += (figure ? std::to_string(*figure) : "") + ",";
    }
    text += std::to_string(row.measured.subgroup_size) + "," + csv_cell(row.measured.failure) + "," +
            csv_cell(driver_of(report, row.family)) + "\n";
  }
  return text;
}

std::string cost_table(const CostReport& report) {
  std::string text;
  std::string failures;
  for (const RadvFamily& family : report.families) {
    std::vector<std::vector<std::string>> lines{column_heads(report, family.name)};
    for (const CostRow& row : report.rows) {
      if (row.family != family.name) continue;
      if (row.measured.failure.empty()) {
        lines.push_back(column_cells(report, row));
      } else {
        failures +=
            "failed: " + row_name(row) + ", " + visible(family.name + ": " + row.measured.failure) + "\n";
      }
    }
    if (lines.size() > 1)
      text +=
          visible(family.name + ": " + family.device + ", " + family.driver) + "\n" + aligned(lines) + "\n";
  }
  return text + absent_figures(report) + shared_modules(report) + failures;
}

std::string row_name(const CostRow& row) {
  const std::vector<std::string> names = technique_names(row);
  std::string name = names.empty() ? row.file + " " + row.entry : names.front();
  if (names.size() > 1) name += fmt::format(" (and {} more)", names.size() - 1);
  // A technique has a row for each of its programs.
  if (!names.empty() && !row.file.ends_with(".hlsl")) name += ": " + row.entry;
  return visible(name + keywords_text(row));
}

}  // namespace penumbra::cost
