#include "study/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "study/colour_map.h"
#include "study/composition.h"
#include "study/insets.h"

namespace penumbra::study {
namespace {

constexpr int kMostColumns = 4;
constexpr int kLeastWidth = 240;  // pixels that a legend needs

std::string reference_caption(const Record& record) {
  return fmt::format("Ray traced\n{}, light of {}°", record.scene, record.light_degrees);
}

std::string figures(const Metrics& metrics) {
  std::string error =
      metrics.rmse_penumbra ? fmt::format("penumbra error {:.3f}", *metrics.rmse_penumbra) : "no penumbra";
  if (!metrics.fetches_mean) return error;
  return fmt::format("{}, {:.1f} fetches", error,
                     *metrics.fetches_mean + metrics.preprocess_fetches_per_pixel);
}

std::string mask_figures(const Metrics& metrics) {
  if (!metrics.mask) return "mask";
  return fmt::format("mask: skips {:.1f} %, misses {:.1f} %", 100.0 * metrics.mask->pixels_saved,
                     100.0 * metrics.mask->penumbra_pixels_missed.value_or(0.0));
}

std::optional<CaptionedPicture> mask_cell(const Record& record, const PictureRow& row) {
  if (row.mask.samples.empty()) return std::nullopt;
  return CaptionedPicture{record.title + "\n" + mask_figures(record.metrics), row.mask, {}};
}

std::optional<CaptionedPicture> view_cell(const std::string& view, const Record& record,
                                          const PictureRow& row) {
  const auto found = row.debug_views.find(view);
  if (found == row.debug_views.end()) return std::nullopt;
  return CaptionedPicture{record.title + "\n" + view, found->second, {}};
}

std::optional<CaptionedPicture> cell(const SheetChoice& choice, const Record& record, const PictureRow& row) {
  switch (choice.kind) {
    case SheetPicture::result:
      return CaptionedPicture{record.title + "\n" + figures(record.metrics), row.result, {}};
    case SheetPicture::error:
      return CaptionedPicture{record.title + "\nerror", row.error,
                              Legend{ramp_strip(error_colour, -1.0, 1.0), fmt::format("-{}", row.error_scale),
                                     fmt::format("+{}", row.error_scale)}};
    case SheetPicture::fetches:
      return CaptionedPicture{
          record.title + "\nfetches", row.fetches,
          Legend{ramp_strip(fetch_colour, 0.0, 1.0), "0", fmt::format("{}", row.fetch_scale)}};
    case SheetPicture::mask:
      return mask_cell(record, row);
    case SheetPicture::debug_view:
      return view_cell(choice.view, record, row);
  }
  return std::nullopt;
}

bool of_one_frame(const Record& a, const Record& b) {
  return a.scene == b.scene && a.light_degrees == b.light_degrees;
}

struct Cells {
  std::vector<CaptionedPicture> all;
  std::size_t of_the_first_frame = 0;
};

Cells cells_of(const std::vector<Record>& records, const std::vector<PictureRow>& rows,
               const SheetOptions& options) {
  Cells cells;
  const auto add_reference = [&](std::size_t i) {
    cells.all.push_back({reference_caption(records[i]), rows[i].reference, {}});
  };
  for (std::size_t i = 0; i < records.size(); ++i) {
    const bool first = i == 0 || !of_one_frame(records[i - 1], records[i]);
    const bool last = i + 1 == records.size() || !of_one_frame(records[i], records[i + 1]);
    if (first && !options.reference_last) add_reference(i);
    for (const SheetChoice& choice : options.pictures) {
      if (auto shown = cell(choice, records[i], rows[i])) cells.all.push_back(*std::move(shown));
    }
    if (last && options.reference_last) add_reference(i);
    if (of_one_frame(records[0], records[i])) cells.of_the_first_frame = cells.all.size();
  }
  return cells;
}

// Wide sheets are shown small: their letters grow with them, so that they stay legible on a page.
int text_size(int sheet_width) {
  constexpr int kLettersPerSheet = 60;
  return std::clamp(sheet_width / kLettersPerSheet, kTextSize, 3 * kTextSize);
}

int least_width(const std::vector<CaptionedPicture>& cells, int text) {
  int width = kLeastWidth;
  for (const CaptionedPicture& cell : cells) width = std::max(width, caption_width(cell.caption, text));
  return width;
}

// The part that is shown, zoomed, and its insets.
Picture shown(const Picture& picture, const SheetOptions& options) {
  const PictureWindow window = options.window.value_or(PictureWindow{0, 0, picture.width, picture.height});
  std::vector<PictureWindow> insets = options.insets;
  for (PictureWindow& inset : insets) {
    inset.x -= window.x;
    inset.y -= window.y;
  }
  return with_insets(cropped(picture, window), options.zoom, insets);
}

}  // namespace

Picture contact_sheet(const std::vector<Record>& records, const std::vector<PictureRow>& rows,
                      const SheetOptions& options) {
  if (records.empty() || records.size() != rows.size()) {
    throw std::invalid_argument("a sheet needs a picture of every record");
  }
  Cells cells = cells_of(records, rows, options);
  for (CaptionedPicture& cell : cells.all) cell.picture = shown(cell.picture, options);
  const int columns = options.columns > 0
                          ? options.columns
                          : std::min(static_cast<int>(cells.of_the_first_frame), kMostColumns);
  const int beside = std::min(columns, static_cast<int>(cells.all.size()));
  const int text = text_size(beside * cells.all.front().picture.width);
  return compose(cells.all, columns, least_width(cells.all, text), text);
}

}  // namespace penumbra::study
