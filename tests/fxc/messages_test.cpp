// FXC's messages arrive at the places of the files that its text was expanded from.
#include "fxc/messages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace penumbra::fxc {
namespace {

using testing::HasSubstr;

hlsl::SourceFiles sources() {
  hlsl::SourceFiles files;
  files.add("Main.hlsl",
            "#include \"Wave.hlsl\"\n#define SCALE(x) ((x) * 2)\nfloat a = 1;   int b = SCALE(c);\n");
  files.add("Wave.hlsl", "float wave;\n");
  return files;
}

const std::string expanded =
    "#line 1 \"Wave.hlsl\"\n"
    "float wave;\n"
    "#line 3 \"Main.hlsl\"\n"
    "float a = 1; int b = ((c) * 2);\n";

TEST(FxcMessages, AnErrorIsAtItsTokenInTheFile) {
  const auto said = diagnostics_of("C:\\t\\memory(2,7-10): error X3000: syntax error: unexpected 'wave'\n",
                                   expanded, "Main.hlsl", sources());
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].file, "Wave.hlsl");
  EXPECT_EQ(said[0].line, 1);
  EXPECT_EQ(said[0].column, 7);
  EXPECT_EQ(said[0].severity, hlsl::Severity::error);
  EXPECT_EQ(said[0].message, "X3000: syntax error: unexpected 'wave'");
  EXPECT_EQ(said[0].source_line, "float wave;");
}

TEST(FxcMessages, ATokenFromAMacroIsAtTheCall) {
  const auto said =
      diagnostics_of("memory(4,24): warning X3206: implicit truncation\n", expanded, "Main.hlsl", sources());
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].file, "Main.hlsl");
  EXPECT_EQ(said[0].line, 3);
  EXPECT_EQ(said[0].column, 30);
  EXPECT_EQ(said[0].severity, hlsl::Severity::warning);
}

TEST(FxcMessages, EachIsSaidOnceAndLinesWithoutANumberBelongToTheLast) {
  const auto said = diagnostics_of(
      "memory(2,7): error X3067: 'f': ambiguous function call\n    f(float)\nmemory(4,1): warning X3206: w\n"
      "memory(4,1-5): warning X3206: w\n",
      expanded, "Main.hlsl", sources());
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(said[0].message, "X3067: 'f': ambiguous function call; f(float)");
}

TEST(FxcMessages, WhatItSaysWithoutASeverityHasNoFolder) {
  const auto said = diagnostics_of("Z:\\tmp\\x\\Shader@0x0000000000C815CC(2,7): memory exhausted\n", expanded,
                                   "Main.hlsl", sources());
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].file, "Wave.hlsl");
  EXPECT_EQ(said[0].column, 7);
  EXPECT_EQ(said[0].severity, hlsl::Severity::error);
  EXPECT_EQ(said[0].message, "memory exhausted");
}

TEST(FxcMessages, CandidatesOfACallAreOneMessage) {
  const auto said = diagnostics_of(
      "m(4,1-5): error X3013: 'tex2D': no matching 2 parameter intrinsic function\n"
      "m(4,1-5): error X3013: Possible intrinsic functions are:\n"
      "m(4,1-5): error X3013:     tex2D(sampler2D, float2)\nm(4,1-5): error X3013: 'f': other\n",
      expanded, "Main.hlsl", sources());
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(said[0].message,
            "X3013: 'tex2D': no matching 2 parameter intrinsic function; Possible intrinsic functions are:; "
            "tex2D(sampler2D, "
            "float2)");
}

TEST(FxcMessages, OneWithoutAPlaceIsOfTheMainFile) {
  for (const char* text : {"error X3501: 'Main': entrypoint not found\n",
                           "memory(99,1): error X3501: 'Main': entrypoint not found\n"}) {
    const auto said = diagnostics_of(text, expanded, "Main.hlsl", sources());
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said[0].file, "Main.hlsl");
    EXPECT_EQ(said[0].line, 0);
    EXPECT_THAT(said[0].message, HasSubstr("entrypoint"));
  }
}

TEST(FxcMessages, TheTextKeepsLinesAndColumnsAndOnlyPragmasOfFxc) {
  const std::string text = text_for_fxc(
      "#line 3 \"a\"\n#pragma multi_compile _ A\n # pragma warning (disable : 3206)\n#pragma "
      "pack_matrix(row_major)\nfloat a;");
  EXPECT_EQ(text, std::string(11, ' ') + "\n" + std::string(25, ' ') +
                      "\n # pragma warning (disable : 3206)\n#pragma pack_matrix(row_major)\nfloat a;");
}

}  // namespace
}  // namespace penumbra::fxc
