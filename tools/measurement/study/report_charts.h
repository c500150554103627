// The charts of a report as HTML: drawings whose points respond to the pointer and can be reached by
// keyboard.
#pragma once

#include <string>
#include <vector>

#include "study/report.h"

namespace penumbra::study {

// Returns one figure per chart, its panels beside each other. Each point is a link to the table's rows of its
// technique, with its texts in data-label and data-note.
std::string charts_html(const std::vector<ReportChart>& charts);

}  // namespace penumbra::study
