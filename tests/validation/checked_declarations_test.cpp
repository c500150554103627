// Declarations that were looked at before change nothing but time: messages and modules are those of a text
// on its own.
#include "validation/checked_declarations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "shaders/source_memory.h"

namespace penumbra::validation {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

shaders::CompileRequest request_for(const std::string& text) {
  shaders::CompileRequest request;
  request.file = "shader.hlsl";
  request.text = text;
  request.stage = hlsl::Stage::fragment;
  request.prepare = true;
  return request;
}

shaders::CompileResult compiled(CheckedDeclarations& declarations, const std::string& text) {
  const shaders::CompileRequest request = request_for(text);
  shaders::SourceMemory memory;
  return declarations.compile(request, shaders::expand(request, memory));
}

shaders::CompileResult whole(const std::string& text) {
  const shaders::CompileRequest request = request_for(text);
  shaders::SourceMemory memory;
  return compile_whole(request, shaders::expand(request, memory));
}

std::set<std::string> told(const shaders::CompileResult& result) {
  std::set<std::string> messages;
  for (const hlsl::Diagnostic& message : result.diagnostics) messages.insert(hlsl::format(message));
  return messages;
}

const std::string kMain = "float4 Main(float4 p : TEXCOORD0) : SV_Target { return p; }\n";

TEST(CheckedDeclarations, WhatIsNotReachedIsLookedAt) {
  CheckedDeclarations declarations;
  EXPECT_THAT(compiled(declarations, "float unused(float x) { return x; }\n" + kMain).diagnostics, IsEmpty());
  const auto result = compiled(declarations, "float unused(float x) { return y; }\n" + kMain);
  ASSERT_THAT(result.diagnostics, SizeIs(1));
  EXPECT_THAT(hlsl::format(result.diagnostics[0]), HasSubstr("shader.hlsl:1:32: error"));
  EXPECT_THAT(result.spirv, IsEmpty());
}

// The function is the same, but what it calls has changed.
TEST(CheckedDeclarations, WhatAKnownFunctionRestsOnIsNotForgotten) {
  CheckedDeclarations declarations;
  const std::string unused = "float unused() { return g(float3(1, 2, 3)).y; }\n";
  EXPECT_THAT(compiled(declarations, "float2 g(float3 v) { return v.xy; }\n" + unused + kMain).diagnostics,
              IsEmpty());
  EXPECT_TRUE(hlsl::has_errors(
      compiled(declarations, "float2 g(float4 v) { return v.xy; }\n" + unused + kMain).diagnostics));
  EXPECT_TRUE(hlsl::has_errors(compiled(declarations, "\n" + unused + kMain).diagnostics));
  EXPECT_THAT(compiled(declarations, "float2 g(float3 v) { return v.xy; }\n" + unused + kMain).diagnostics,
              IsEmpty());
}

TEST(CheckedDeclarations, AMessageIsSaidOfEveryVariant) {
  const std::string twins =
      "half f(half x) { return x; }\nfloat f(float x) { return x; }\nfloat other() { return 1; }\n";
  CheckedDeclarations declarations;
  const std::set<std::string> expected = told(whole(twins + kMain));
  ASSERT_THAT(expected, SizeIs(1)) << "which of the two is kept";
  EXPECT_EQ(told(compiled(declarations, twins + kMain)), expected);
  EXPECT_EQ(told(compiled(declarations, twins + "float more;\n" + kMain)), expected);
}

TEST(CheckedDeclarations, TheModuleDoesNotDependOnWhatCameBefore) {
  const std::string text =
      "static const float table[3] = { 0.25, 0.5, 0.75 };\nfloat a(float x) { return x * 0.5; }\n"
      "float b(float x) { return a(x) + table[1]; }\n"
      "float4 Main(float4 p : TEXCOORD0) : SV_Target { return a(p.x) + 0.75; }\n";
  CheckedDeclarations fresh;
  const shaders::CompileResult first = compiled(fresh, text);
  ASSERT_FALSE(first.spirv.empty());
  EXPECT_EQ(compiled(fresh, text).spirv, first.spirv);
  CheckedDeclarations other;
  compiled(other, "static const float table[3] = { 0.25, 0.5, 0.75 };\n" + kMain);
  EXPECT_EQ(compiled(other, text).spirv, first.spirv);
}

// The difference is not reached: the module and what is said of it are the same, files and other notes are
// not.
TEST(CheckedDeclarations, EqualReachedTextsAreCompiledOnce) {
  const std::string twins = "half f(half x) { return x; }\nfloat f(float x) { return x; }\n";
  const std::string main = "float4 Main(float4 p : TEXCOORD0) : SV_Target { return p * f(p.x); }\n";
  CheckedDeclarations declarations;
  const shaders::CompileResult first = compiled(declarations, "float a() { return 1; }\n" + twins + main);
  const shaders::CompileResult second = compiled(declarations, "float a() { return 2; }\n" + twins + main);
  ASSERT_FALSE(first.spirv.empty());
  EXPECT_EQ(second.spirv, first.spirv);
  EXPECT_THAT(told(first), SizeIs(1)) << "which of the two is kept";
  EXPECT_EQ(told(second), told(first));
  EXPECT_THAT(second.sources.text("shader.hlsl"), HasSubstr("return 2;"));
  const shaders::CompileResult moved = compiled(declarations, "\n\nfloat a() { return 1; }\n" + twins + main);
  EXPECT_NE(told(moved), told(first)) << "lines are part of the text";
}

TEST(CheckedDeclarations, EntryPointsOfOneTextAreApart) {
  const std::string text =
      "float4 One() : SV_Target { return 1; }\nfloat4 Two() : SV_Target { return 2; }\nfloat c;\n";
  CheckedDeclarations declarations;
  shaders::SourceMemory memory;
  std::set<std::vector<std::uint32_t>> modules;
  for (const char* entry : {"One", "Two", "One"}) {
    shaders::CompileRequest request = request_for(text);
    request.entry = entry;
    modules.insert(declarations.compile(request, shaders::expand(request, memory)).spirv);
  }
  EXPECT_THAT(modules, SizeIs(2));
}

// Texts of functions that call and overload each other; something is wrong with many. All are made of few
// parts, so that most parts have been met before, elsewhere and in other company.
class RandomTexts {
 public:
  explicit RandomTexts(unsigned seed) : random_(seed) {}

