// Definitions of the report's figures: its reference sections.
#pragma once

#include <string>

namespace penumbra::study {

std::string reference_definitions_html();
std::string metric_definitions_html();

}  // namespace penumbra::study
