// Expanded HLSL: declarations, what an entry point reaches, brackets left open, a compiler's log about it.
#include <algorithm>
#include <numeric>
#include "fuzz/fuzz_input.h"
#include "hlsl/expanded_text.h"
#include "hlsl/outline.h"
#include "hlsl/reach.h"
#include "hlsl/token_place.h"
#include "shaders/bad_character.h"
#include "shaders/parse_log.h"
#include "shaders/parse_message.h"

namespace {

using namespace penumbra;

void outline(const std::string& text) {
  const std::vector<hlsl::Token> tokens = hlsl::lex(text);
  for (const hlsl::Declaration& declaration : hlsl::outline(tokens)) {
    fuzz::require(declaration.first <= declaration.last && declaration.last < tokens.size(),
                  "tokens of the text");
    if (declaration.parameters_open != hlsl::Declaration::none) hlsl::parameter_types(tokens, declaration);
  }
}

void reach(const std::string& text) {
  const hlsl::Reach reached(text, "main.hlsl", "Main");
  std::vector<std::size_t> all(reached.unreached().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto lines = [](const std::string& t) { return std::count(t.begin(), t.end(), '\n'); };
  fuzz::require(lines(reached.text_with({})) == lines(text), "what is left out leaves its lines");
  fuzz::require(reached.text_with(all) == text, "with all of it nothing is left out");
}

void messages(const std::string& text, const hlsl::SourceFiles& sources) {
  const hlsl::TokenPlaces places(text, "main.hlsl");
  places.one_a_line();
  for (const shaders::LogLine& line : shaders::parse_log(text, sources)) {
    shaders::sentence(line, {});
    shaders::with_hlsl_types(line.message);
    shaders::nearest_word(line.token, places);
    places.function(line.token);
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(places.size(), 16); ++i) {
    places.at(i, sources);
    places.after(i, sources);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(fuzz::text_of(data, size));
  hlsl::SourceFiles sources;
  sources.add("main.hlsl", text);
  outline(text);
  reach(text);
  messages(text, sources);
  hlsl::unbalanced_bracket(hlsl::expanded_lines(text, "main.hlsl"), sources);
  hlsl::open_condition(sources);
  shaders::bad_character(text, "main.hlsl", sources);
  return 0;
}
