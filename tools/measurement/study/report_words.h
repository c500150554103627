// What the figures of a report mean, in words: the sections a reader looks things up in.
#pragma once

#include <string>

namespace penumbra::study {

std::string reference_definitions_html();
std::string metric_definitions_html();

}  // namespace penumbra::study
