#include "study/result_block.h"

#include <fmt/format.h>

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

}  // namespace

std::string result_block(const Results& results, const std::string& chart_path) {
  std::string block = fmt::format("Hardware: {}. Device: {}. Driver: {}. Penumbra {}{}.  \nCommand: `{}`\n\n",
                                  markdown_cell(results.hardware), markdown_cell(results.device),
                                  markdown_cell(results.driver), markdown_cell(results.library_version),
                                  provenance(results), results.command);
  block +=
      "Errors are against ray tracing. Each figure is the mean over the scenes, ± half of its 95 % interval "
      "over "
      "scenes and pixels.\n\n";
  for (const double light : light_sizes(results)) {
    block += sample_text(results, light) + mean_table(results, light) + "\n";
  }
  block += fmt::format("![Fetches against penumbra error]({})\n", chart_path);
  block += "\n<details><summary>Penumbra RMSE of every scene</summary>\n";
  for (const double light : light_sizes(results)) {
    block += fmt::format("\n{} light\n\n", light_name(light)) + scene_table(results, light);
  }
  return block + "\n</details>\n";
}

std::string replace_result_block(const std::string& text, const std::string& block, const std::string& name) {
  return replace_block(text, kResultBlock, block, name);
}

}  // namespace penumbra::study
