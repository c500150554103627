// The style and the script that report.html carries: the files of tools/measurement/study/report, one after
// the other.
#pragma once

#include <string_view>

namespace penumbra::study {

extern const std::string_view kReportStyle;
extern const std::string_view kReportScript;

}  // namespace penumbra::study
