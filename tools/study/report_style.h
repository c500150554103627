// The style and the script report.html carries.
#pragma once

#include <string_view>

namespace penumbra::study {

extern const std::string_view kReportStyle;
extern const std::string_view kReportScript;

}  // namespace penumbra::study
