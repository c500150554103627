// A small study made up by formula: enough of every kind of content to try reports, charts and tables on.
#pragma once

#include <string>
#include <vector>

#include "study/report.h"
#include "study/results.h"

namespace penumbra::study::synthetic {

// The results have two scenes, the given techniques and lights of 0.53 and 2 degrees, on a software device.
// Errors fall and fetches rise from each technique to the next.
Results results(const std::vector<std::string>& techniques);
Results results();

// The images show an edge with a 16-pixel penumbra, 48 x 24, made visible through the real colour maps. The
// technique's own edge is 4 pixels wide (bilinear) or 8, from pixel 20 on.
PictureRow picture_row(const std::string& scene, const std::string& technique);

// The content is results() with both charts and the pictures of two techniques in both scenes at 2 degrees.
ReportContent report_content();

}  // namespace penumbra::study::synthetic
