// Serialised scenes, between the process that reads a model and the one that uses it. The data is not
// trusted: a malicious model may have compromised that process. Internal to this folder, except for tests.
#pragma once

#include <string>
#include <string_view>

#include "platform/byte_stream.h"
#include "scene/image_file.h"
#include "scene/scene.h"

namespace penumbra::scene {

void write(platform::ByteWriter& out, const ImportOptions& options);  // all options but the process
ImportOptions read_import_options(platform::ByteReader& in);

std::string encode(const Texture& texture);
std::string encode(const Scene& scene);
std::string encode(const HeightImage& image);

// Throw std::invalid_argument for damaged data, or values that no import produces: indices, materials and
// textures out of range, numbers that are not finite, inconsistent sizes.
Texture decode_texture(std::string_view bytes);
Scene decode_scene(std::string_view bytes);
HeightImage decode_heights(std::string_view bytes);

}  // namespace penumbra::scene
