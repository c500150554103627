#include "preparation/bare_source.h"

#include <gtest/gtest.h>

#include <random>

#include "hlsl/tokens.h"
#include "shaders/compile.h"
#include "shaders/source_memory.h"

namespace penumbra::preparation {
namespace {

TEST(BareSource, CommentsAndIndentationGo) {
  EXPECT_EQ(bare_source("  a; // b\n\t/* c */ d /* e */ f\n"), "a; \nd   f\n");
  EXPECT_EQ(bare_source("a /* b\n  c\n d */ e\n"), "a \n\n e\n");
}

TEST(BareSource, TextsStay) {
  EXPECT_EQ(bare_source("a \"// b /* \\\" c\" // d\n"), "a \"// b /* \\\" c\" \n");
  EXPECT_EQ(bare_source("a \"never closed // b\nc // d\n"), "a \"never closed // b\nc \n");
}

TEST(BareSource, DirectivesKeepTheirLines) {
  EXPECT_EQ(bare_source("  #define A 1 // b\n"), "#define A 1 \n");
  EXPECT_EQ(bare_source("#define A(x) \\\n    x // b\n"), "#define A(x) \\\n x \n");
  EXPECT_EQ(bare_source("#define A 1 // b \\\n  c\nd\n"), "#define A 1 \\\n\nd\n");
  EXPECT_EQ(bare_source("#define A /* b\n c */ 1\n"), "#define A /* b\n c */ 1\n");
  EXPECT_EQ(bare_source("#include <a//b> // c\n#error it's // here\n"),
            "#include <a//b> // c\n#error it's // here\n");
}

TEST(BareSource, JoinedLinesOfCodeAreLines) {
  EXPECT_EQ(bare_source("a \\\nb\\\n  c\\\nd\n"), "a \nb\nc\\\nd\n") << "but for a word that goes on";
  EXPECT_EQ(bare_source("a \\\n # b\n"), "a \\\n # b\n") << "no directive";
}

TEST(BareSource, WhatEndsTooEarlyEnds) {
  for (const char* text :
       {"", "/", "/*", "/* a", "//", "// a\\", "// a\\\n", "#", "#define A \\", "\"", "\"\\", "  "})
    EXPECT_LE(bare_source(text).size(), std::string_view(text).size()) << text;
  EXPECT_EQ(bare_source("a /* b"), "a /* b") << "for the preprocessor to complain of";
}

// The tokens and their lines, as glslang's preprocessor leaves them; "" when it finds fault.
std::string expanded(const std::string& text, bool bare) {
  shaders::CompileRequest request;
  request.file = "soup.hlsl";
  request.text = text;
  request.prepare = bare;  // the preprocessor then reads the bare source
  shaders::SourceMemory memory;
  const shaders::PreprocessedSource source = shaders::expand(request, memory);
  if (hlsl::has_errors(source.diagnostics)) return "";
  std::string tokens;
  for (const hlsl::Token& token : hlsl::lex(source.text))
    tokens += std::to_string(token.line) + " " + std::string(token.spelling) + "\n";
  return tokens;
}

TEST(BareSource, ThePreprocessorMakesTheSameOfIt) {
  const char* const parts[] = {"a",
                               " ",
                               "  ",
                               "\n",
                               "\n",
                               "/*",
                               "*/",
                               "//",
                               "\\\n",
                               "\n#define A b",
                               "\n#ifdef A\n",
                               "\n#else\n",
                               "\n#endif\n",
                               "A",
                               "+",
                               "\t",
                               "\n  # define B A c",
                               "B",
                               "\"t\"",
                               "1.5",
                               "/"};
  std::mt19937 random(7);
  int compared = 0;
  for (int soup = 0; soup < 12000; ++soup) {
    std::string text;
    const auto length = 1 + random() % 24;
    for (unsigned i = 0; i < length; ++i) text += parts[random() % std::size(parts)];
    text += "\n";
    const std::string as_it_is = expanded(text, false);
    if (as_it_is.empty()) continue;
    ++compared;
    ASSERT_EQ(expanded(text, true), as_it_is) << text;
  }
  EXPECT_GT(compared, 1500);
}

}  // namespace
}  // namespace penumbra::preparation
