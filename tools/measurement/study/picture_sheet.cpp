#include "study/picture_sheet.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "input/file_name.h"
#include "study/colour_map.h"
#include "study/composition.h"
#include "study/summary.h"

namespace penumbra::study {
namespace {

constexpr int kCaptionWidth = 440;  // pixels that a caption and its legend need

std::vector<CaptionedPicture> captioned(const PictureRow& row, const std::string& title) {
  const Picture reference = row.reference;
  const int factor = (kCaptionWidth + reference.width - 1) / reference.width;
  const std::string scene = fmt::format("Ray traced\n{}, light of {}°", row.scene, row.light_degrees);
  return {
      {scene, enlarged(reference, factor), Legend{ramp_strip(visibility_colour, 0.0, 1.0), "0", "1"}},
      {title + "\nresult", enlarged(row.result, factor),
       Legend{ramp_strip(visibility_colour, 0.0, 1.0), "0", "1"}},
      {title + "\nerror", enlarged(row.error, factor),
       Legend{ramp_strip(error_colour, -1.0, 1.0), fmt::format("-{} dark", row.error_scale),
              fmt::format("+{} bright", row.error_scale)}},
      {title + "\nfetches", enlarged(row.fetches, factor),
       Legend{ramp_strip(fetch_colour, 0.0, 1.0), "0", fmt::format("{}", row.fetch_scale)}},
  };
}

Choice best_technique(const Results& results) {
  double lowest = std::numeric_limits<double>::infinity();
  Choice best;
  const std::vector<SummaryLine> summary = summarise(results);
  for (const Choice& choice : choices(results)) {
    double sum = 0.0;
    int lines = 0;
    for (const SummaryLine& line : summary) {
      if (!(line.choice == choice) || !line.rmse_penumbra) continue;
      sum += line.rmse_penumbra->value;
      ++lines;
    }
    if (lines > 0 && sum / lines < lowest) {
      lowest = sum / lines;
      best = choice;
    }
  }
  return best;
}

double light_nearest(const Results& results, double degrees) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const double light : light_sizes(results)) {
    if (std::abs(light - degrees) < std::abs(nearest - degrees)) nearest = light;
  }
  return nearest;
}

bool same_size(const Picture& a, const Picture& b) {
  return a.width == b.width && a.height == b.height;
}

}  // namespace

Picture side_by_side(const PictureRow& row, const std::string& title) {
  return compose(captioned(row, title), 2);
}

std::string file_stem(const PictureRow& row) {
  return file_name_part(fmt::format("{}_{}_{}", row.scene, row.technique, row.light_degrees));
}

Picture overview(const Results& results, const std::vector<PictureRow>& pictures, std::size_t most_scenes) {
  const Choice best = best_technique(results);
  const double degrees = light_nearest(results, 2.0);
  std::vector<CaptionedPicture> rows;
  for (const PictureRow& row : pictures) {
    if (row.technique != best.technique || row.light_degrees != degrees || rows.size() >= 4 * most_scenes)
      continue;
    std::vector<CaptionedPicture> captioned_row = captioned(row, short_title(best.technique, best.title));
    if (!rows.empty() && !same_size(rows.front().picture, captioned_row.front().picture)) continue;
    for (CaptionedPicture& picture : captioned_row) rows.push_back(std::move(picture));
  }
  return rows.empty() ? Picture{} : compose(rows, 4);
}

}  // namespace penumbra::study
