// Reads HLSL before the preprocessor: what is rewritten there moves no character.
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "hlsl/source_text.h"
#include "preparation/source_directives.h"

namespace penumbra::fuzz {

void targets::source_text(std::string_view bytes) {
  const std::string text = hlsl::normalise_source(bytes);
  require(hlsl::normalise_source(text) == text || text.starts_with("\xEF\xBB\xBF"), "normal text is normal");
  const std::string prepared = preparation::prepare_source(text);
  require(prepared.size() == text.size(), "directives keep the length");
  for (std::size_t i = 0; i < text.size(); ++i)
    require((text[i] == '\n') == (prepared[i] == '\n'), "directives keep every newline");
}

}  // namespace penumbra::fuzz
