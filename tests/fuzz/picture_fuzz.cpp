// Pictures: the textures of models and adapters.
#include <span>
#include "fuzz/fuzz_input.h"
#include "scene/image_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penumbra;
  fuzz::read([&] { scene::decode_image(std::as_bytes(std::span(data, size)), "picture.png"); });
  return 0;
}
