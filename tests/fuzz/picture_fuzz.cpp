// Reads pictures: the textures of models and adapters.
#include <span>
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "scene/image_file.h"

namespace penumbra::fuzz {

void targets::picture(std::string_view bytes) {
  read([&] { scene::decode_image(std::as_bytes(std::span(bytes)), "picture.png"); });
}

}  // namespace penumbra::fuzz
