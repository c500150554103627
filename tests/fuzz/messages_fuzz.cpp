// Pages and messages that hold texts of untrusted files.
#include <algorithm>
#include "fuzz/fuzz_input.h"
#include "input/markdown.h"
#include "input/nearest_name.h"
#include "input/visible_text.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penumbra;
  const std::string text(fuzz::text_of(data, size));
  const std::string shown = visible(text);
  fuzz::require_harmless(shown);
  fuzz::require(shown.find('\n') == std::string::npos, "a visible name is one line");
  fuzz::require_harmless(visible_line(text));
  fuzz::require_harmless(visible_lines(text));
  const std::string cell = markdown_cell(text), code = markdown_code(text);
  fuzz::require(cell.find('\n') == std::string::npos && code.find('\n') == std::string::npos,
                "a cell is one line");
  fuzz::require(markdown_code_block("hlsl", text).find("<!--") == std::string::npos,
                "no comment begins in code");
  fuzz::read([&] {
    const std::string once = replace_block(text, "a", "b\n", "page.md");
    fuzz::require(replace_block(once, "a", "b\n", "page.md") == once, "a block is replaced in place");
  });
  unknown_name_way_out(text, {"Texture2D", "SamplerState", "fov_y_degrees"});
  return 0;
}
