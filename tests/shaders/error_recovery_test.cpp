// Every mistake of a text is reported, each once and at its place, and nothing that only follows from
// another.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shaders/compile.h"

namespace penumbra::shaders {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

std::vector<std::string> errors(const std::string& text) {
  CompileRequest request;
  request.file = "a";
  request.text = text;
  request.stage = hlsl::Stage::fragment;
  std::vector<std::string> all;
  for (const hlsl::Diagnostic& said : compile(request).diagnostics)
    all.push_back(std::to_string(said.line) + ":" + std::to_string(said.column) + ": " + said.message);
  return all;
}

const std::string kMain = "float4 Main() : SV_Target {\n    return First(1) + Second(2);\n}\n";

TEST(ErrorRecovery, GoesOnInTheNextFunction) {
  EXPECT_THAT(
      errors(
          "float First(float x) {\n    return one;\n}\nfloat Second(float x)\n{\n    return 2 * two;\n}\n" +
          kMain),
      ElementsAre("2:12: unknown variable 'one'", "6:16: unknown variable 'two'"));
}

TEST(ErrorRecovery, GoesOnInTheSameFunction) {
  EXPECT_THAT(
      errors(
          "float First(float x) {\n    float a = one;\n    x = two;\n    if (x > 1) {\n        x = three;\n  "
          "  }\n    return a + x;\n}\nfloat Second(float x) { return x; }\n" +
          kMain),
      ElementsAre("2:15: unknown variable 'one'", "3:9: unknown variable 'two'",
                  "5:13: unknown variable 'three'"));
}

// Operators of two characters are one token for the parser.
TEST(ErrorRecovery, RemovesTheRightCodeAfterOperators) {
  EXPECT_THAT(
      errors("bool Before(int a) {\n    a += 1; a -= 1; a <<= 2;\n    return a == 1 && a != 2 || a >= 3;\n}\n"
             "float First(float x) {\n    float a = one; float b = 2;\n    return a + b;\n}\n"
             "float Second(float x) { return two; }\n" +
             kMain),
      ElementsAre("6:15: unknown variable 'one'", "9:32: unknown variable 'two'"));
}

TEST(ErrorRecovery, ReadsOnAfterAMissingSemicolon) {
  EXPECT_THAT(
      errors("struct S { float a; };\nS First(float x) {\n    S s;\n    s.a = 1\n    return s;\n}\nfloat "
             "Second(float x) { return two; }\nfloat4 Main() : SV_Target { return First(1).a; }\n"),
      ElementsAre("4:12: expected ';'", "7:32: unknown variable 'two'"));
}

TEST(ErrorRecovery, KeepsTheLinesBehindAnInclude) {
  EXPECT_THAT(
      errors("#line 10 \"a\"\nfloat First(float x) {\n    x = one;\n#line 40 \"a\"\n    return x;\n}\nfloat "
             "Second(float x) { return two; }\n" +
             kMain),
      SizeIs(2));
}

TEST(ErrorRecovery, NamesWhatIsUnknownOnce) {
  EXPECT_THAT(errors("float First(float x) { return one; }\nfloat Second(float x) { return one; }\n" + kMain),
              ElementsAre("1:31: unknown variable 'one'"));
}

TEST(ErrorRecovery, LeavesDeclarationsAtFileScope) {
  EXPECT_THAT(errors("Textur2D t;\nfloat First(float x) { return one; }\n" + kMain), SizeIs(1));
}

TEST(ErrorRecovery, TakesOutOneStatementForEachError) {
  EXPECT_THAT(
      errors("float4 Main(float2 uv : TEXCOORD0) : SV_Target {\n    float4 v = missing(uv);\n    v += two;\n"
             "    v.k = 1;\n    v.x = 2\n    v.y = 3 + four;\n    return v + Foo(1);\n}\n"),
      ElementsAre("2:16: unknown function 'missing'", "3:10: unknown variable 'two'",
                  "4:7: '.k' is not a swizzle", "5:12: expected ';'",
                  "6:15: unknown variable 'four'; did you mean 'Foo'?", "7:16: unknown function 'Foo'"));
}

TEST(ErrorRecovery, SaysNothingOfAReturnThatItTookOut) {
  EXPECT_THAT(errors("float4 Main() : SV_Target {\n    foo(1)\n    return 1;\n}\n"),
              ElementsAre("2:5: unknown function 'foo'"));
}

TEST(ErrorRecovery, NamesTheEntryPointAsItIsWritten) {
  EXPECT_THAT(errors("float4 Main() : SV_Target { }\n"),
              ElementsAre(testing::EndsWith("function 'Main' must return a value")));
}

TEST(ErrorRecovery, EndsAfterSome) {
  std::string text;
  for (int i = 0; i < 50; ++i)
    text += "float F" + std::to_string(i) + "(float x) { return missing" + std::to_string(i) + "; }\n";
  EXPECT_THAT(errors(text + kMain), SizeIs(8));
}

}  // namespace
}  // namespace penumbra::shaders
