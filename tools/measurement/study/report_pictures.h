// The report's picture viewer: its controls, and the pictures as numbers that its script colours.
#pragma once

#include <string>
#include <vector>

#include "study/report.h"

namespace penumbra::study {

// Pictures are grey PNGs in base64, one byte a pixel: visibility in 255ths, or fetches. Reference and
// receivers stand once per scene and light; the browser computes the error. Without pictures the text says
// how to get some.
std::string pictures_html(const Results& results, const std::vector<PictureRow>& pictures);

}  // namespace penumbra::study
