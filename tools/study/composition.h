// Pictures set side by side under captions, as one picture: for a README and for `penumbra render`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/picture.h"

namespace penumbra::study {

struct Legend {
  Picture strip;     // of one ramp (ramp_strip)
  std::string from;  // text at its left end
  std::string to;    // and at its right
};

struct CaptionedPicture {
  std::string caption;  // lines of text; a legend stands in the last line of the longest caption
  Picture picture;      // RGB; all of one size
  std::optional<Legend> legend;
};

// Rows of at most `columns` pictures, dark text on white, each caption above its picture and cut to its
// width, or to `least_width` pixels where that is more. Characters outside printable ASCII are drawn as '?'.
// Throws std::invalid_argument without a picture or when sizes differ.
Picture compose(const std::vector<CaptionedPicture>& pictures, int columns, int least_width = 0);

// Pixels that the longest line of a caption takes.
int caption_width(const std::string& caption);

}  // namespace penumbra::study
