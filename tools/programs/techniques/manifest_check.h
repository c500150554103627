// Checks a manifest against its schema. Internal to this folder.
#pragma once

#include "input/located_json.h"

namespace penumbra::techniques {

extern const std::string_view kTechniqueSchema;  // technique.schema.json, JSON Schema draft 7

// Throws InputError at the first place where the manifest is not what the schema says. The readers rely on
// what it guarantees: types, required keys, known keys and fixed choices, ranges, and lengths of lists.
void check_manifest(const LocatedJson& manifest);

}  // namespace penumbra::techniques
