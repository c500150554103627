// Tests expressions and declarations that HLSL refuses and glslang crashes on, or drops without a word.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "preparation/prepare.h"

namespace penumbra::preparation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> errors_in(const std::string& text, bool dxc = false) {
  std::vector<std::string> all;
  for (const hlsl::Diagnostic& note :
       prepare(text, "a", EntryPoint{"Frag", hlsl::Stage::fragment, dxc}).notes)
    if (note.severity == hlsl::Severity::error)
      all.push_back(std::to_string(note.line) + ": " + note.message);
  return all;
}

std::vector<std::string> errors_of(const std::string& body) {
  return errors_in(
      "int n; struct S { float a; float2 b; }; static const int K = 3; float f(float x) { return x; }\n"
      "float4 Frag(float4 p : SV_Position) : SV_Target {\n" +
      body + "\nreturn 1; }\n");
}

TEST(Conditions, HaveNoMoreComponentsThanTheirValues) {
  EXPECT_THAT(errors_of("float3 q = p > 0 ? p.xyz : 1;"),
              ElementsAre("3: the condition before this '?' has 4 components, and its values have 3 (X3019): "
                          "give the condition 3 as well, as in (p.xyz > 0)"));
  EXPECT_THAT(errors_of("float2 q = p.xyz > 0 ? p.xy : 0;"), ElementsAre(HasSubstr("has 3 components")));
  EXPECT_THAT(errors_of("bool4 b = p > 0;\nfloat3 q; q = b ? p.xyz : 1;"), ElementsAre(HasSubstr("4: the")));
  for (const char* refused :
       {"return (p > 0 ? p.xyz : p.xyz).xyzz;", "return p ? 1 : float3(1, 2, 3);",
        "return p == p ? 1 : p.xyz;", "float3 q = p > (p > 0 ? p.xyz : 1).xyzz ? p.xyz : 1;"})
    EXPECT_THAT(errors_of(refused), testing::Contains(HasSubstr("the condition before this '?'"))) << refused;
  for (const char* taken :
       {"float4 q = p > 0 ? p : 1;", "float4 q = p > 0 ? 1 : 0;", "float3 q = p.x > 0 ? p.xyz : 1;",
        "float3 q = all(p > 0) ? p.xyz : p;", "float3 q = p.xyz > 0 ? p.xyz : p.yyy;"})
    EXPECT_THAT(errors_of(taken), IsEmpty()) << taken;
}

TEST(Declarators, AreFollowedByACommaOrASemicolon) {
  EXPECT_THAT(errors_of("int i = 3 j = 4;"), ElementsAre("3: expected ',' or ';' before 'j'"));
  EXPECT_THAT(errors_of("float x, z;\nfloat y = x z;"), ElementsAre("4: expected ',' or ';' before 'z'"));
  EXPECT_THAT(errors_of("float y = 1 bogus;"), ElementsAre("3: expected ',' or ';' before 'bogus'"));
  EXPECT_THAT(errors_of("int j; for (int i = 0 j; i < 3; ++i) { }"), ElementsAre(HasSubstr("before 'j'")));
  EXPECT_THAT(errors_of("float c, y = f(1) c;"), ElementsAre(HasSubstr("before 'c'")));
  EXPECT_THAT(errors_of("S s; float t = s.a 2;"), ElementsAre(HasSubstr("before '2'")));
  EXPECT_THAT(errors_in("float a b;"), ElementsAre("1: expected ',' or ';' before 'b'"));
  EXPECT_THAT(
      errors_in(
          "float const a; static const float b = 1; Texture2D<float4> t; unsigned int u;\n"
          "float4 f(in float x, const int y) { [unroll(8)] for (;;) if (x) return 0.xxxx; else "
          "return (float)x; switch (y) { case 1: x = 2; break; default: x = y; break; } return f(x); }"),
      IsEmpty());
}

TEST(CaseLabels, AreConstantIntegersOfOneCaseEach) {
  const auto of = [](const std::string& cases) {
    return errors_of("const int k = 2, v = n; switch (n) {\n" + cases + "\ndefault: return 2; }");
  };
  EXPECT_THAT(of("case n: return 1;"),
              ElementsAre("4: a case label must be a constant, and 'n' is not: use a "
                          "number, a static const, or if and else"));
  EXPECT_THAT(of("case n + 1: return 1;"), ElementsAre(HasSubstr("must be a constant")));
  EXPECT_THAT(of("case f(1): return 1;"), ElementsAre(HasSubstr("'f' is not")));
  EXPECT_THAT(of("case v: return 1;"), ElementsAre(HasSubstr("'v' is not")));
  EXPECT_THAT(of("case 1.5: return 1;"),
              ElementsAre("4: a case label must be an integer, and this is '1.5'"));
  EXPECT_THAT(of("case 3: return 1;\ncase K: return 2;"),
              ElementsAre("5: the switch has case 3 already, in line 4: remove one of the two"));
  EXPECT_THAT(of("case k: case 0x10: case -1: case 1: case (int)4: case K + 1: case max(6, 7): return 2;"),
              IsEmpty());
  EXPECT_THAT(of("case 1: switch (n) { case 1: return 1; default: return 2; }\ncase 2: return 1;"),
              IsEmpty());
}

TEST(Operators, TakeNumbersAndBitOperatorsIntegers) {
  EXPECT_THAT(errors_of("S s, t; return s == t;"),
              ElementsAre("3: '==' compares numbers, and 's' is a struct: compare its members"));
  EXPECT_THAT(errors_of("float a[2], b[2]; return a != b;"),
              ElementsAre("3: '!=' compares numbers, and 'a' is an array: compare its elements"));
  EXPECT_THAT(errors_of("return 1 & 2.5;"), ElementsAre(HasSubstr("'&' takes integers")));
  EXPECT_THAT(errors_of("return 1.5 << 2;"), ElementsAre(HasSubstr("'<<' takes integers")));
  EXPECT_THAT(errors_of("return (7UL >> 1L) & 0xFFUL;"), IsEmpty())
      << "a suffix L makes no float of an integer";
  EXPECT_THAT(errors_of("return dot(uint2(n, n), uint2(1, 2)) ^ n;"), IsEmpty());
  EXPECT_THAT(errors_of("S s; float a[2]; return ~n ^ n << 2 | (n && p.x) || p.y == a[1] || s.a != 1;"),
              IsEmpty());
}

TEST(Nesting, HasALimit) {
  const auto repeated = [](const std::string& part, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += part;
    return all;
  };
  const auto is_deep = ElementsAre("3: more than 1000 levels of nesting: split it");
  EXPECT_THAT(errors_of("return " + repeated("(", 20000) + "p" + repeated(")", 20000) + ";"), is_deep);
  EXPECT_THAT(errors_of("return " + repeated("- ", 50000) + "p;"), is_deep);
  EXPECT_THAT(errors_of("return " + repeated("(int)", 20000) + "p;"), is_deep);
  EXPECT_THAT(errors_of(repeated("if (n) ", 20000) + ";"), is_deep);
  EXPECT_THAT(errors_of("return " + repeated("p + ", 20000) + "p;"),
              ElementsAre("3: more than 8000 operators in one expression: split it"));
  EXPECT_THAT(errors_of("return " + repeated("(", 900) + "p" + repeated(")", 900) + ";"), IsEmpty());
  EXPECT_THAT(errors_of(repeated("n = -n * 2;", 20000)), IsEmpty());
}

}  // namespace
}  // namespace penumbra::preparation
