#include "project/editor_version.h"

#include <array>
#include <charconv>

namespace penumbra::project {

std::optional<EditorVersion> parse_editor_version(std::string_view text) {
  std::array<int, 3> numbers{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) {
      if (rest.empty() || rest.front() != '.') return std::nullopt;
      rest.remove_prefix(1);
    }
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), numbers[i]);
    if (error != std::errc() || numbers[i] < 0 || numbers[i] > 9999) return std::nullopt;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  }
  return EditorVersion{numbers[0], numbers[1], numbers[2], std::string(text)};
}

int unity_version_number(const EditorVersion& version) {
  if (version.major >= 6000)
    return version.major / 1000 * 10'000'000 + version.minor * 10'000 + version.patch;
  return version.major * 100 + version.minor * 10 + version.patch;
}

}  // namespace penumbra::project
