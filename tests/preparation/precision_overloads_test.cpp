// Overloads that differ in precision alone become one function, and nothing else changes.
#include "preparation/passes.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "shaders/compile.h"

namespace penumbra::preparation {
namespace {

using testing::AllOf;
using testing::Eq;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct MergedTwins {
  std::string text;
  std::vector<Note> notes;
};

MergedTwins merge(const std::string& text, const std::string& entry = "") {
  TokenText tokens(text, "main.hlsl");
  tokens.set_entry(entry);
  merge_precision_overloads(tokens);
  return {tokens.print(), tokens.notes()};
}

std::string printed(const std::string& text) {
  return TokenText(text, "main.hlsl").print();
}

// The text without blanks, line ends and the directive that it begins with.
std::string squeezed(std::string text) {
  if (text.rfind("#line", 0) == 0) text.erase(0, text.find('\n'));
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\n'; }),
             text.end());
  return text;
}

void expect_untouched(const std::string& text) {
  const MergedTwins merged = merge(text);
  EXPECT_EQ(merged.text, printed(text));
  EXPECT_THAT(merged.notes, IsEmpty());
}

TEST(PrecisionTwins, TheFloatBodyStaysWhicheverComesFirst) {
  const std::string narrow = "half2 f(half2 x) { return 1; }";
  const std::string wide = "float2 f(float2 x) { return 2; }";
  EXPECT_EQ(squeezed(merge(narrow + wide).text), squeezed("half2 f(half2 x) ;" + wide));
  EXPECT_EQ(squeezed(merge(wide + narrow).text), squeezed(wide + "half2 f(half2 x) ;"));
}

TEST(PrecisionTwins, OnlyCallsThatTheEntryPointReachesDecide) {
  const std::string twins = "half f(half x) { return 1; } float f(float x) { return 2; } ";
  const std::string narrow = "half g(half x) { return f(x); } ";
  const std::string wide = "float h(float x) { return f(x); } ";
  const std::string kept_wide = squeezed("half f(half x) ; float f(float x) { return 2; }");
  const std::string kept_narrow = squeezed("half f(half x) { return 1; } float f(float x) ;");
  const std::string main = "float Main() { return g(1) + 1; } ";
  for (const std::string& declared : {std::string(), std::string("float h(float x); ")}) {
    const MergedTwins reached = merge(declared + twins + narrow + wide + main, "Main");
    EXPECT_THAT(squeezed(reached.text), HasSubstr(kept_narrow)) << declared;
    EXPECT_EQ(reached.notes.at(0).severity, hlsl::Severity::warning);
  }
  const MergedTwins unreached = merge(twins + narrow + "float Main() { return 1; } ", "Main");
  EXPECT_THAT(squeezed(unreached.text), HasSubstr(kept_wide));
  EXPECT_EQ(unreached.notes.at(0).severity, hlsl::Severity::note) << "it cannot change what Main does";
  EXPECT_THAT(
      squeezed(
          merge(twins + narrow + "static const float c = g(1); float Main() { return c; }", "Main").text),
      HasSubstr(kept_narrow))
      << "an initialiser calls it";
}

TEST(PrecisionTwins, TheBodyThatDoesTheWorkStays) {
  const std::string narrow = "half f(half x) { return x * x; }";
  EXPECT_EQ(squeezed(merge("float f(float x) { return f(half(x)); }" + narrow).text),
            squeezed("float f(float x) ;" + narrow));
}

TEST(PrecisionTwins, EveryNarrowTypeAndShapeIsItsWideOne) {
  for (const auto& [narrow, wide] :
       std::vector<std::pair<std::string, std::string>>{{"half", "float"},
                                                        {"half4", "float4"},
                                                        {"half3x3", "float3x3"},
                                                        {"min16float2", "float2"},
                                                        {"min10float", "float"},
                                                        {"min16int3", "int3"},
                                                        {"min12int", "int"},
                                                        {"min16uint4", "uint4"},
                                                        {"Texture2D<half4>", "Texture2D<float4>"},
                                                        {"out half", "out float"},
                                                        {"const in half", "float"}}) {
    const std::string text = "void f(" + narrow + " x){} void f(" + wide + " x){}";
    EXPECT_THAT(merge(text).notes, SizeIs(1)) << text;
  }
}

TEST(PrecisionTwins, SaysWhichBodyWentAndWhichIsKept) {
  const MergedTwins merged = merge(
      "half f(half a, int b) { return a; }\n#line 7 \"lib/wide.hlsl\"\n\nfloat f(float x, int y)\n{ return "
      "x; }\n");
  ASSERT_THAT(merged.notes, SizeIs(1));
  EXPECT_EQ(merged.notes[0].severity, hlsl::Severity::note);
  EXPECT_EQ(merged.notes[0].file, "main.hlsl");
  EXPECT_EQ(merged.notes[0].line, 1);
  EXPECT_THAT(merged.notes[0].message,
              AllOf(HasSubstr("'f(half, int)'"), HasSubstr("'f(float, int)'"), HasSubstr("lib/wide.hlsl:8")));
}

// The names of parameters make no difference; anything else does.
TEST(PrecisionTwins, DifferentBodiesAreAWarning) {
  EXPECT_EQ(
      merge("half f(half a, half b) { return a; } float f(float b, float a) { return b; }").notes[0].severity,
      hlsl::Severity::note);
  for (const char* text : {"half f(half a, half b) { return a; } float f(float a, float b) { return b; }",
                           "half f(half a) { return a * 2; } float f(float a) { return a * 3; }"}) {
    const MergedTwins merged = merge(text);
    ASSERT_THAT(merged.notes, SizeIs(1));
    EXPECT_EQ(merged.notes[0].severity, hlsl::Severity::warning);
    EXPECT_THAT(merged.notes[0].message, HasSubstr("the two bodies differ in more than their types"));
  }
}

TEST(PrecisionTwins, DifferentFunctionsStay) {
  expect_untouched("float f(half x) {} float g(float x) {}");                  // the names differ
  expect_untouched("float f(half2 x) {} float f(float3 x) {}");                // the shapes differ
  expect_untouched("float f(half x, int i) {} float f(float x) {}");           // the counts differ
  expect_untouched("float f(half x[2]) {} float f(float x[3]) {}");            // the array sizes differ
  expect_untouched("float f(half x) {} float f(int x) {}");                    // the kinds of number differ
  expect_untouched("float f(halfling x) {} float f(floatling x) {}");          // the types are the user's own
  expect_untouched("namespace a { float f(half x) {} } float f(float x) {}");  // the namespaces differ
  expect_untouched("struct A { float f(half x) {} float f(float x) {} };");    // nothing may follow twice
}

TEST(PrecisionTwins, DefinitionsSpelledAlikeStayAnError) {
  expect_untouched("float f(float x) { return 1; } float f(float y) { return 2; }");
}

TEST(PrecisionTwins, DeclarationsAndValuesAreNoDefinitions) {
  expect_untouched(
      "half f(half x); float f(float x); float f(float x) { return x; }\n"
      "static float table[2] = { g(1), g(2) };\n"
      "cbuffer A : register(b0) { half a; } cbuffer B : register(b0) { float b; }\n"
      "[numthreads(8, 8, 1)] void Main(uint3 id : SV_DispatchThreadID) { f(1); }\n");
}

TEST(PrecisionTwins, WhatFollowsABodyThatWentKeepsItsPlace) {
  const std::string text =
      "half f(half x)\n{\n    return x;\n#line 40 \"b.hlsl\"\n}\nfloat f(float x) { return x; }\n";
  const std::string merged = merge(text).text;
  const std::vector<hlsl::Token> tokens = hlsl::lex(merged);
  EXPECT_THAT(tokens, testing::Contains(AllOf(testing::Field(&hlsl::Token::spelling, Eq("float")),
                                              testing::Field(&hlsl::Token::file, Eq("b.hlsl")),
                                              testing::Field(&hlsl::Token::line, Eq(41)))));
}

TEST(PrecisionTwins, SaysWhereBodiesDifferInMoreThanTheirTypes) {
  const auto note = [](const std::string& text) { return merge(text).notes.at(0).message; };
  EXPECT_THAT(note("half f(half x){ return x * 2.0f; } float f(float x){ return x * 2.0; }"),
              testing::Not(HasSubstr("two bodies differ")));
  EXPECT_THAT(
      note("half f(half x){ return max(x, 6.103515625e-5); } float f(float x){ return max(x, 1e-38); }"),
      HasSubstr("the two bodies differ in more than their types"));
}

TEST(PrecisionTwins, TextThatIsNoHlslIsLeftAlone) {
  for (const char* text : {"", "{", "}", ")", "f(", "float f(half x", "float f(half x) {", "\"unended",
                           "#line", "#line x \"y", "((((", "namespace", "namespace {", "= ; } ] ) ("}) {
    expect_untouched(text);
  }
}

shaders::CompileResult compile_twins(const std::string& text, bool merge_twins) {
  shaders::CompileRequest request;
  request.file = "twins.hlsl";
  request.text = text;
  request.prepare = merge_twins;
  return compile(request);
}

const std::string kTwins =
    "#define BOTH(n) half n(half x) { return x; } float n(float x) { return x + 1.0; }\n"
    "BOTH(f)\n"
    "RWStructuredBuffer<float> Out;\n"
    "[numthreads(1, 1, 1)] void Main() { half h = 2.0; Out[0] = f(h) + f(3.0); }\n";

TEST(PrecisionTwins, CompileWhenMergedAndDoNotOtherwise) {
  EXPECT_THAT(compile_twins(kTwins, false).spirv, IsEmpty());
  const shaders::CompileResult merged = compile_twins(kTwins, true);
  EXPECT_FALSE(merged.spirv.empty());
  ASSERT_THAT(merged.diagnostics, SizeIs(1));
  EXPECT_EQ(merged.diagnostics[0].line, 2);
  EXPECT_EQ(merged.diagnostics[0].source_line, "BOTH(f)");
}

TEST(PrecisionTwins, ErrorsKeepTheirPlaceAfterMerging) {
  const shaders::CompileResult result = compile_twins(kTwins + "\nfloat g() { return nothing; }\n", true);
  const auto error =
      std::find_if(result.diagnostics.begin(), result.diagnostics.end(),
                   [](const hlsl::Diagnostic& d) { return d.severity == hlsl::Severity::error; });
  ASSERT_NE(error, result.diagnostics.end());
  EXPECT_EQ(error->file, "twins.hlsl");
  EXPECT_EQ(error->line, 6);
  EXPECT_THAT(error->message, HasSubstr("nothing"));
}

TEST(PrecisionTwins, ATextThatDoesNotExpandSaysWhy) {
  const shaders::CompileResult result = compile_twins("#include \"absent.hlsl\"\n" + kTwins, true);
  ASSERT_TRUE(has_errors(result.diagnostics));
  EXPECT_EQ(result.diagnostics[0].line, 1);
  EXPECT_THAT(result.diagnostics[0].message, HasSubstr("cannot find 'absent.hlsl'"));
}

}  // namespace
}  // namespace penumbra::preparation
