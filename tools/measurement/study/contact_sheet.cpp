#include "study/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "input/file_name.h"
#include "study/colour_map.h"
#include "study/composition.h"
#include "study/summary.h"

namespace penumbra::study {
namespace {

constexpr int kFrame = 4;  // pixels around an inset
constexpr int kMark = 2;   // pixels around an inset's place in the picture
Rgb frame_colour(std::size_t inset) {
  static constexpr std::array kOrder{Category::vermillion, Category::blue, Category::yellow,
                                     Category::bluish_green};
  return category_colour(kOrder[inset % kOrder.size()]);
}

void fill(Picture& picture, const PictureWindow& area, Rgb colour) {
  for (int y = std::max(area.y, 0); y < std::min(area.y + area.height, picture.height); ++y) {
    for (int x = std::max(area.x, 0); x < std::min(area.x + area.width, picture.width); ++x) {
      set_pixel(picture, x, y, colour);
    }
  }
}

// The frame lies around the window, not upon it.
void draw_frame(Picture& picture, const PictureWindow& window, int thickness, Rgb colour) {
  const int wide = window.width + 2 * thickness;
  fill(picture, {window.x - thickness, window.y - thickness, wide, thickness}, colour);
  fill(picture, {window.x - thickness, window.y + window.height, wide, thickness}, colour);
  fill(picture, {window.x - thickness, window.y, thickness, window.height}, colour);
  fill(picture, {window.x + window.width, window.y, thickness, window.height}, colour);
}

constexpr int kMostColumns = 4;
constexpr int kLeastWidth = 12;  // least width of a cell, in heights of a line, for its legend

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
  if (row.mask.empty()) return std::nullopt;
  return CaptionedPicture{record.title + "\n" + mask_figures(record.metrics), row.mask, {}};
}

// Returns the name of a pass as Unity's inspector shows it: "Penumbra Width".
std::string inspector_name(const std::string& pass) {
  std::string name;
  for (const char c : pass) {
    if (!name.empty() && c >= 'A' && c <= 'Z') name += ' ';
    name += c;
  }
  return name;
}

std::optional<CaptionedPicture> view_cell(const std::string& view, const Record& record,
                                          const PictureRow& row) {
  const auto found = row.debug_views.find(view);
  if (found == row.debug_views.end()) return std::nullopt;
  return CaptionedPicture{record.title + "\n" + inspector_name(view), found->second, {}};
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

// Wide sheets are shown scaled down: their text grows with them, so that it remains legible on a page.
int text_size(int sheet_width) {
  constexpr int kLettersPerSheet = 60;
  return std::clamp(sheet_width / kLettersPerSheet, kTextSize, 3 * kTextSize);
}

// Captions get this part of a cell's width; the rest keeps neighbours' captions apart.
int room_for_captions(int width, int text) {
  return std::max(width, kLeastWidth * text) - text / 2;
}

bool captions_fit(const std::vector<CaptionedPicture>& cells, int text) {
  const int room = room_for_captions(cells.front().picture.width, text);
  return std::all_of(cells.begin(), cells.end(),
                     [&](const CaptionedPicture& cell) { return caption_width(cell.caption, text) <= room; });
}

// A slightly smaller text is preferred to more lines.
int fitting_text_size(const std::vector<CaptionedPicture>& cells, int largest) {
  for (int text = largest; text >= std::max(kTextSize, largest * 3 / 4); --text) {
    if (captions_fit(cells, text)) return text;
  }
  return largest;
}

// Returns the part of the picture that is shown, zoomed, and its insets.
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
  const int picture_width = cells.all.front().picture.width;
  const int text = fitting_text_size(cells.all, text_size(beside * picture_width));
  int least_width = kLeastWidth * text;
  for (CaptionedPicture& cell : cells.all) {
    cell.caption = wrapped_caption(cell.caption, room_for_captions(picture_width, text), text);
    least_width = std::max(least_width, caption_width(cell.caption, text) + text / 2);
  }
  return compose(cells.all, columns, least_width, text);
}

Picture record_sheet(const Record& record, const PictureRow& row) {
  constexpr int kLeastPixels = 440;  // across, which a legend needs
  Record titled = record;
  titled.title = short_title(record.technique, record.title);
  SheetOptions options;
  const int width = Picture(row.reference).width;
  options.zoom = (kLeastPixels + width - 1) / width;
  options.columns = 2;
  options.pictures = {SheetPicture::result, SheetPicture::error, SheetPicture::fetches};
  return contact_sheet({titled}, {row}, options);
}

std::string file_stem(const PictureRow& row) {
  return file_name_part(fmt::format("{}_{}_{}", row.scene, row.technique, row.light_degrees));
}

int inset_factor(int width, const std::vector<PictureWindow>& windows) {
  const int count = static_cast<int>(windows.size());
  int sum = 0;
  for (const PictureWindow& window : windows) sum += window.width;
  return sum == 0 ? 0 : std::max(width - 2 * kFrame * count - kPictureGap * (count - 1), 0) / sum;
}

Picture with_insets(const Picture& picture, int zoom, const std::vector<PictureWindow>& windows) {
  Picture marked = enlarged(picture, zoom);
  if (windows.empty()) return marked;
  const int factor = inset_factor(marked.width, windows);
  if (factor == 0) throw std::invalid_argument("the insets do not fit beneath the picture");
  int tallest = 0;
  int rest = marked.width - kPictureGap * (static_cast<int>(windows.size()) - 1);
  for (const PictureWindow& window : windows) {
    tallest = std::max(tallest, window.height);
    rest -= window.width * factor + 2 * kFrame;
  }
  Picture canvas =
      filled_picture(marked.width, marked.height + kPictureGap + tallest * factor + 2 * kFrame, kPaper);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const PictureWindow& window = windows[i];
    draw_frame(marked, {window.x * zoom, window.y * zoom, window.width * zoom, window.height * zoom}, kMark,
               frame_colour(i));
  }
  place_picture(canvas, 0, 0, marked);
  // The remaining width is distributed between them, so that the outer ones align with the picture.
  const int between = windows.size() > 1 ? rest / (static_cast<int>(windows.size()) - 1) : 0;
  int left = windows.size() > 1 ? kFrame : kFrame + rest / 2;
  const int top = marked.height + kPictureGap + kFrame;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const Picture inset = enlarged(cropped(picture, windows[i]), factor);
    place_picture(canvas, left, top, inset);
    draw_frame(canvas, {left, top, inset.width, inset.height}, kFrame, frame_colour(i));
    left += inset.width + 2 * kFrame + kPictureGap + between;
  }
  return canvas;
}

}  // namespace penumbra::study
