#include "input/text_file.h"

#include <fstream>
#include <iterator>

#include "input/input_error.h"

namespace penumbra {

std::string read_text_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string(), "cannot be opened");
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace penumbra
