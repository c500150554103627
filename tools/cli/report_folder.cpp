#include "cli/report_folder.h"

#include <fmt/format.h>

#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "cli/study_options.h"
#include "cli/subcommand.h"
#include "input/input_error.h"
#include "input/visible_text.h"
#include "platform/atomic_file.h"
#include "study/picture_sheet.h"
#include "study/report.h"
#include "study/short_title.h"
#include "study/summary.h"

namespace penumbra::cli {
namespace {

// The charts, pages and pictures that an earlier run drew in this folder show other results.
void remove_earlier_report(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> drawn{folder / "report.html", folder / "overview.png"};
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().filename().string().starts_with("pareto-") && entry.path().extension() == ".svg")
      drawn.push_back(entry.path());
  for (const auto& entry : std::filesystem::directory_iterator(folder / "pictures", ignored))
    if (entry.path().extension() == ".png") drawn.push_back(entry.path());
  for (const std::filesystem::path& file : drawn)
    if (std::filesystem::is_regular_file(file, ignored)) std::filesystem::remove(file, ignored);
}

}  // namespace

void check_report_files(const std::filesystem::path& folder) {
  static const std::set<std::string> kEndings{".json", ".tsv", ".html", ".svg", ".png"};
  std::error_code absent;
  for (const auto& entry : std::filesystem::directory_iterator(folder, absent)) {
    std::error_code ignored;
    const bool is_ours =
        entry.path().filename() == "pictures" ? entry.is_directory(ignored) : entry.is_regular_file(ignored);
    if (is_ours || (entry.path().filename() != "pictures" && kEndings.count(entry.path().extension()) == 0))
      continue;
    throw InputError(entry.path().string(),
                     entry.path().filename() == "pictures"
                         ? "is in the place of a folder of the report"
                         : "is a folder, a pipe or a device in the place of a file of the report",
                     "remove it, or choose another folder with --output");
  }
  const std::filesystem::path pictures = folder / "pictures";
  if (std::filesystem::is_directory(pictures, absent))
    platform::check_folder_can_be_written(pictures, pictures);
}

void write_report(const std::filesystem::path& folder, const study::Results& results,
                  std::vector<study::PictureRow> pictures, study::FactsOfTechniques facts) {
  make_folder(folder);
  const std::string json = study::to_json(results);
  const std::string table = study::to_table(results);
  platform::write_files_atomically({{folder / "results.json", json}, {folder / "results.tsv", table}});
  remove_earlier_report(folder);
  study::ReportContent content;
  content.results = results;
  content.charts = study::report_charts(results);
  content.pictures = std::move(pictures);
  content.facts = std::move(facts);
  if (!content.pictures.empty()) make_folder(folder / "pictures");
  for (std::size_t i = 0; i < content.pictures.size(); ++i) {
    const study::PictureRow& row = content.pictures[i];
    const study::Record& record = results.records[i];
    write_picture(folder / "pictures" / (study::file_stem(row) + ".png"),
                  study::side_by_side(row, study::short_title(record.technique, record.title)));
  }
  const study::Picture overview = study::overview(results, content.pictures, 4);
  if (!overview.samples.empty()) write_picture(folder / "overview.png", overview);
  const std::string page = study::render_report(content);
  std::vector<std::string> charts;
  for (const study::ReportChart& chart : content.charts) charts.push_back(study::render_svg(chart.chart));
  std::vector<platform::FileContent> drawn;
  for (std::size_t i = 0; i < charts.size(); ++i)
    drawn.push_back({folder / (content.charts[i].chart.name + ".svg"), charts[i]});
  drawn.push_back({folder / "report.html", page});
  platform::write_files_atomically(drawn);
}

void print_headlines(const std::filesystem::path& folder, const study::Results& results) {
  std::string text;
  for (const study::Headline& headline : study::headlines(results)) {
    text += fmt::format("{:>8}  {} ({})\n", headline.value, headline.name, visible(headline.detail));
  }
  text += fmt::format("report: {}\n",
                      std::filesystem::absolute(folder / "report.html").lexically_normal().string());
  write_output("", text);
}

}  // namespace penumbra::cli
