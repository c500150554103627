// Reads expanded HLSL: declarations, what an entry point reaches, brackets left open, a compiler's log about
// it and what is taken out around its errors.
#include <algorithm>
#include <numeric>
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "hlsl/declarations.h"
#include "hlsl/expanded_text.h"
#include "hlsl/reach.h"
#include "hlsl/token_place.h"
#include "shaders/parse_failure.h"

namespace penumbra::fuzz {

namespace {

void check_declarations(const std::string& text) {
  const std::vector<hlsl::Token> tokens = hlsl::lex(text);
  for (const hlsl::Declaration& declaration : hlsl::read_declarations(tokens)) {
    require(declaration.first <= declaration.last && declaration.last < tokens.size(), "tokens of the text");
    if (declaration.parameters_open != hlsl::Declaration::none) hlsl::parameter_types(tokens, declaration);
  }
}

void reach(const std::string& text) {
  const hlsl::Reach reached(text, "main.hlsl", "Main");
  std::vector<std::size_t> all(reached.unreached().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto lines = [](const std::string& t) { return std::count(t.begin(), t.end(), '\n'); };
  require(lines(reached.text_with({})) == lines(text), "what is left out leaves its lines");
  require(reached.text_with(all) == text, "with all of it nothing is left out");
  const std::string dense = hlsl::dense_lines(reached.text_with({}));
  require(hlsl::dense_lines(dense) == dense, "dense lines have nothing more to lose");
}

void place_tokens(const std::string& text, const hlsl::SourceFiles& sources) {
  const hlsl::TokenPlaces places(text, "main.hlsl");
  places.one_per_line();
  for (std::size_t i = 0; i < std::min<std::size_t>(places.size(), 16); ++i) {
    places.at(i, sources);
    places.after(i, sources);
    places.function(places[i].spelling);
  }
}

// Takes the text as a compiler's log of itself: its lines that begin like errors are errors of its tokens.
void place_errors(const std::string& text, const hlsl::SourceFiles& sources) {
  const auto log_of = [&](const std::string&) { return text; };
  const shaders::ParseFailure failure{text, "main.hlsl", text, log_of};
  require_harmless(hlsl::format(shaders::first_error(failure, sources)));
  const std::string entry = "Main";
  const hlsl::TokenPlace nowhere{"main.hlsl", 0, 0};
  require_harmless(hlsl::format(shaders::link_error(failure, {entry, nowhere}, sources)));
  for (const hlsl::Diagnostic& warning : shaders::warnings(text, sources))
    require_harmless(hlsl::format(warning));
}

}  // namespace

void targets::expanded_text(std::string_view bytes) {
  const std::string text(bytes);
  hlsl::SourceFiles sources;
  sources.add("main.hlsl", text);
  check_declarations(text);
  reach(text);
  place_tokens(text, sources);
  place_errors(text, sources);
  hlsl::expanded_lines(text, "main.hlsl");
}

}  // namespace penumbra::fuzz
