// The functions with the entry point's name. Internal to this folder.
#pragma once

#include "hlsl/declarations.h"
#include "preparation/source_checks.h"
#include "preparation/token_text.h"

namespace penumbra::preparation {

// Returns them in source order, without prototypes; valid as long as the text's declarations.
std::vector<const hlsl::Declaration*> entry_functions(const TokenText& text, const EntryPoint& entry);

}  // namespace penumbra::preparation
