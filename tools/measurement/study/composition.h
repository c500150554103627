// Pictures arranged side by side with captions, as one picture: for a README and for `penumbra render`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/picture.h"

namespace penumbra::study {

struct Legend {
  Picture strip;     // a strip of one ramp (ramp_strip)
  std::string from;  // text at its left end
  std::string to;    // text at its right end
};

struct CaptionedPicture {
  std::string caption;  // lines of text; a legend stands in the last one
  Picture picture;      // RGB; all of one size
  std::optional<Legend> legend;
};

inline constexpr int kTextSize = 20;   // pixels of a caption's line
inline constexpr int kPictureGap = 8;  // pixels between pictures
inline constexpr Rgb kPaper{255, 255, 255};

// Arranges rows of at most `columns` pictures, dark text on white, each caption above its picture and cut to
// its width, or to `least_width` pixels where that is more. Captions are UTF-8. Throws std::invalid_argument
// without a picture or when sizes differ, EnvironmentError without a font.
Picture compose(const std::vector<CaptionedPicture>& pictures, int columns, int least_width = 0,
                int text_size = kTextSize);

// Returns the pixels that the longest line of a caption takes.
int caption_width(const std::string& caption, int text_size = kTextSize);

// Returns the caption with lines broken after commas, or else at spaces, so that only a single word can be
// wider than this.
std::string wrapped_caption(const std::string& caption, int width, int text_size = kTextSize);

}  // namespace penumbra::study
