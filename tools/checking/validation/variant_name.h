// A variant by the name that reports give it, so that one of many can be examined.
#pragma once

#include <string>

#include "validation/shader_sources.h"

namespace penumbra::validation {

// Parts that are empty match any.
struct VariantName {
  std::string pass;
  std::string entry;
  variants::Keywords keywords;
};

// Parses "PASS/ENTRY: KEYWORD KEYWORD", of which "PASS/" and ": KEYWORD..." may be missing.
VariantName parse_variant_name(const std::string& text);

// Returns the one entry point of that name with those keywords, for the graphics API that "spirv" is made for
// if that is among the platforms. Throws InputError when there is none or there are several, and for a
// keyword that the program's pragmas do not declare.
CompileUnit find_variant(const ShaderSources& sources, const VariantName& name);

}  // namespace penumbra::validation
