#include "hlsl/reach.h"

#include <gmock/gmock.h>

#include <sstream>

namespace penumbra::hlsl {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

// The text that is left when only the entry point counts, without empty lines.
std::vector<std::string> left_of(const std::string& text, std::string_view entry = "Main") {
  std::istringstream lines(Reach(text, "main.hlsl", entry).text_with({}));
  std::vector<std::string> left;
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(' ') != std::string::npos) left.push_back(line);
  return left;
}

std::vector<std::string> unreached(const std::string& text) {
  return Reach(text, "main.hlsl", "Main").unreached();
}

TEST(Reach, WhatNothingSpellsGoes) {
  EXPECT_THAT(left_of("float a() { return 1; }\n"
                      "float b() { return a(); }\n"
                      "float c() { return b(); }\n"
                      "float4 Main() : SV_Target { return a(); }\n"),
              ElementsAre("float a() { return 1; }", "float4 Main() : SV_Target { return a(); }"));
}

TEST(Reach, OverloadsAndPrototypesGoTogether) {
  EXPECT_THAT(
      left_of("float a(float x);\nfloat a(float x) { return x; }\nfloat a(float2 x) { return x.x; }\n"
              "float b(float x);\nfloat b(float x) { return x; }\n"
              "float4 Main() : SV_Target { return a(1.0); }\n"),
      ElementsAre("float a(float x);", "float a(float x) { return x; }", "float a(float2 x) { return x.x; }",
                  "float4 Main() : SV_Target { return a(1.0); }"));
}

TEST(Reach, StaticConstantsGoAndOtherVariablesStay) {
  EXPECT_THAT(left_of("static const float a[2] = { 1, 2 };\n"
                      "static const float b = a[0];\n"
                      "static const float c = 1, d = 2;\n"
                      "static float e = 1;\n"
                      "const float f = 1;\n"
                      "Texture2D t;\n"
                      "float4 Main() : SV_Target { return 1; }\n"),
              ElementsAre("static const float c = 1, d = 2;", "static float e = 1;", "const float f = 1;",
                          "Texture2D t;", "float4 Main() : SV_Target { return 1; }"));
}

TEST(Reach, TypesBuffersAndAttributesReach) {
  EXPECT_THAT(unreached("float a() { return 1; }\nstruct S { float v; float get() { return a(); } };\n"
                        "static const int n = 2;\ncbuffer B { float4 all[n]; };\n"
                        "float p() { return 1; }\nfloat Unused() { return 1; }\n"
                        "[patchconstantfunc(\"p\")]\nfloat4 Main() : SV_Target { return 1; }\n"),
              SizeIs(1));
}

TEST(Reach, LinesKeepTheirNumbers) {
  const std::string text =
      "#line 10 \"a.hlsl\"\nfloat a(\n  float x)\n{\n#line 40 \"b.hlsl\"\n  return x;\n} float4 Main() : "
      "SV_Target { return 1; }\n";
  EXPECT_EQ(Reach(text, "main.hlsl", "Main").text_with({}),
            "#line 10 \"a.hlsl\"\n\n\n\n#line 40 \"b.hlsl\"\n\n float4 Main() : SV_Target { return 1; }\n");
}

TEST(Reach, WhatIsAskedForStaysWithAllThatItReaches) {
  const std::string text =
      "float a() { return 1; }\nfloat b() { return a(); }\nfloat c() { return 2; }\n"
      "float4 Main() : SV_Target { return 1; }\n";
  const Reach reach(text, "main.hlsl", "Main");
  ASSERT_THAT(reach.unreached(), SizeIs(3));
  const std::string with_b = reach.text_with({1});
  EXPECT_THAT(with_b, HasSubstr("float a()"));
  EXPECT_THAT(with_b, HasSubstr("float b()"));
  EXPECT_THAT(with_b, Not(HasSubstr("float c()")));
  EXPECT_EQ(reach.text_with({0, 1, 2}), text);
}

TEST(Reach, AMessageBelongsToTheDeclarationsOfItsLine) {
  const std::string text =
      "float a() { return 1; } float b()\n{ return 2; }\n#line 1 \"x.hlsl\"\nfloat c() { return 3; }\n"
      "float4 Main() : SV_Target { return 1; }\n";
  const Reach reach(text, "main.hlsl", "Main");
  const auto at = [&](const char* file, int line) {
    return reach.at({file, line, 0, Severity::note, "", ""});
  };
  EXPECT_THAT(at("main.hlsl", 1), ElementsAre(0, 1));
  EXPECT_THAT(at("main.hlsl", 2), ElementsAre(1));
  EXPECT_THAT(at("x.hlsl", 1), ElementsAre(2));
  EXPECT_THAT(at("x.hlsl", 2), IsEmpty()) << "the entry point's own";
}

// The key of `f`, which stands after `before`, on line 9.
std::string key_of_f(const std::string& before, const std::string& f = "float f() { return g(v) + s.a; }",
                     const std::string& after = "") {
  const std::string text =
      before + "\n#line 9\n" + f + "\n" + after + "\nfloat4 Main() : SV_Target { return 1; }\n";
  const Reach reach(text, "main.hlsl", "Main");
  for (std::size_t i = 0; i < reach.unreached().size(); ++i)
    if (reach.at({"main.hlsl", 9, 0, Severity::note, "", ""}) == std::vector<std::size_t>{i})
      return reach.unreached()[i];
  return "none";
}

const std::string kBase =
    "#line 1\nstruct S { float a; };\n#line 2\ncbuffer B { S s; float v; };\n#line 3\nfloat h() { return 1; "
    "}\n"
    "#line 4\nfloat g(float x) { return h(); }\n";

TEST(Reach, AKeyIsTheSameForTheSameAndWhatItRestsOn) {
  ASSERT_NE(key_of_f(kBase), "none");
  EXPECT_EQ(key_of_f(kBase), key_of_f(kBase));
  EXPECT_EQ(key_of_f(kBase + "float unrelated() { return 1; }\n"), key_of_f(kBase));
  EXPECT_EQ(key_of_f(kBase, "float f() { return g(v) + s.a; }", "float g(int x) { return 2; }\n"),
            key_of_f(kBase))
      << "declared after it";
}

TEST(Reach, AKeyChangesWithEverythingItRestsOn) {
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = kBase;
    text.replace(text.find(from), from.size(), to);
    return key_of_f(text);
  };
  const std::string key = key_of_f(kBase);
  EXPECT_NE(key_of_f(kBase, "float f() { return g(v) - s.a; }"), key) << "its text";
  EXPECT_NE(changed("float x", "int x"), key) << "a signature";
  EXPECT_NE(changed("return 1", "return 2"), key) << "the body of what is called by what it calls";
  EXPECT_NE(changed("float a;", "int a;"), key) << "a type, by a buffer's member";
  EXPECT_NE(changed("float v", "int v"), key) << "a buffer's member";
  EXPECT_NE(changed("#line 4", "#line 5"), key) << "the place of a message that may name it";
  EXPECT_NE(key_of_f(kBase + "#line 5\nfloat g(int x) { return 2; }\n"), key) << "one more overload";
  EXPECT_NE(key_of_f(kBase + "static float g;\n"), key) << "another meaning";
}

TEST(Reach, TextsThatAreNoneEndWell) {
  for (const char* text :
       {"", "}", "float a() {", "float a(", "(((", "static const", "float Main() { return a("})
    EXPECT_EQ(Reach(text, "main.hlsl", "Main").text_with({}).size() > 0, *text != '\0') << text;
}

}  // namespace
}  // namespace penumbra::hlsl
