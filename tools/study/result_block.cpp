#include "study/result_block.h"

#include <fmt/format.h>

#include "input/input_error.h"
#include "input/markdown.h"
#include "study/summary.h"

namespace penumbra::study {
namespace {

// A header row, the line under it (first column left, others right), and rows added one by one.
class Table {
 public:
  explicit Table(const std::vector<std::string>& heads) {
    add(heads);
    text_ += "|:--";
    for (std::size_t i = 1; i < heads.size(); ++i) text_ += "|--:";
    text_ += "|\n";
  }
  void add(const std::vector<std::string>& cells) {
    text_ += fmt::format("| {} |\n", fmt::join(cells, " | "));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string light_name(double degrees) {
  return fmt::format("{}°", degrees);
}

// The commit and the packages, where they are known.
std::string provenance(const Results& results) {
  std::string text;
  if (results.commit) text += " at commit " + markdown_cell(*results.commit);
  for (const PackageNote& package : results.packages) {
    text += ", " + markdown_cell(package.name + (package.version ? " " + *package.version : ""));
  }
  return text;
}

// What stands behind a light's means.
std::string sample_text(const Results& results, double light) {
  const LightSample sample = sample_of(results, light);
  return fmt::format("{} light, {} scene{}, {} penumbra pixels, {} in the scene with fewest:\n\n",
                     light_name(light), sample.scenes, sample.scenes == 1 ? "" : "s", sample.penumbra_pixels,
                     sample.smallest_penumbra_pixels);
}

std::string mean_table(const Results& results, double light) {
  Table table({"Technique", "RMSE in penumbra", "RMSE of all pixels", "light leaks, %", "false shadow, %",
               "fetches per pixel"});
  for (const SummaryLine& line : summarise(results)) {
    if (line.light_degrees != light) continue;
    const std::string partial = line.complete ? "" : fmt::format(" ({} scenes)", line.scenes);
    table.add({markdown_cell(line.choice.label) + partial, figure_text(line.rmse_penumbra),
               figure_text(line.rmse_all), figure_text(line.leak_rate, 100.0),
               figure_text(line.false_shadow_rate, 100.0), fetches_text(line.fetches)});
  }
  return table.text();
}

std::string scene_table(const Results& results, double light) {
  std::vector<std::string> heads{"Technique"};
  for (const std::string& scene : scene_names(results)) heads.push_back(markdown_cell(scene));
  Table table(heads);
  for (const Choice& choice : choices(results)) {
    std::vector<std::string> cells{markdown_cell(choice.label)};
    for (const std::string& scene : scene_names(results)) {
      const Record* record = find_record(results, choice.label, scene, light);
      cells.push_back(figure_text(record != nullptr ? rmse_penumbra_of(*record) : std::nullopt));
    }
    table.add(cells);
  }
  return table.text();
}

// Those records alone, technique by technique.
Results with_rows(const Results& results, const std::vector<std::string>& rows) {
  if (rows.empty()) return results;
  Results shown = results;
  shown.records.clear();
  for (const std::string& row : rows) {
    for (const Record& record : results.records) {
      if (record.technique == row) shown.records.push_back(record);
    }
  }
  if (shown.records.empty()) {
    throw InputError("", fmt::format("none of the rows {} was measured", fmt::join(rows, ", ")));
  }
  return shown;
}

std::string folded(const std::string& title, const std::string& content) {
  return "<details><summary>" + title + "</summary>\n\n" + content + "\n</details>\n";
}

std::string light_table(const Results& results, double light) {
  return sample_text(results, light) + mean_table(results, light);
}

std::string origin(const Results& results) {
  return fmt::format("Penumbra {}{}, on {}, driver {}, processor {}.\n",
                     markdown_cell(results.library_version), provenance(results),
                     markdown_cell(results.device), markdown_cell(results.driver),
                     markdown_cell(results.hardware));
}

std::string command(const Results& results) {
  return folded("The command", fmt::format("```sh\n{}\n```\n\n{}", results.command, origin(results)));
}

constexpr const char* kHowToRead =
    "Errors and rates are against ray tracing: means over the scenes ± half of their 95 % interval, over "
    "scenes and "
    "pixels. Light leaks are in full shadow, false shadow is in full light.\n\n";

std::string brief_block(const Results& results) {
  const std::vector<double> lights = light_sizes(results);
  const double middle = lights[lights.size() / 2];
  std::string others;
  for (const double light : lights) {
    if (light != middle) others += (others.empty() ? "" : "\n") + light_table(results, light);
  }
  std::string block = light_table(results, middle) + "\n" + kHowToRead;
  if (!others.empty()) block += folded("Smaller and larger lights", others) + "\n";
  return block + command(results);
}

std::string full_block(const Results& results, const std::string& chart_path) {
  std::string block = kHowToRead;
  std::string scenes;
  for (const double light : light_sizes(results)) {
    block += light_table(results, light) + "\n";
    scenes += (scenes.empty() ? "" : "\n") + light_name(light) + " light\n\n" + scene_table(results, light);
  }
  block += fmt::format("![Fetches against penumbra error]({})\n\n", chart_path);
  return block + folded("Penumbra RMSE of every scene", scenes) + "\n" + command(results);
}

}  // namespace

std::string result_block(const Results& results, const BlockStyle& style) {
  const Results shown = with_rows(results, style.rows);
  if (shown.records.empty()) return "No record.\n";
  return style.brief ? brief_block(shown) : full_block(shown, style.chart_path);
}

std::string replace_result_block(const std::string& text, const std::string& block, const std::string& name,
                                 std::string_view block_name) {
  return replace_block(text, block_name, block, name);
}

}  // namespace penumbra::study
