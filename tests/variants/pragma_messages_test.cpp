// Tests what is said about pragmas that are wrong: the whole message, with its place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "variants/pragmas.h"
#include "variants/program_text.h"

namespace penumbra::variants {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

struct Case {
  const char* text;
  const char* message;
};

TEST(PragmaMessages, KeywordsOfTwoStagesMayStandInTwoSets) {
  EXPECT_THAT(
      messages_of(pragmas_of("#pragma shader_feature_vertex _ A\n#pragma shader_feature_fragment _ A B\n")),
      IsEmpty());
}

TEST(PragmaMessages, NameThePlaceAndTheRemedy) {
  const Case cases[] = {
      {"#pragma", "a.shader:1:1: warning: '#pragma' without a name after it has no effect"},
      {"#pragma multi_compil _ A",
       "a.shader:1:1: warning: unknown pragma 'multi_compil' has no effect; did you mean 'multi_compile'?"},
      {"#pragma multi_compile_fragmnt _ A",
       "a.shader:1:1: warning: unknown pragma 'multi_compile_fragmnt' has no effect; did you mean "
       "'multi_compile_fragment'?"},
      {"#pragma Vertx V",
       "a.shader:1:1: warning: unknown pragma 'Vertx' has no effect; did you mean 'vertex'?"},
      {"#pragma zzzzzzzzzzzz", "a.shader:1:1: warning: unknown pragma 'zzzzzzzzzzzz' has no effect"},
      {"  #pragma vertex", "a.shader:1:3: error: '#pragma vertex' needs the name of a function"},
      {"#pragma hull 4th", "a.shader:1:14: error: '4th' cannot be the name of a function"},
      {"#pragma vertex V;", "a.shader:1:17: warning: ';' after the function's name has no effect"},
      {"#pragma vertex ;", "a.shader:1:16: error: ';' cannot be the name of a function"},
      {"#pragma vertex V W", "a.shader:1:18: warning: what follows the function's name has no effect"},
      {"#pragma kernel", "a.shader:1:1: error: '#pragma kernel' needs the name of a function"},
      {"#pragma kernel K;", "a.shader:1:17: warning: ';' at the end of '#pragma kernel' has no effect"},
      {"#pragma kernel K A ;", "a.shader:1:20: warning: ';' at the end of '#pragma kernel' has no effect"},
      {"#pragma kernel ;", "a.shader:1:16: error: ';' cannot be the name of a function"},
      {"#pragma kernel K A =", "a.shader:1:20: error: '=' is not NAME or NAME=VALUE, without blanks"},
      {"#pragma multi_compile", "a.shader:1:1: warning: '#pragma multi_compile' names no keyword"},
      {"#pragma multi_compile _ A\n#pragma shader_feature _ B A",
       "a.shader:2:1: warning: 'A' stands in two keyword sets, here and at a.shader:1:1: Unity builds "
       "variants "
       "for both; declare it once"},
      {"#pragma multi_compile A,B",
       "a.shader:1:23: error: 'A,B' is not a keyword; keywords are separated by spaces, without commas"},
      {"#pragma multi_compile _ 3D",
       "a.shader:1:25: error: '3D' is not a keyword; keywords are letters, digits and '_'"},
      {"#pragma multi_compile A A", "a.shader:1:25: warning: 'A' appears twice in one set and counts once"},
      {"#pragma multi_compile_fog FOG",
       "a.shader:1:27: warning: '#pragma multi_compile_fog' takes no keywords"},
      {"#pragma target", "a.shader:1:1: error: '#pragma target' needs a shader model, for example 3.5"},
      {"#pragma target 4,5",
       "a.shader:1:16: error: '4,5' is not a shader model; known are 2.0 2.5 3.0 3.5 4.0 4.5 4.6 5.0 6.0 "
       "es3.0 "
       "es3.1 gl4.1"},
      {"#pragma require : A", "a.shader:1:1: error: '#pragma require' names no feature"},
      {"#pragma require integer",
       "a.shader:1:17: warning: unknown feature 'integer'; did you mean 'integers'?"},
      {"#pragma only_renderers vulcan",
       "a.shader:1:24: warning: unknown renderer 'vulcan'; did you mean 'vulkan'?"},
      {"#pragma exclude_renderers", "a.shader:1:1: warning: '#pragma exclude_renderers' names nothing"},
      {"#pragma instancing_options prcedural:F",
       "a.shader:1:28: warning: unknown instancing option 'prcedural'; did you mean 'procedural'?"},
      {"#pragma instancing_options procedural",
       "a.shader:1:28: error: 'procedural' needs the name of a function: procedural:NAME"},
      {"#pragma surface surf",
       "a.shader:1:1: error: '#pragma surface' needs a function and a lighting model"},
      {"#pragma surface surf Lambert addshadow",
       "a.shader:1:1: warning: a surface shader: Unity's editor writes its vertex and fragment functions; "
       "without the editor it cannot be compiled"},
      {"#include_with_pragmas gone.hlsl",
       "a.shader:1:1: error: '#include_with_pragmas' needs a file name in quotes"},
      {"#include_with_pragmas \"gone.hlsl\"",
       "a.shader:1:1: warning: cannot find 'gone.hlsl': its pragmas are ignored"},
      {"#if 1 +\n#endif",
       "a.shader:1:1: warning: this condition cannot be evaluated, and the pragmas it guards may be misread: "
       "this condition has no value"},
  };
  for (const Case& wrong : cases) {
    EXPECT_THAT(messages_of(pragmas_of(wrong.text)), ElementsAre(wrong.message)) << wrong.text;
  }
}

TEST(PragmaMessages, ShowTheLine) {
  const Pragmas pragmas = pragmas_of("\n  #pragma target x\n");
  ASSERT_THAT(pragmas.diagnostics, SizeIs(1));
  EXPECT_EQ(pragmas.diagnostics[0].source_line, "  #pragma target x");
}

TEST(PragmaMessages, ASecondEntryPointReplacesTheFirst) {
  const Pragmas pragmas = pragmas_of("#pragma vertex A\n#pragma fragment F\n#pragma vertex B\n");
  EXPECT_THAT(
      messages_of(pragmas),
      ElementsAre("a.shader:3:1: warning: a second vertex entry point: 'B' replaces 'A' of a.shader:1:1"));
  EXPECT_EQ(pragmas.entry_points[0].function, "B");
}

TEST(PragmaMessages, AKeywordDecidesNoPragma) {
  EXPECT_THAT(
      messages_of(pragmas_of("#pragma multi_compile _ KEY\n#if defined(KEY) && SHADER_TARGET > 30\n"
                             "#pragma multi_compile _ A\n#pragma multi_compile _ B\n#endif\n"
                             "#ifdef KEY\nfloat x;\n#endif\n")),
      ElementsAre("a.shader:3:1: warning: this pragma depends on the keyword 'KEY', which Unity does not "
                  "define while it reads pragmas"));
}

TEST(PragmaMessages, FilesThatIncludeThemselvesEnd) {
  const Files files{{"a.hlsl", "#include_with_pragmas \"b.hlsl\"\n#include_with_pragmas \"b.hlsl\"\n"},
                    {"b.hlsl", "\n#include_with_pragmas \"a.hlsl\"\n#include_with_pragmas \"a.hlsl\"\n"}};
  const Pragmas pragmas = pragmas_of("#include_with_pragmas \"a.hlsl\"\n#pragma vertex V\n", files);
  EXPECT_THAT(messages_of(pragmas),
              ElementsAre("a.hlsl:1:1: error: files include each other more than 100 deep, down to 'b.hlsl'; "
                          "add an include guard or '#pragma once'",
                          testing::HasSubstr("too many files are included")));
  EXPECT_THAT(pragmas.entry_points, SizeIs(1));
}

// Each message holds the line.
TEST(PragmaMessages, OfOneLineAreAFew) {
  std::string text = "#pragma multi_compile";
  for (int i = 0; i < 5000; ++i) text += " A";
  const std::vector<std::string> messages = messages_of(pragmas_of(text + " 3D\n"));
  EXPECT_THAT(messages, SizeIs(9)) << "eight warnings, and the error all the same";
  EXPECT_THAT(messages,
              Contains(testing::EndsWith("counts once (further ones of this line are not listed)")));
  EXPECT_THAT(messages, Contains(testing::HasSubstr("error: '3D' is not a keyword")));
}

TEST(PragmaMessages, AreNotRepeatedWithoutEnd) {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "#pragma target x\n";
  EXPECT_THAT(pragmas_of(text).diagnostics, SizeIs(200));
}

}  // namespace
}  // namespace penumbra::variants
