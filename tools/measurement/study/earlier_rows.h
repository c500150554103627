// Records of earlier results beside new ones, for techniques that cannot or need not be measured again.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/results.h"

namespace penumbra::study {

// Throws InputError if `earlier` lacks one of the techniques, or measured it with another compiler's shaders,
// whose operations differ. `front_end` is Results::front_end of the new results.
void check_earlier_rows(const Results& earlier, const std::vector<std::string>& techniques,
                        const std::optional<std::string>& front_end, const std::filesystem::path& file);

// Appends the records of these techniques to `results`, and notes in them how they were measured. Both must
// have measured the same scenes under the same lights, with the same pictures, maps, cascades and reference:
// only then can the errors of two techniques be compared. Otherwise, or if a technique was measured again,
// throws InputError, which names `file` and the first difference.
void add_earlier_rows(Results& results, const Results& earlier, const std::vector<std::string>& techniques,
                      const std::filesystem::path& file);

}  // namespace penumbra::study
