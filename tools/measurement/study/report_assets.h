// The style, the script and the definitions that report.html carries: the files of
// tools/measurement/study/report.
#pragma once

#include <string_view>

namespace penumbra::study {

extern const std::string_view kReportStyle;
extern const std::string_view kReportScript;
extern const std::string_view kReferenceWords;
extern const std::string_view kMetricWords;

}  // namespace penumbra::study
