// Makes pages and messages that hold texts of untrusted files.
#include <algorithm>
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "input/markdown.h"
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
  const std::string cell = markdown_cell(text), code = markdown_code(text);
  require(cell.find('\n') == std::string::npos && code.find('\n') == std::string::npos, "a cell is one line");
  require(markdown_code_block("hlsl", text).find("<!--") == std::string::npos, "no comment begins in code");
  read([&] {
    const std::string once = replace_block(text, "a", "b\n", "page.md");
    require(replace_block(once, "a", "b\n", "page.md") == once, "a block is replaced in place");
  });
  unknown_name_remedy(text, {"Texture2D", "SamplerState", "fov_y_degrees"});
}

}  // namespace penumbra::fuzz
