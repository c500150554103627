// Reads HLSL before the preprocessor: what is blanked, dropped and rewritten there moves no line.
#include <algorithm>
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "hlsl/source_text.h"
#include "preparation/bare_source.h"
#include "preparation/macro_arguments.h"
#include "preparation/source_directives.h"

namespace penumbra::fuzz {

namespace {

std::ptrdiff_t lines(std::string_view text) {
  return std::count(text.begin(), text.end(), '\n');
}

void rewrite_macro_calls(const std::string& text) {
  preparation::MacroArguments macros;
  macros.read(text);
  for (const char* name : {"A", "B", "SAMPLE"}) macros.spread(name);
  for (int round = 0; round < 16 && macros.settle(); ++round) {
  }
  macros.definitions();
  require(lines(macros.rewritten(text)) == lines(text), "macro calls keep their lines");
}

}  // namespace

void targets::source_text(std::string_view bytes) {
  const std::string text = hlsl::normalise_source(bytes);
  require(hlsl::normalise_source(text) == text || text.starts_with("\xEF\xBB\xBF"), "normal text is normal");
  const std::string bare = preparation::bare_source(text);
  require(lines(bare) == lines(text), "dropping comments keeps lines");
  preparation::include_guard(bare);
  preparation::undefined_macros(bare);
  const std::string prepared = preparation::prepare_source(text).text;
  require(prepared.size() == text.size(), "directives keep the length");
  for (std::size_t i = 0; i < text.size(); ++i)
    require((text[i] == '\n') == (prepared[i] == '\n'), "directives keep every newline");
  rewrite_macro_calls(text);
}

}  // namespace penumbra::fuzz
