// Parses the argument of --adapter.
#pragma once

#include <string>

#include "resolve/shadow_shader.h"

namespace penumbra::cli {

// The text is "NAME=FILE[;KEYWORD][;UNIFORM=a,b,...][;TEXTURE=picture.png][;@SETTING=value]": NAME=VALUE is a
// uniform if the value consists of numbers, else a texture. Settings are @depth-bias, @normal-bias,
// @soft-quality and @light-scale. Package roots and project are not included. Throws InputError for another
// form, for a picture that cannot be read (in that process), and for duplicates.
resolve::Adapter parse_adapter(const std::string& text, const scene::ReadingProcess& process);

}  // namespace penumbra::cli
