#include "input/file_name.h"

#include <algorithm>

namespace penumbra {

std::string file_name_part(std::string name, std::size_t longest) {
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '_' || c == '.';
    if (!plain) c = '-';
  }
  return name.substr(0, std::min(name.size(), longest));
}

}  // namespace penumbra
