// Scenes as bytes, between the process that reads a model and the one that uses it. What comes from there is
// not believed: a model may have taken that process over. Internal to this room, but for tests.
#pragma once

#include <string>
#include <string_view>

#include "platform/byte_stream.h"
#include "scene/scene.h"

namespace penumbra::scene {

void write(platform::ByteWriter& out, const ImportOptions& options);  // all but the process
ImportOptions read_import_options(platform::ByteReader& in);

std::string encode(const Texture& texture);
std::string encode(const Scene& scene);

// Throw std::invalid_argument for bytes that are damaged, or that say what no import says: indices, materials
// and textures out of range, numbers that are not finite, sizes that do not agree.
Texture decode_texture(std::string_view bytes);
Scene decode_scene(std::string_view bytes);

}  // namespace penumbra::scene
