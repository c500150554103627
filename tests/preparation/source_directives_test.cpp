// Tests the text before the preprocessor: a few words change, no character moves.
#include "preparation/source_directives.h"

#include <gtest/gtest.h>

#include <random>

namespace penumbra::preparation {
namespace {

std::string prepared(const std::string& text) {
  const std::string source = prepare_source(text);
  EXPECT_EQ(source.size(), text.size());
  for (std::size_t i = 0; i < std::min(text.size(), source.size()); ++i)
    EXPECT_EQ(text[i] == '\n', source[i] == '\n') << i;
  return source;
}

TEST(SourceDirectives, PragmasOfFxcComeBackInTheExpandedText) {
  const std::string source =
      "#pragma warning (disable : 3205 3206) // why\n#pragma warning(default:3557)\n#pragma "
      "pack_matrix(row_major)\n"
      "#pragma warning(disable : 1; enable : 2)\n#pragma warning(no : 3)\nfloat a;";
  const std::string text = prepared(source);
  EXPECT_EQ(text.find("#pragma"), text.find("#pragma warning(disable : 1; enable : 2)"));
  EXPECT_EQ(with_pragmas(text).substr(0, 99),
            "#pragma warning(disable : 3205 3206)\n#pragma warning(default : 3557)\n#pragma "
            "pack_matrix(row_major)");
  EXPECT_EQ(with_pragmas(text).find("penumbra"), std::string::npos);
  EXPECT_EQ(prepared("#pragma multi_compile _ A\nb"), "#pragma multi_compile _ A\nb");
  EXPECT_EQ(with_pragmas("int a;\nb;\n"), "int a;\nb;\n");
}

TEST(SourceDirectives, HalfLiteralsBecomeFloat) {
  EXPECT_EQ(prepared("1.0h .5H 2.h 1e-3h 1h 1.5f 0x1h h 1.0 v1h x.h"),
            "1.0f .5f 2.f 1e-3f 1. 1.5f 0x1h h 1.0 v1h x.h");
  EXPECT_EQ(prepared("#define K 2.0h\n#if 1\n"), "#define K 2.0f\n#if 1\n");
}

// FXC compiles the first three lines to 0x76312589, 705032704 and 0xFFFFFFFF, and refuses the numbers of the
// last.
TEST(SourceDirectives, LongIntegersKeepTheirLowBits) {
  EXPECT_EQ(prepared("0x1376312589U 0X1376312589ul 0xFEDCBA9876543210L"),
            "0x0076312589U 0x0076312589ul 0x0000000076543210L");
  EXPECT_EQ(prepared("5000000000u 18446744073709551615l"), "0x2a05f200u 0x0000000000ffffffffl");
  EXPECT_EQ(prepared("0777777777777U"), "0x000ffffffffU");
  const std::string others =
      "4294967295U 0xFFFFFFFFu 1u 0u 0L v0x1376312589U \"0x1376312589U\" 0x1376312589Ux 1.5L 09999999999999U "
      "0x1376312589 5000000000 18446744073709551616U 0x1FEDCBA9876543210U";
  EXPECT_EQ(prepared(others), others);
}

TEST(SourceDirectives, InfinityKeepsItsPlace) {
  EXPECT_EQ(prepared("x = -1.#INF;"), "x = -1e9999;");
}

TEST(SourceDirectives, CommentsAndTextsStay) {
  const std::string text = "// 1.0h\n/* 1.0h\n#pragma a */ \"1.0h \\\" 1.0h\" // \\\n 1.0h\n#error 1.0h\n";
  EXPECT_EQ(prepared(text), text);
}

// The check is linear and never reads out of bounds; the test is run under the sanitizers.
TEST(SourceDirectives, AnyBytesAreRead) {
  std::mt19937 random(7);
  const std::string alphabet = "#/*\\\"\n 1.hHeEx#+-INFpragmaonce_";
  for (int round = 0; round < 20000; ++round) {
    std::string text(random() % 24, ' ');
    for (char& c : text) c = alphabet[random() % alphabet.size()];
    prepared(text);
  }
}

}  // namespace
}  // namespace penumbra::preparation
