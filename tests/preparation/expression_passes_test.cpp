// Tests the rewriting of expressions: what is put where, and what is left alone.
#include <gmock/gmock.h>

#include "preparation/declarators.h"
#include "preparation/passes.h"

namespace penumbra::preparation {
namespace {

using testing::HasSubstr;
using testing::Not;

// The text with one blank between any two tokens.
std::string spaced(const TokenText& tokens) {
  std::string text;
  for (const hlsl::Token& token : tokens.tokens())
    text += (text.empty() ? "" : " ") + std::string(token.spelling);
  return text;
}
std::string spaced(const std::string& text) {
  return spaced(TokenText(text, "m"));
}

template <void (*Pass)(TokenText&)>
std::string spaced_after(const std::string& text) {
  TokenText tokens(text, "m");
  Pass(tokens);
  return spaced(tokens);
}

template <void (*Pass)(TokenText&)>
void expect_untouched(const std::string& text) {
  EXPECT_EQ(spaced_after<Pass>(text), spaced(text));
}

TEST(MatrixSwizzles, ReadsBecomeCalls) {
  EXPECT_THAT(spaced_after<write_out_matrix_swizzles>("float f() { return mul(A[i], B)._m00_m11.x; }"),
              HasSubstr(spaced("return penumbra_swizzle_m00_m11 ( mul(A[i], B) ).x;")));
  EXPECT_THAT(
      spaced_after<write_out_matrix_swizzles>("float f() { return -(a + b)._11_22.x * s.m._11_22.y; }"),
      HasSubstr(spaced("return - penumbra_swizzle_11_22 ( (a + b) ).x * penumbra_swizzle_11_22 ( s.m ).y;")));
}

TEST(MatrixSwizzles, SinglesOddNamesAndMembersStay) {
  for (const char* text : {"float f() { return m._m00 + m._11; }", "float f() { return m._m00_m; }",
                           "float f() { return m._m00_11 + m._45_11 + m._m04_m00 + _m00_m11; }",
                           "struct S { float2 _11_22; }; float f(S s) { return s._11_22.x; }"})
    expect_untouched<write_out_matrix_swizzles>(text);
}

TEST(MatrixSwizzles, AssignmentsThatCannotBeRepeatedStay) {
  expect_untouched<write_out_matrix_swizzles>("void f() { m[i++]._11_22 = v; }");
  expect_untouched<write_out_matrix_swizzles>("void f() { a = m._11_22 += v; }");
}

TEST(UniformWrites, OnlyWrittenUniformsGetACopy) {
  const auto run = spaced_after<copy_written_uniforms>;
  EXPECT_THAT(
      run("float a, b[2]; void f() { b[1] += a; }"),
      HasSubstr(spaced(
          "float a, b[2]; static float penumbra_copy_b [2] = b ; void f() { penumbra_copy_b [1] += a; }")));
  EXPECT_THAT(run("cbuffer C { float4 a; } void f() { a.x = 1; } float g() { return a.y; }"),
              HasSubstr(spaced("float g() { return penumbra_copy_a .y; }")));
  EXPECT_THAT(run("float a; void g(float x, out float y) { y = x; } void f() { g(1, a); }"),
              HasSubstr(spaced("g(1, penumbra_copy_a )")));
}

TEST(UniformWrites, ReadsLocalsMembersAndStaticsStay) {
  for (const char* text :
       {"float a; float f() { return a == 1; }", "float a; void f() { float a = 1; a += 2; }",
        "float a; void f(float a) { a += 2; }", "static float a; void f() { a = 1; }",
        "float a; void f() { s.a = 1; }", "float a; void g(float x); void f() { g(a); }",
        "RWTexture2D<float> a; void f() { a[int2(0, 0)] = 1; }", "groupshared float a; void f() { a = 1; }"})
    expect_untouched<copy_written_uniforms>(text);
}

TEST(Declarators, AreReadWithTheirTypeAndSize) {
  const TokenText text("row_major static const float4x4 a, b[2][3] = { 1 }, c : register(c1);", "m");
  const std::vector<Declarator> list = declarators(text, 0, text.size() - 1);
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[1].type, "float4x4");
  EXPECT_TRUE(list[1].is_static && list[1].is_const);
  EXPECT_EQ(text.spelled(list[1].dimensions, list[1].dimension_count), "[2][3]");
  EXPECT_EQ(text[list[1].initialiser].spelling, "{");
  EXPECT_EQ(text[list[2].name].spelling, "c");
  const TokenText function("float f(int x)", "m");
  EXPECT_TRUE(declarators(function, 0, function.size()).empty());
}

// No text makes a pass read out of bounds or run without end; the test is run under the sanitizers.
TEST(ExpressionPasses, AnyTokensAreRead) {
  const std::vector<std::string> words{
      "float", "f",      "(",   ")",        "{",      "}",   "[",       "]",      ";",      ",",    ".",
      "=",     "+",      "-",   "<",        ">",      "a",   "cbuffer", "C",      "if",     "else", "case",
      ":",     "struct", "out", "_m00_m11", "_11_22", "mad", "ldexp",   "static", "return", "1"};
  std::uint32_t state = 1;
  const auto next = [&] { return (state = state * 1664525u + 1013904223u) >> 8; };
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (std::uint32_t i = next() % 30; i > 0; --i)
      text += words[next() % words.size()] + (next() % 2 == 0 ? " " : "");
    TokenText tokens(text, "m");
    write_out_matrix_swizzles(tokens);
    copy_written_uniforms(tokens);
    EXPECT_LT(tokens.size(), 20000u);
  }
}

}  // namespace
}  // namespace penumbra::preparation
