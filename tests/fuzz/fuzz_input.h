// Every fuzz target does this with its bytes: it reads them, and holds the answer against what the header
// promises.
//
// A target fails by a sanitizer's message, by an exception that is no answer, or by require().
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "input/input_error.h"

namespace penumbra::fuzz {

// Takes the first byte away and returns it; 0 when there is none.
inline std::uint8_t take_byte(std::string_view& bytes) {
  if (bytes.empty()) return 0;
  const auto first = static_cast<std::uint8_t>(bytes.front());
  bytes.remove_prefix(1);
  return first;
}

// Reports a finding when the condition does not hold; `claim` says what should have.
inline void require(bool holds, const char* claim) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", claim);
  std::abort();
}

// Requires text for a terminal or a CI system: newlines and tabs are its only control characters.
inline void require_harmless(std::string_view text) {
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    require((byte >= 0x20 || c == '\n' || c == '\t') && byte != 0x7F, "no control character in a message");
  }
}

// Runs the reader; an InputError or an EnvironmentError is an answer, if its message may be shown.
template <typename Reads>
void read(const Reads& reads) {
  try {
    reads();
  } catch (const InputError& error) {
    require(*error.what() != '\0', "an error says what is wrong");
    require_harmless(error.what());
    require(std::string_view(error.what()).size() < 64'000, "a message is short");
  } catch (const EnvironmentError& error) {
    require(*error.what() != '\0', "an error says what is missing");
  }
}

// A folder of this process, for readers that take files. It is gone when the process ends.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  // Writes the file and returns its path. It makes the file's folders; `name` may have some.
  std::filesystem::path write(const std::string& name, std::string_view content) const;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace penumbra::fuzz
