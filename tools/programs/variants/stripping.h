// The keywords and settings that a project uses, so that only those variants are compiled.
//
// A stripping file is JSON; every key is optional:
//   {
//     "keywords":       {"DEBUG_DISPLAY": "never", "_NORMALMAP": "always", "FOG_EXP2": "both"},
//     "urp":            {"main_light_shadows": true, "fog": ["exp2"], ...},      see urp_settings.h
//     "shader_feature": "used",                          or "all": every combination, the default
//     "materials":      [["_NORMALMAP"], ["_NORMALMAP", "_EMISSION"], []]
//   }
// "materials" lists the keywords each material has on (a .mat file's m_ValidKeywords) and means "used"; with
// it the shader_feature sets of a program have one combination for each distinct material: of every set the
// first alternative the material has on, else the empty keyword. "used" without materials keeps the one with
// all off.
//
// "urp" also leaves out the passes that no such project draws (urp_settings.h: unused_passes()). "both" in
// "keywords" overrides what "urp" says about that keyword.
#pragma once

#include <filesystem>
#include <string_view>

#include "variants/keyword_space.h"
#include "variants/urp_settings.h"

namespace penumbra::variants {

// Throw InputError with the location of the error; for unknown keys with the nearest known one.
Narrowing read_stripping(const std::filesystem::path& file);
Narrowing parse_stripping(std::string_view text, const std::string& name);

}  // namespace penumbra::variants
