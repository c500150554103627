// A contact sheet: the ray-traced reference and the result of each subject, side by side, each with its name,
// error and cost.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "study/picture.h"
#include "study/report.h"
#include "study/results.h"

namespace penumbra::study {

enum class SheetPicture { result, error, fetches, mask, debug_view };

struct SheetChoice {
  SheetChoice(SheetPicture picture, std::string debug_view = {})
      : kind(picture), view(std::move(debug_view)) {}

  SheetPicture kind;
  std::string view;  // the debug view, by its pass

  bool operator==(const SheetChoice&) const = default;
};

struct SheetOptions {
  std::optional<PictureWindow> window{};  // the part shown of every picture; absent means all
  // Parts shown enlarged beneath every picture, in pixels of the whole picture and inside of the window.
  std::vector<PictureWindow> insets{};
  bool reference_last = false;  // else the ray-traced picture comes before the techniques
  int zoom = 1;                 // pixels of the sheet per pixel shown, each way
  int columns = 0;              // 0: a scene and light take a row, of at most four pictures
  // The pictures of each subject; a mask and debug views appear only where there are some.
  std::vector<SheetChoice> pictures{SheetPicture::result};
};

// The sheet has, per scene and light, the ray-traced reference, then the subjects. `records` and `rows` are
// those of one study, in its order; a record's title names its pictures, and its figures are the caption's.
// Captions stay within their cells: long lines are broken. Throws std::invalid_argument if they are
// inconsistent, for a window or an inset beyond the pictures, and for insets that do not fit side by side
// beneath one.
Picture contact_sheet(const std::vector<Record>& records, const std::vector<PictureRow>& rows,
                      const SheetOptions& options);

// Returns the record's four pictures as one sheet: reference, result, error and fetches.
Picture record_sheet(const Record& record, const PictureRow& row);

// Returns "<scene>_<technique>_<degrees>", as file_name_part() of input/file_name.h writes it.
std::string file_stem(const PictureRow& row);

// Returns the picture, every pixel as zoom x zoom, its windows marked. Beneath it, in their order, are the
// windows themselves, all enlarged by the same whole number, the largest with which they fit side by side. No
// pixel of a window is covered by a frame beneath. Windows are in pixels of the picture. Throws
// std::invalid_argument for a window beyond the picture, and for windows too wide to stand side by side.
Picture with_insets(const Picture& picture, int zoom, const std::vector<PictureWindow>& windows);

// Returns the number by which the windows are enlarged beneath a picture of this width; 0 if they do not fit.
int inset_factor(int width, const std::vector<PictureWindow>& windows);

}  // namespace penumbra::study
