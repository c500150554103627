// A record's four pictures as one: reference, result, signed error, fetches, with captions and legends.
#pragma once

#include <string>
#include <vector>

#include "study/picture.h"
#include "study/report.h"
#include "study/results.h"

namespace penumbra::study {

// `title` is the technique's name in the captions.
Picture side_by_side(const PictureRow& row, const std::string& title);

// Returns "<scene>_<technique>_<degrees>", as file_name_part() of input/file_name.h writes it.
std::string file_stem(const PictureRow& row);

// The picture that a README shows: one row per scene of the technique with the lowest mean error, at the
// light nearest 2 degrees. Scenes whose pictures have another size than the first one's are left out. The
// picture is empty (no samples) without a record.
Picture overview(const Results& results, const std::vector<PictureRow>& pictures, std::size_t most_scenes);

}  // namespace penumbra::study
