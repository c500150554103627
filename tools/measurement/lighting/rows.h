// Runs the rows of a picture on all threads, with progress, ended by Ctrl-C.
#pragma once

#include <functional>

#include "reference/row_blocks.h"

namespace penumbra::lighting {

// Calls row(0) .. row(height - 1), each once, in any order and from several threads; progress counts rows.
// Throws platform::Interrupted when cancelled, and whatever row throws.
void for_each_row(int height, const reference::RunOptions& run, const std::function<void(int)>& row);

}  // namespace penumbra::lighting
