// The preparation of preprocessed HLSL: all passes, and each alone (the first byte says which).
#include "fuzz/fuzz_input.h"
#include "hlsl/tokens.h"
#include "preparation/prepare.h"
#include "preparation/token_text.h"

namespace {

using namespace penumbra;

// Printing a text that no pass has touched gives the same tokens on the same lines.
void print_untouched(const std::string& text) {
  const preparation::TokenText untouched(text, "main.hlsl");
  const std::string printed = untouched.print();
  const std::vector<hlsl::Token> tokens = hlsl::lex(printed);
  fuzz::require(tokens.size() == untouched.size(), "printing keeps every token");
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    fuzz::require(tokens[i].spelling == untouched[i].spelling, "printing keeps spellings");
    fuzz::require(tokens[i].line == untouched[i].line, "printing keeps lines");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(fuzz::text_of(data + 1, size - 1));
  const std::span<const preparation::Pass> passes = preparation::passes();
  const std::size_t chosen = data[0];
  if (chosen < passes.size()) {
    preparation::TokenText one(text, "main.hlsl");
    passes[chosen].run(one);
    one.print();
  } else if (chosen == passes.size()) {
    print_untouched(text);
  } else {
    for (const hlsl::Diagnostic& note : preparation::prepare(text, "main.hlsl").notes)
      fuzz::require_harmless(hlsl::format(note));
  }
  return 0;
}
