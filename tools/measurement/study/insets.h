// Parts of a picture enlarged beneath it, each framed in the colour of the frame that marks its place.
#pragma once

#include <vector>

#include "study/picture.h"

namespace penumbra::study {

// Returns the picture, every pixel as zoom x zoom, its windows marked. Beneath it, in their order, are the
// windows themselves, all enlarged by the same whole number, the largest with which they fit side by side. No
// pixel of a window is covered by a frame beneath. Windows are in pixels of the picture. Throws
// std::invalid_argument for a window beyond the picture, and for windows too wide to stand side by side.
Picture with_insets(const Picture& picture, int zoom, const std::vector<PictureWindow>& windows);

// Returns the number by which the windows are enlarged beneath a picture of this width; 0 if they do not fit.
int inset_factor(int width, const std::vector<PictureWindow>& windows);

}  // namespace penumbra::study
