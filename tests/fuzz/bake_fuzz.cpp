// Reads the JSON file of a height field, beside a picture of which it has the hash.
#include "bake/height_file.h"
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"

namespace penumbra::fuzz {

void targets::bake(std::string_view bytes) {
  static const ScratchFolder folder;
  // The text is that of seeds.py.
  static const std::filesystem::path picture = folder.write("field.png", "picture");
  const std::filesystem::path file = folder.write("field.json", bytes);
  read([&] {
    const bake::HeightFile read = bake::read_height_file(file);
    require(read.picture == picture, "only a picture that the file has the hash of is taken");
    require(!read.holes_at.empty(), "a place for a message about them");
  });
}

}  // namespace penumbra::fuzz
