// Mistakes of this program, such as a value that is missing in a map, are reported with what it worked on.
#pragma once

#include <stdexcept>
#include <string>

namespace penumbra {

// Calls `work`; a std::logic_error of it gets `place`, a file for example, before its message.
template <typename Work>
auto with_place(const std::string& place, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::logic_error& mistake) {
    throw std::logic_error(place + ": " + mistake.what());
  }
}

}  // namespace penumbra
