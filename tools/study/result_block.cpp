#include "study/result_block.h"

#include <fmt/format.h>

#include "input/markdown.h"
#include "study/summary.h"

namespace penumbra::study {
namespace {

std::string figure(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "–";
}

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

// One column of error per light, then fetches per pixel: the mean over lights, as taps may follow the
// penumbra.
std::string mean_table(const Results& results) {
  const std::vector<double> lights = light_sizes(results);
  const std::vector<SummaryLine> lines = summarise(results);
  std::vector<std::string> heads{"Technique"};
  for (const double light : lights) heads.push_back(light_name(light));
  for (const double light : lights) heads.push_back("fetches " + light_name(light));
  Table table(heads);
  for (const Choice& choice : choices(results)) {
    std::vector<std::string> errors;
    std::vector<std::string> fetches;
    for (const double light : lights) {
      const SummaryLine* found = nullptr;
      for (const SummaryLine& line : lines) {
        if (line.choice == choice && line.light_degrees == light) found = &line;
      }
      const bool partial = found != nullptr && !found->complete && found->rmse_penumbra;
      errors.push_back(figure(found != nullptr ? found->rmse_penumbra : std::nullopt, 3) +
                       (partial ? fmt::format(" ({} scenes)", found->scenes) : ""));
      fetches.push_back(figure(found != nullptr ? found->fetches : std::nullopt, 1));
    }
    std::vector<std::string> cells{markdown_cell(choice.label)};
    cells.insert(cells.end(), errors.begin(), errors.end());
    cells.insert(cells.end(), fetches.begin(), fetches.end());
    table.add(cells);
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
      cells.push_back(figure(record != nullptr ? record->metrics.rmse_penumbra : std::nullopt, 3));
    }
    table.add(cells);
  }
  return table.text();
}

}  // namespace

std::string result_block(const Results& results, const std::string& chart_path) {
  std::string block =
      fmt::format("Hardware: {}. Device: {}. Driver: {}. Penumbra {}.  \nCommand: `{}`\n\n",
                  markdown_cell(results.hardware), markdown_cell(results.device),
                  markdown_cell(results.driver), markdown_cell(results.library_version), results.command);
  block += fmt::format(
      "Penumbra RMSE against ray tracing and texture fetches per pixel, by the light's angular diameter; "
      "mean over {} "
      "scenes.\n\n",
      scene_names(results).size());
  block += mean_table(results);
  block += fmt::format("\n![Fetches against penumbra error]({})\n", chart_path);
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
