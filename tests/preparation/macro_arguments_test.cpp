// Tests macro arguments that expand to several, and macros defined twice: what is written instead, and what
// the whole way through the preprocessor makes of it.
#include "preparation/macro_arguments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "preparation/macro_text.h"
#include "shaders/compile.h"

namespace penumbra::preparation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string spread(const std::string& text, const std::vector<std::string>& macros) {
  MacroArguments arguments;
  arguments.read(text);
  for (const std::string& macro : macros) arguments.spread(macro);
  arguments.settle();
  return arguments.rewritten(text);
}

TEST(MacroArguments, CallsWithTooFewAsWrittenTakeTwoSteps) {
  const std::string definition = "#define F(a, b, c) a\n";
  EXPECT_EQ(spread(definition + "F(1, X) F(1, 2, X) F(g(1, 2, 3)) F ( X )", {"F"}),
            definition +
                "penumbra_spread_F((1, X)) F(1, 2, X) penumbra_spread_F((g(1, 2, 3))) "
                "penumbra_spread_F (( X ))");
  EXPECT_EQ(spread(definition + "F(F(X))", {"F"}),
            definition + "penumbra_spread_F((penumbra_spread_F((X))))");
}

TEST(MacroArguments, NamesThatStandForTheMacroAreFollowed) {
  const std::string definitions = "#define F(a, b) a\n#define G F\n#define H x + G\n#define G2 (F)\n";
  EXPECT_EQ(spread(definitions + "G(X) H(X) G2(X)", {"F"}),
            definitions + "penumbra_spread_G((X)) penumbra_spread_H((X)) G2(X)");
}

TEST(MacroArguments, BodiesOfMacrosAreReadAndOtherDirectivesAreNot) {
  EXPECT_EQ(spread("#define F(a, b) a\n#define M(q) F(q) \\\n F(q)\n#if F(X)\n#endif\n", {"F"}),
            "#define F(a, b) a\n#define M(q) penumbra_spread_F((q)) \\\n penumbra_spread_F((q))\n#if F(X)\n"
            "#endif\n");
}

TEST(MacroArguments, CommentsTextsAndCallsAcrossDirectivesStay) {
  const std::string text =
      "#define F(a, b) a // F(X)\n/* F(X) */ \"F(X)\" F(X\n#if 1\n)\n#endif\n#define OPEN F(X\n) F[X] F\n";
  EXPECT_EQ(spread(text, {"F"}), text);
}

TEST(MacroArguments, WhatIsNoMacroWithParametersIsNotSpread) {
  const std::string text = "#define F 1\nF(X) g(X)\n";
  EXPECT_EQ(spread(text, {"F", "g"}), text);
}

TEST(MacroText, DefinitionsHaveTheirLineParametersAndLastToken) {
  const std::string text =
      "\n# define A 1 + B // c\n#define C( x,\\\n y ) /*\n*/ x y\n#define D (x)\n#define E\n";
  const MacroText read = read_macro_text(text);
  ASSERT_EQ(read.definitions.size(), 4U);
  EXPECT_EQ(read.definitions[0].line, 2);
  const auto last = [&](std::size_t at) { return read.tokens[read.definitions[at].body_end - 1].spelling; };
  EXPECT_EQ(last(0), "B");
  EXPECT_FALSE(read.definitions[0].parameters.has_value());
  EXPECT_EQ(read.definitions[1].line, 3);
  EXPECT_EQ(read.definitions[1].parameters, 2U);
  EXPECT_EQ(last(1), "y");
  EXPECT_EQ(read.definitions[2].line, 6);
  EXPECT_EQ(last(2), ")");
  EXPECT_EQ(read.definitions[3].body_begin, read.definitions[3].body_end);
}

// The pass is linear, never reads out of bounds, and moves no lines; the test is run under the sanitizers.
TEST(MacroText, AnyBytesAreRead) {
  std::mt19937 random(11);
  const std::vector<std::string> pieces{"#",  "define ", "F",  "(",  ")", ",", "\n", "\\\n", "/*",
                                        "*/", "//",      "\"", "\\", " ", "1", "if", "G",    "{"};
  for (int round = 0; round < 20000; ++round) {
    std::string text = round % 2 == 0 ? "#define F(a, b) a\n#define G F\n" : "";
    for (std::size_t i = random() % 16; i > 0; --i) text += pieces[random() % pieces.size()];
    const std::string out = spread(text, {"F"});
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), std::count(out.begin(), out.end(), '\n'));
  }
}

