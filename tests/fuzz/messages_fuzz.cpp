// Makes messages that hold texts of untrusted files.
#include <algorithm>
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "input/nearest_name.h"
#include "input/visible_text.h"

namespace penumbra::fuzz {

void targets::messages(std::string_view bytes) {
  const std::string text(bytes);
  const std::string shown = visible(text);
  require_harmless(shown);
  require(shown.find('\n') == std::string::npos, "a visible name is one line");
  require_harmless(visible_line(text));
  require_harmless(visible_lines(text));
  unknown_name_remedy(text, {"Texture2D", "SamplerState", "fov_y_degrees"});
}

}  // namespace penumbra::fuzz
