// Prepares preprocessed HLSL: each pass alone, or all of them, with the checks of an entry point or without.
// The first byte says which.
#include <algorithm>
#include <iterator>
#include <optional>
#include <span>

#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "hlsl/declarations.h"
#include "hlsl/tokens.h"
#include "preparation/prepare.h"
#include "preparation/token_text.h"

namespace penumbra::fuzz {

namespace {

constexpr std::size_t stages = std::size(hlsl::all_stages);
constexpr std::size_t entries = 2 * stages;

// Printing a text that no pass has touched gives the same tokens on the same lines.
void print_untouched(const std::string& text) {
  const preparation::TokenText untouched(text, "main.hlsl");
  const std::string printed = untouched.print();
  const std::vector<hlsl::Token> tokens = hlsl::lex(printed);
  require(tokens.size() == untouched.size(), "printing keeps every token");
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    require(tokens[i].spelling == untouched[i].spelling, "printing keeps spellings");
    require(tokens[i].line == untouched[i].line, "printing keeps lines");
  }
}

// The text's last function serves as the entry point of some stage, for either of Unity's compilers.
preparation::EntryPoint entry_of(const std::string& text, std::size_t choice) {
  preparation::EntryPoint entry{"Frag"};
  const std::vector<hlsl::Token> tokens = hlsl::lex(text);
  for (const hlsl::Declaration& declaration : hlsl::read_declarations(tokens))
    if (declaration.kind == hlsl::Declaration::Kind::function)
      entry.name = std::string(tokens[declaration.name].spelling);
  entry.stage = hlsl::all_stages[choice % stages];
  entry.dxc = choice >= stages;
  return entry;
}

void prepare_whole(const std::string& text, const std::optional<preparation::EntryPoint>& entry) {
  const auto count = [](const std::string& all) { return std::count(all.begin(), all.end(), '\n'); };
  const auto lines = static_cast<int>(count(text)) + 1;
  for (const hlsl::Diagnostic& note : preparation::prepare(text, "main.hlsl", entry).notes) {
    require_harmless(hlsl::format(note));
    require(note.file != "main.hlsl" || note.line <= lines || text.find("#line") != std::string::npos,
            "a note is in the text");
  }
}

}  // namespace

void targets::preparation(std::string_view bytes) {
  const std::size_t chosen = take_byte(bytes);
  const std::string text(bytes);
  const std::span<const preparation::Pass> passes = preparation::passes();
  if (chosen == 0) {
    prepare_whole(text, std::nullopt);
  } else if (chosen <= entries) {
    prepare_whole(text, entry_of(text, chosen - 1));
  } else if (chosen == entries + 1) {
    print_untouched(text);
  } else {
    preparation::TokenText one(text, "main.hlsl");
    passes[chosen % passes.size()].run(one);
    one.print();
  }
}

}  // namespace penumbra::fuzz