shaders::CompileRequest request_for(const std::string& text) {
  shaders::CompileRequest request;
  request.file = "macros.hlsl";
  request.text = text;
  request.prepare = true;
  return request;
}

std::string without_blanks(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
  return text;
}

const std::string kUnity =
    "#define SAMPLE_ARRAY(map, smp, uv, slice) map.Sample(smp, float3(uv, slice))\n"
    "#define SAMPLE_LIGHTMAP SAMPLE_ARRAY\n"
    "#define UV_USE uv, 3\n"
    "#define AND_SLICE , 4\n"
    "#define SHADOWMASK(uv) SAMPLE_LIGHTMAP(mask, smp, uv AND_SLICE)\n";

TEST(MacroExpansion, ArgumentsAreCountedAfterTheyAreExpandedWhereTheyAreTooFew) {
  const shaders::PreprocessedSource source =
      shaders::preprocess(request_for(kUnity + "a = SAMPLE_LIGHTMAP(map, smp, UV_USE);\n"
                                               "b = SHADOWMASK(st);\n"
                                               "c = SAMPLE_ARRAY(map, smp, f(UV_USE), 1);\n"
                                               "d = SHADOWMASK(SAMPLE_LIGHTMAP(map, smp, UV_USE).xy);\n"));
  EXPECT_THAT(source.diagnostics, IsEmpty()) << format(source.diagnostics.at(0));
  EXPECT_EQ(without_blanks(source.text).substr(source.text.find_first_not_of('\n')),
            "#line6\"macros.hlsl\"\na=map.Sample(smp,float3(uv,3));\nb=mask.Sample(smp,float3(st,4));\n"
            "c=map.Sample(smp,float3(f(uv,3),1));\n"
            "d=mask.Sample(smp,float3(map.Sample(smp,float3(uv,3)).xy,4));\n");
}

TEST(MacroExpansion, AMessageBehindSuchACallKeepsItsPlace) {
  const shaders::CompileResult result = shaders::compile(
      request_for(kUnity + "Texture2DArray map; SamplerState smp;\n"
                           "float4 f(float2 uv) { return SAMPLE_LIGHTMAP(map, smp, UV_USE) + nothing; }\n"
                           "[numthreads(1, 1, 1)] void Main() { }\n"));
  ASSERT_FALSE(result.diagnostics.empty());
  EXPECT_THAT(format(result.diagnostics.front()),
              HasSubstr("macros.hlsl:7:66: error: unknown variable 'nothing'"));
}

TEST(MacroExpansion, TooFewAfterAllIsAnError) {
  const shaders::PreprocessedSource source = shaders::preprocess(request_for(
      "#define F(a, b, c) a\n#define X 1\n#define Y 1, 2\nfloat x = F(Y, 3); float y =\n F(1, X);\n"));
  EXPECT_EQ(source.text, "");
  ASSERT_EQ(source.diagnostics.size(), 1U);
  EXPECT_THAT(format(source.diagnostics[0]), HasSubstr("macros.hlsl:5:"));
  EXPECT_THAT(source.diagnostics[0].message, HasSubstr("too few arguments for macro 'F'"));
}

TEST(MacroExpansion, ASecondDefinitionCountsFromWhereItStands) {
  const shaders::PreprocessedSource source = shaders::preprocess(request_for(
      "#define D 1\nfloat a = D;\n#define D 2\nfloat b = D;\n#define K(x) x\n#define K(x, y) x - y\n"
      "#define E 1\n#define E(x) x\n#define G(x) x\n#define G(y) y * 2\nfloat c = K(1, 2) + E(4) + "
      "G(5);\n"));
  EXPECT_THAT(without_blanks(source.text), HasSubstr("floata=1;\n\nfloatb=2;\n"));
  EXPECT_THAT(without_blanks(source.text), HasSubstr("floatc=1-2+4+5*2;"));
  std::vector<std::string> said;
  for (const hlsl::Diagnostic& diagnostic : source.diagnostics)
    said.push_back(std::to_string(diagnostic.line) + ":" + std::to_string(diagnostic.column) + ": " +
                   diagnostic.message);
  const auto message = [](const std::string& name, int other) {
    return "macro '" + name + "' is defined as something else at macros.hlsl:" + std::to_string(other) +
           "; from here on this definition is used";
  };
  EXPECT_THAT(said, ElementsAre("3:9: " + message("D", 1), "6:9: " + message("K", 5),
                                "8:9: " + message("E", 7), "10:9: " + message("G", 9)));
  EXPECT_FALSE(hlsl::has_errors(source.diagnostics));
}