  std::string next() {
    std::string text = often("struct S { float " + often("a", "b") + "; };\n");
    text += often("cbuffer B { S m; " + often("float", "float2") + " u; };\n");
    text += often("static const float c = " + often("2", "u") + ";\n");
    text += often("static const float t[2] = { 1, " + often("2", "c") + " };\n");
    for (defined_ = 0; defined_ < 6; ++defined_) text += often(function());
    return text + "float4 Main(float4 v : TEXCOORD0) : SV_Target { return " + expression("v.x") + "; }\n";
  }

 private:
  bool rarely() { return random_() % 16 == 0; }
  std::string often(const std::string& text, const std::string& otherwise = "\n") {
    return rarely() ? otherwise : text;
  }

  std::string function() {
    const std::string name = "f" + std::to_string(defined_);
    const std::string parameter = often("float x", "half x");
    std::string text = rarely() ? "float f" + std::to_string(random_() % 6) + "(float x);\n" : "\n";
    if (rarely()) text += "half " + name + "(half x) { return x; }\n";
    return text + "float " + name + "(" + parameter + ") { return " + expression("x") + "; }\n";
  }

  std::string expression(const std::string& argument) {
    if (rarely()) return "missing";
    const unsigned callees = defined_ == 0 || rarely() ? 6 : defined_;
    switch (random_() % 5) {
      case 0:
        return "m.a";
      case 1:
        return "t[1] + c";
      case 2:
        return "u";
      default:
        return "f" + std::to_string(random_() % callees) + "(" + argument + ")";
    }
  }

  std::mt19937 random_;
  unsigned defined_ = 0;
};

// The function's callers, reached or not, differ from text to text; without a reached one they do not matter.
TEST(CheckedDeclarations, OverloadsThatAreNotReachedDoNotDependOnTheirCallers) {
  const std::string twins = "half f(half x) { return x; }\nfloat f(float x) { return 2 * x; }\n";
  CheckedDeclarations declarations;
  const std::set<std::string> expected = told(compiled(declarations, twins + kMain));
  ASSERT_THAT(expected, SizeIs(1));
  const std::string caller = "float c() { return f(half(1)); }\n" + kMain;
  EXPECT_EQ(told(compiled(declarations, twins + caller)), expected);
  EXPECT_EQ(told(whole(twins + caller)), expected);
}

// The error is in a function of the first text alone; all texts share what is right.
TEST(CheckedDeclarations, ErrorsAreThoseOfEachText) {
  const auto text = [](const std::string& body, const std::string& main) {
    return "float a() { return 1; }\nfloat b() { return " + body + "; }\nfloat near() { return 2; }\n" + main;
  };
  const std::string reaching = "float4 Main() : SV_Target { return b(); }\n";
  CheckedDeclarations declarations;
  for (const std::string& main : {kMain, reaching})
    for (const char* body : {"neer()", "a()", "neer()", "missing", "a()"})
      EXPECT_EQ(told(compiled(declarations, text(body, main))), told(whole(text(body, main)))) << body;
  EXPECT_THAT(told(whole(text("neer()", kMain))),
              testing::ElementsAre(HasSubstr("no matching overloaded function found 'neer'")));
}

class RandomDeclarations : public testing::TestWithParam<unsigned> {};

INSTANTIATE_TEST_SUITE_P(Seeds, RandomDeclarations, testing::Values(11, 14, 15));

TEST_P(RandomDeclarations, SayWhatIsSaidOfTheTextAlone) {
  CheckedDeclarations declarations;  // declarations of all texts
  RandomTexts texts(GetParam());
  int good = 0;
  int bad = 0;
  for (int i = 0; i < 700; ++i) {
    const std::string text = texts.next();
    const shaders::CompileResult alone = whole(text);
    const shaders::CompileResult after_others = compiled(declarations, text);
    ASSERT_EQ(told(after_others), told(alone)) << text;
    ASSERT_EQ(after_others.spirv.empty(), alone.spirv.empty()) << text;
    CheckedDeclarations fresh;
    if (i % 8 == 0) {
      ASSERT_EQ(after_others.spirv, compiled(fresh, text).spirv) << text;
    }
    ++(alone.spirv.empty() ? bad : good);
  }
  EXPECT_GT(good, 100);
  EXPECT_GT(bad, 100);
}

}  // namespace
}  // namespace penumbra::validation
