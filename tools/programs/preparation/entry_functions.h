// The functions that an entry point's name stands for. Internal to this room.
#pragma once

#include <vector>

#include "hlsl/outline.h"
#include "preparation/source_checks.h"
#include "preparation/token_text.h"

namespace penumbra::preparation {

// In the order of the text, without prototypes; they live as long as the text's outline.
std::vector<const hlsl::Declaration*> entry_functions(const TokenText& text, const EntryPoint& entry);

}  // namespace penumbra::preparation