TEST(MacroExpansion, ADefinitionOfTheCommandLineIsOutdoneToo) {
  shaders::CompileRequest request = request_for("#define QUALITY 2\nfloat a = QUALITY;\n");
  request.defines = {{"QUALITY", "1"}};
  const shaders::PreprocessedSource source = shaders::preprocess(request);
  EXPECT_THAT(source.text, HasSubstr("a = 2"));
  ASSERT_EQ(source.diagnostics.size(), 1U);
  EXPECT_THAT(source.diagnostics[0].message, HasSubstr("something else before the first line;"));
}

TEST(MacroExpansion, OtherErrorsAreToldAsBefore) {
  const shaders::PreprocessedSource source = shaders::preprocess(
      request_for("#define D 1\n#define D 2\n#define F(a, b) a\n#define X 1, 2\nfloat x = F(X);\n"
                  "#error stop here\nfloat a = D;\n"));
  EXPECT_EQ(source.text, "");
  ASSERT_EQ(source.diagnostics.size(), 2U);
  EXPECT_EQ(source.diagnostics[0].severity, hlsl::Severity::warning);
  EXPECT_THAT(format(source.diagnostics[1]), HasSubstr("macros.hlsl:6:1: error: '#error': stop here"));
}

// The answers are those of the C preprocessor (6.10.3.4), through no, one, two and three macros.
TEST(MacroExpansion, MacrosThatNameThemselvesAreExpandedOnce) {
  const std::string text =
      "#define ACCESS(arr, var) arr##Array[id].var\n#define _Color ACCESS(Props, _Color)\n"
      "#define MUL(a, b) ((a) * (b))\n#define TWICE(a) MUL(a, 2)\n#define SELF(x) SELF(x + 1)\n"
      "#define pos input.pos\n"
      "a = _Color;\nb = MUL(_Color, pos);\nc = TWICE(_Color);\nd = TWICE(TWICE(pos));\ne = TWICE(SELF(1));\n";
  const auto expanded = [&](bool prepare) {
    shaders::CompileRequest request = request_for(text);
    request.prepare = prepare;
    const std::string out = without_blanks(shaders::preprocess(request).text);
    return out.substr(out.find("a="));
  };
  EXPECT_EQ(expanded(true),
            "a=PropsArray[id]._Color;\nb=((PropsArray[id]._Color)*(input.pos));\n"
            "c=((PropsArray[id]._Color)*(2));\nd=((((input.pos)*(2)))*(2));\ne=((SELF(1+1))*(2));\n");
  EXPECT_NE(expanded(false), expanded(true));
}

TEST(MacroOwnNames, AreMarkedInTheirOwnBodiesAlone) {
  const std::string text =
      "#define A B(A, 1) // A\n#define B(A, x) A + x B\nA B\n#define C a##C C##a C\n#undef A\n";
  EXPECT_EQ(
      with_own_names_marked(text),
      "#define A B(penumbra_own_A, 1) // A\n#define B(A, x) A + x penumbra_own_B\nA B\n#define C a##C C##a "
      "penumbra_own_C\n#undef A\n");
  EXPECT_EQ(without_marks(with_own_names_marked(text)), text);
}

TEST(MacroExpansion, WithoutPreparationBothAreErrors) {
  for (const char* text :
       {"#define D 1\n#define D 2\n", "#define F(a, b) a\n#define X 1, 2\nfloat x = F(X);\n"}) {
    shaders::CompileRequest request = request_for(text);
    request.prepare = false;
    EXPECT_TRUE(hlsl::has_errors(shaders::preprocess(request).diagnostics)) << text;
  }
}

}  // namespace
}  // namespace penumbra::preparation
