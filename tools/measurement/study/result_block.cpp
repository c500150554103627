#include "study/result_block.h"

#include <fmt/format.h>

#include <algorithm>

#include "input/input_error.h"
#include "input/markdown.h"
#include "input/nearest_name.h"
#include "input/text_line.h"
#include "study/summary.h"

namespace penumbra::study {
namespace {

constexpr const char* figures_begin =
    R"(namespace Penumbra.Editor
{{
    // Means over {0} scenes; Documentation~/presets.md says how they were measured.
    // Written by `penumbra measure --presets` from Documentation~/results/presets/results.tsv; do not edit.
    internal static class PresetFigures
    {{
        /// <summary>One row per preset, in QualityPreset's order; by ascending angular diameter.</summary>
        internal static readonly PresetFigure[][] Rows =
        {{
)";

constexpr const char* figures_end = R"(        };
    }
}
)";

std::string figure(const SummaryLine& line) {
  if (!line.complete || !line.rmse_penumbra || !line.fetches)
    throw InputError("", line.choice.technique + " was not measured on every scene",
                     "measure all presets on the same scenes");
  return fmt::format("                new PresetFigure({:g}f, {:.3f}f, {:.1f}f),\n", line.light_degrees,
                     line.rmse_penumbra->value, line.fetches->value);
}

std::string light_name(double degrees) {
  return fmt::format("{}°", degrees);
}

// Returns the commit and the packages of results or an earlier run, where they are known.
template <class Run>
std::string provenance(const Run& run) {
  std::string text;
  if (run.commit) text += " at commit " + markdown_cell(*run.commit);
  for (const PackageNote& package : run.packages) {
    text += ", " + markdown_cell(package.name + (package.version ? " " + *package.version : ""));
  }
  return text;
}

// Returns "2° light, 12 scenes, 1530117 penumbra pixels, at least 9430 per scene".
std::string sample_text(const Results& results, double light) {
  const LightSample sample = sample_of(results, light);
  const std::string least =
      sample.scenes == 1 ? "" : fmt::format(", at least {} per scene", sample.smallest_penumbra_pixels);
  return fmt::format("{} light, {} scene{}, {} penumbra pixels{}", light_name(light), sample.scenes,
                     sample.scenes == 1 ? "" : "s", sample.penumbra_pixels, least);
}

// Returns "URP High", and the map where results hold several.
std::string title_of(const Choice& choice) {
  return markdown_cell(choice.title + choice.label.substr(choice.technique.size()));
}

// Returns "Tent 5x5, `tent-5`": options take the name.
std::string title_and_name(const Choice& choice) {
  return choice.title == choice.technique ? title_of(choice)
                                          : title_of(choice) + ", " + markdown_code(choice.technique);
}

// Only optimised bytecode counts: before a compiler optimises it, the operations say little of what a GPU
// runs.
bool has_operations(const Results& results) {
  return results.front_end &&
         std::any_of(results.records.begin(), results.records.end(),
                     [](const Record& record) { return record.operations_per_pixel.has_value(); });
}

// A picture from one noise seed says nothing of grain.
bool has_grain(const Results& results) {
  return std::any_of(results.records.begin(), results.records.end(),
                     [](const Record& record) { return record.metrics.variance.has_value(); });
}

bool has_overlaps(const Results& results) {
  return std::any_of(results.records.begin(), results.records.end(),
                     [](const Record& record) { return record.overlap.has_value(); });
}

bool has_flip(const Results& results) {
  return std::any_of(results.records.begin(), results.records.end(),
                     [](const Record& record) { return record.flip.has_value(); });
}

bool has_group_steps(const Results& results) {
  return std::any_of(results.records.begin(), results.records.end(),
                     [](const Record& record) { return record.group_step.has_value(); });
}

// A figure of the tables: its column's head, and its cell.
struct FigureColumn {
  const char* head;
  std::string (*cell)(const SummaryLine&);
};

const FigureColumn kPenumbraError{"RMSE in penumbra",
                                  [](const SummaryLine& line) { return figure_text(line.rmse_penumbra); }};
const FigureColumn kError{"RMSE of all pixels",
                          [](const SummaryLine& line) { return figure_text(line.rmse_all); }};
const FigureColumn kLeaks{"light leaks, %",
                          [](const SummaryLine& line) { return figure_text(line.leak_rate, 100.0); }};
const FigureColumn kFalseShadow{
    "false shadow, %", [](const SummaryLine& line) { return figure_text(line.false_shadow_rate, 100.0); }};
const FigureColumn kOverlap{"RMSE where shadows overlap",
                            [](const SummaryLine& line) { return figure_text(line.rmse_overlap); }};
const FigureColumn kFlip{"FLIP of the lit picture",
                         [](const SummaryLine& line) { return figure_text(line.flip); }};
const FigureColumn kGrain{"grain", [](const SummaryLine& line) { return figure_text(line.grain); }};
const FigureColumn kGroupStep{"step across tiles",
                              [](const SummaryLine& line) { return figure_text(line.group_step); }};
const FigureColumn kFetches{"fetches per pixel",
                            [](const SummaryLine& line) { return fetches_text(line.fetches); }};
const FigureColumn kPenumbraFetches{
    "fetches in penumbrae", [](const SummaryLine& line) { return fetches_text(line.fetches_in_penumbra); }};
const FigureColumn kOperations{"operations per pixel",
                               [](const SummaryLine& line) { return operations_text(line.operations); }};

// Says of a mean over fewer scenes than others how many they are.
std::string scenes_if_fewer(const SummaryLine& line) {
  return line.complete ? "" : fmt::format(" ({} scene{})", line.scenes, line.scenes == 1 ? "" : "s");
}

// Returns one row for each technique, of one light.
std::string mean_table(const Results& results) {
  const std::vector<FigureColumn> columns{kPenumbraError, kError,   kLeaks,
                                          kFalseShadow,   kFetches, kPenumbraFetches};
  std::vector<std::string> heads{"Technique"};
  for (const FigureColumn& column : columns) heads.emplace_back(column.head);
  std::vector<std::vector<std::string>> rows;
  for (const SummaryLine& line : summarise(results)) {
    std::vector<std::string>& row = rows.emplace_back();
    row.push_back(title_of(line.choice) + scenes_if_fewer(line));
    for (const FigureColumn& column : columns) row.push_back(column.cell(line));
  }
  return markdown_table(heads, rows);
}

// Adds to each row, of one technique, the figure under each light.
void add_by_light(const Results& results, const std::vector<double>& lights, const FigureColumn& column,
                  std::vector<std::string>& heads, std::vector<std::vector<std::string>>& rows) {
  const std::vector<SummaryLine> lines = summarise(results);
  const std::vector<Choice> techniques = choices(results);
  for (const double light : lights) {
    heads.push_back(std::string(column.head) +
                    (light_sizes(results).size() > 1 ? ", " + light_name(light) : ""));
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const auto line = std::find_if(lines.begin(), lines.end(), [&](const SummaryLine& each) {
        return each.choice == techniques[row] && each.light_degrees == light;
      });
      rows[row].push_back(line == lines.end() ? "–" : column.cell(*line) + scenes_if_fewer(*line));
    }
  }
}

// Returns those records alone, technique by technique.
Results with_rows(const Results& results, const std::vector<std::string>& rows) {
  if (rows.empty()) return results;
  check_rows(rows, technique_names(results));
  Results shown = results;
  shown.records.clear();
  for (const std::string& row : rows) {
    for (const Record& record : results.records) {
      if (record.technique == row) shown.records.push_back(record);
    }
  }
  return shown;
}

std::string origin(const Results& results) {
  return fmt::format("Penumbra {}{}, shaders compiled by {}, on {}, driver {}, processor {}.\n",
                     markdown_cell(results.library_version), provenance(results),
                     markdown_cell(results.front_end.value_or(kGlslang)), markdown_cell(results.device),
                     markdown_cell(results.driver), markdown_cell(results.hardware));
}

// Describes rows that another run measured, of the same pictures.
std::string earlier_command(const EarlierRun& run) {
  std::vector<std::string> names;
  for (const std::string& technique : run.techniques) names.push_back(markdown_code(technique));
  return fmt::format("\nOf the same pictures, by Penumbra {}{}: {}. Command: {}.\n",
                     markdown_cell(run.library_version), provenance(run), fmt::join(names, ", "),
                     markdown_code(run.command));
}

std::string command(const Results& results) {
  std::string text = fmt::format("Command: {}. ", markdown_code(results.command)) + origin(results);
  for (const EarlierRun& run : results.earlier) text += earlier_command(run);
  return text;
}

bool has_map_passes(const Record& record) {
  return std::any_of(record.passes.begin(), record.passes.end(),
                     [](const PassRecord& pass) { return pass.fetches_per_cascade.has_value(); });
}

bool has_map_passes(const Results& results) {
  return std::any_of(results.records.begin(), results.records.end(),
                     [](const Record& record) { return has_map_passes(record); });
}

// Returns "480 x 270 to 1440 x 810 pixels".
std::string picture_sizes(const Results& results) {
  const auto smaller = [](const MeasuredFrame& a, const MeasuredFrame& b) {
    return static_cast<double>(a.width) * a.height < static_cast<double>(b.width) * b.height;
  };
  const auto [least, most] = std::minmax_element(results.frames.begin(), results.frames.end(), smaller);
  if (least == results.frames.end()) return "unknown size";
  const std::string smallest = fmt::format("{} x {}", least->width, least->height);
  const std::string largest = fmt::format("{} x {}", most->width, most->height);
  return (smallest == largest ? smallest : smallest + " to " + largest) + " pixels";
}

std::string how_to_read(const Results& results, BlockForm form) {
  const char* figure =
      scene_names(results).size() == 1
          ? "Each figure is of one scene ± half the width of its 95 % confidence interval, which covers the "
            "choice of pixels and says nothing of other scenes"
          : "Each figure is a mean over the scenes ± half the width of its 95 % confidence interval, which "
            "covers the choice of scenes and of pixels";
  std::string text = fmt::format(
      "Errors and rates are measured against ray tracing. {}; where the interval is cut off at 0 or 100 %, "
      "[a, b] gives "
      "its ends. Light leaks: share of the pixels in full shadow whose visibility is above {}. False shadow: "
      "share of "
      "the fully lit pixels whose visibility is below {}.",
      figure, kLeakAbove, kFalseShadowBelow);
  if (has_overlaps(results))
    text +=
        " Shadows overlap where the highest caster over a receiver is four times as far away as the lowest.";
  if (has_flip(results))
    text +=
        " FLIP (Andersson et al. 2020): how much the picture lit by these shadows differs from the one lit "
        "by ray-traced "
        "ones for an eye that flips between them, 0 to 1.";
  if (has_grain(results))
    text += " Grain: the root of the mean variance between pictures of different noise, in penumbra.";
  const bool full = form == BlockForm::full;
  if (full && has_group_steps(results))
    text +=
        " Step across tiles: the step of the error between neighbours on both sides of a border of 8 x 8 "
        "pixels, as a "
        "multiple of that between other neighbours.";
  if (full || !has_operations(results))
    text +=
        " Fetches in penumbrae: fetches per pixel over the pixels in penumbra alone, where a technique that "
        "can stop "
        "early does all its work; of techniques with passes over the screen, over the whole picture.";
  if (has_map_passes(results))
    text +=
        " Fetches and operations include the passes over the shadow map, divided by the pixels of the "
        "pictures, "
        "which are of " +
        picture_sizes(results) + ".";
  if (has_operations(results))
    text +=
        " Operations: scalar arithmetic that all passes execute as FXC has optimised it, per pixel of the "
        "picture.";
  return text;
}

// Returns what the passes over the map take, which does not depend on the picture's size, and the other
// fetches: means over the scenes at the middle light.
std::vector<std::string> map_pass_cells(const Results& results, const Choice& choice) {
  double of_map = 0.0, others = 0.0;
  int scenes = 0;
  for (const std::string& scene : scene_names(results)) {
    const Record* record = find_record(results, choice.label, scene, middle_light(results));
    if (record == nullptr || !record->metrics.fetches_mean || !has_map_passes(*record)) continue;
    ++scenes;
    others += *record->metrics.fetches_mean + record->metrics.preprocess_fetches_per_pixel;
    for (const PassRecord& pass : record->passes) {
      if (!pass.fetches_per_cascade) continue;
      of_map += *pass.fetches_per_cascade * record->cascades;
      others -= pass.fetches_per_pixel;
    }
  }
  if (scenes == 0) return {"–", "–"};
  return {fmt::format("{:.1f}", of_map / scenes / 1e6), fmt::format("{:.1f}", others / scenes)};
}

// Returns "URP High: 0.31 ± 0.10 with 16 texture fetches per pixel (16 per pixel in penumbra)"; units are
// given once.
std::string line_block(const Results& results) {
  const double light = middle_light(results);
  std::string figures;
  for (const SummaryLine& line : summarise(results)) {
    if (line.light_degrees != light) continue;
    figures +=
        fmt::format("{}{}: {} with {}{} ({}{})", figures.empty() ? "" : "; ", title_of(line.choice),
                    figure_text(line.rmse_penumbra), fetches_text(line.fetches),
                    figures.empty() ? " texture fetches per pixel" : "",
                    fetches_text(line.fetches_in_penumbra), figures.empty() ? " per pixel in penumbra" : "");
  }
  const std::size_t scenes = sample_of(results, light).scenes;
  return fmt::format(
      "Error in penumbrae (RMSE of visibility, 0 to 1, against ray tracing; {} light, mean of {} scene{}): "
      "{}.\n",
      light_name(light), scenes, scenes == 1 ? "" : "s", figures);
}

// Returns one row for each technique, which has these figures under each light.
std::string table_by_light(const Results& results, const std::vector<FigureColumn>& columns,
                           std::string (*name)(const Choice&)) {
  std::vector<std::string> heads{"Technique"};
  std::vector<std::vector<std::string>> rows;
  for (const Choice& choice : choices(results)) rows.push_back({name(choice)});
  for (const FigureColumn& column : columns) add_by_light(results, light_sizes(results), column, heads, rows);
  return markdown_table(heads, rows);
}

std::string samples_text(const Results& results) {
  std::vector<std::string> samples;
  for (const double light : light_sizes(results)) samples.push_back(sample_text(results, light));
  return fmt::format("{}:\n\n", fmt::join(samples, "; "));
}

std::vector<FigureColumn> brief_columns(const Results& results) {
  std::vector<FigureColumn> columns{kPenumbraError, kError, kLeaks, kFalseShadow};
  if (has_overlaps(results)) columns.push_back(kOverlap);
  if (has_flip(results)) columns.push_back(kFlip);
  if (has_grain(results)) columns.push_back(kGrain);
  columns.push_back(has_operations(results) ? kOperations : kFetches);
  return columns;
}

std::string brief_block(const Results& results) {
  const std::string table = light_sizes(results).size() == 1
                                ? mean_table(results)
                                : table_by_light(results, brief_columns(results), title_of);
  return samples_text(results) + table + "\n" + how_to_read(results, BlockForm::brief) + "  \n" +
         command(results);
}

// Returns one row for each technique: the error of all pixels, what it costs, and what is known of it.
std::string cost_table(const Results& results, const FactsOfTechniques& facts) {
  const std::vector<double> middle{middle_light(results)};
  std::vector<std::string> heads{"Technique"};
  std::vector<std::vector<std::string>> rows;
  for (const Choice& choice : choices(results)) rows.push_back({markdown_code(choice.label)});
  add_by_light(results, light_sizes(results), kError, heads, rows);
  if (has_overlaps(results)) add_by_light(results, light_sizes(results), kOverlap, heads, rows);
  if (has_flip(results)) add_by_light(results, light_sizes(results), kFlip, heads, rows);
  if (has_grain(results)) add_by_light(results, light_sizes(results), kGrain, heads, rows);
  if (has_group_steps(results)) add_by_light(results, light_sizes(results), kGroupStep, heads, rows);
  add_by_light(results, light_sizes(results), kFetches, heads, rows);
  add_by_light(results, middle, kPenumbraFetches, heads, rows);
  if (has_operations(results)) add_by_light(results, light_sizes(results), kOperations, heads, rows);
  if (has_map_passes(results)) {
    heads.insert(heads.end(), {"fetches of the passes over the map, millions", "other fetches per pixel"});
    for (std::size_t row = 0; row < rows.size(); ++row)
      for (const std::string& cell : map_pass_cells(results, choices(results)[row]))
        rows[row].push_back(cell);
  }
  const std::vector<TechniqueRow> known = technique_rows(results, facts);
  const bool advice = has_advice(known);
  if (!known.empty()) heads.emplace_back("maps, MiB");
  if (!known.empty() && !facts.cycles_of.empty())
    heads.push_back("cycles, " + markdown_cell(facts.cycles_of));
  if (advice) heads.insert(heads.end(), {"Use it when", "Not when"});
  for (std::size_t row = 0; row < known.size(); ++row) {
    rows[row].push_back(fmt::format("{:.1f}", known[row].map_mebibytes));
    if (!facts.cycles_of.empty()) rows[row].push_back(cycles_text(known[row].cycles));
    if (!advice) continue;
    rows[row].push_back(markdown_cell(known[row].use_when));
    rows[row].push_back(markdown_cell(known[row].not_when));
  }
  return (known.empty() ? "" : rows_explained(known, facts) + "\n\n") +
         markdown_table(heads, rows, advice ? 2 : 0) + "\n";
}

std::string full_block(const Results& results, const BlockStyle& style) {
  return how_to_read(results, BlockForm::full) + "\n\n" + samples_text(results) +
         table_by_light(results, {kPenumbraError, kLeaks, kFalseShadow}, title_and_name) +
         fmt::format("\n![Penumbra error against fetches per pixel]({})\n\n", style.chart_path) +
         cost_table(results, style.facts) + command(results);
}

}  // namespace

void check_rows(const std::vector<std::string>& rows, const std::vector<std::string>& measured) {
  const auto is_measured = [&measured](const std::string& row) {
    return std::find(measured.begin(), measured.end(), row) != measured.end();
  };
  if (!rows.empty() && std::none_of(rows.begin(), rows.end(), is_measured))
    throw InputError("", fmt::format("none of the rows {} was measured", fmt::join(rows, ", ")),
                     unknown_name_remedy(rows.front(), measured));
}

std::string result_block(const Results& results, const BlockStyle& style) {
  const Results shown = with_rows(results, style.rows);
  if (shown.records.empty()) return "No record.\n";
  switch (style.form) {
    case BlockForm::line:
      return line_block(shown);
    case BlockForm::brief:
      return brief_block(shown);
    case BlockForm::full:
      break;
  }
  return full_block(shown, style);
}

std::string replace_result_block(const std::string& text, const std::string& block, const std::string& name,
                                 std::string_view block_name) {
  return replace_block(text, block_name, block, name);
}

void check_presets(const std::vector<std::string>& measured, const std::string& prefix) {
  const auto is_preset = [&prefix](const std::string& technique) { return technique.starts_with(prefix); };
  if (std::none_of(measured.begin(), measured.end(), is_preset))
    throw InputError("", "no quality preset was measured", "measure those whose names begin with " + prefix);
}

std::string preset_figures_csharp(const Results& results, const std::string& prefix) {
  check_presets(technique_names(results), prefix);
  std::string text = fmt::format(figures_begin, scene_names(results).size());
  std::string open;  // the preset whose row is being written
  for (const SummaryLine& line : summarise(results)) {
    if (!line.choice.technique.starts_with(prefix)) continue;
    if (line.choice.technique != open) {
      if (!open.empty()) text += "            },\n";
      open = line.choice.technique;
      text += fmt::format("            new[]  // {}\n            {{\n", in_one_line(line.choice.title));
    }
    text += figure(line);
  }
  return text + "            },\n" + figures_end;
}

}  // namespace penumbra::study
