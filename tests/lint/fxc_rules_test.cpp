// Tests the rules that stand in for FXC, Unity's compiler, where it is not at hand: what they find, and that
// FXC agrees.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "fxc/at_hand.h"
#include "fxc/judge.h"
#include "lint/linted_shader.h"
#include "lint/text_rules.h"

namespace penumbra::lint {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct Case {
  const char* rule;
  const char* found;  // "line:column" of the finding; empty: nothing is found
  std::string text;
};

const char* const kInputs =
    "Texture2D<float> t; float4 p; float q;\n"
    "struct Small { float a; float b; };\nstruct Large { float4 a; float4 b; float4 c; float4 d; float e; "
    "};\n";

// A fragment shader that returns `result`, with a function from line 4 on.
std::string with_function(const std::string& function, const std::string& result = "F(x)") {
  return kInputs + function + "\nfloat4 Main(float4 x : TEXCOORD0) : SV_Target { return " + result + "; }\n";
}

// A text with the head of a loop and its attribute in line 4, and what the loop does with `v` in line 5.
std::string with_loop(const std::string& head, const std::string& body,
                      const std::string& declared = "float4 v = 0;") {
  return kInputs + std::string("float4 Main(float4 x : TEXCOORD0) : SV_Target { ") + declared + " " + head +
         " {\n" + body + "\n} return v[0] + v[1]; }\n";
}

const char* const kFour = "for (int i = 0; i < 4; ++i)";
const char* const kUnrolled = "[unroll] for (int i = 0; i < 4; ++i)";

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"early-return", "5:1",
       with_function("float F(float4 x) { [branch] if (x.x > q)\nreturn 1;\nreturn q; }")},
      {"early-return", "5:1",
       with_function("float F(float4 x) { if (x.x > q)\nreturn t.Load(int3(0, 0, 0));\nreturn q; }")},
      {"early-return", "5:1",
       with_function(
           "float H(float4 x) { return t.Load(int3(0, 0, 0)); } float F(float4 x) { if (x.x > q)\nreturn "
           "H(x);\nreturn q; }")},
      {"early-return", "5:1",
       with_function(
           "Large F(float4 x) { Large r = (Large)0; if (x.x > q) {\nreturn r;\n} r.a = x; return r; }",
           "F(x).a")},
      {"early-return", "5:1",
       with_function(
           "float F(float4 x) { float a = 1; [branch] if (x.x > q) a = 2; else\nreturn 3;\nreturn a; }")},
      {"early-return", "5:1",
       with_function("float F(float4 x) { [branch] if (x.x > q) { if (x.y > q)\nreturn 1;\n} return q; }")},
      {"early-return", "", with_function("float F(float4 x) { if (x.x > q) return 1; return q; }")},
      {"early-return", "",
       with_function(
           "float F(float4 x) { if (x.y > q) return 1; [branch] if (x.x > q) return 2; return q; }")},
      {"early-return", "",
       with_function("float F(float4 x) { [flatten] if (x.x > q) return t.Load(int3(0, 0, 0)); return q; }")},
      {"early-return", "",
       with_function(
           "float F(float4 x) { [branch] if (x.x > q) return t.Load(int3(0, 0, 0)); else return q; }")},
      {"early-return", "",
       with_function(
           "float F(float4 x) { [loop] for (int i = 0; i < q; ++i) if (t.Load(int3(i, 0, 0)) > q) return i; "
           "return q; }")},
      {"early-return", "",
       with_function("Small F(float4 x) { Small s; if (x.x > q) { s.a = 1; return s; } s.a = 2; s.b = q; "
                     "return s; }",
                     "F(x).a")},
      {"early-return", "",
       with_function("float F(float4 x, int k) { [branch] if (k == 0) return x.x; return q; }", "F(x, 0)")},
      {"early-return", "",
       with_function(
           "void F(float4 x, out float a) { a = 0; [branch] if (x.x > q) { a = t.Load(int3(0, 0, 0)); "
           "return; } a = q; } float G(float4 x) { float a; F(x, a); return a; }",
           "G(x)")},
      {"early-return", "",
       kInputs +
           std::string("float4 Main(float4 x : TEXCOORD0) : SV_Target { [branch] if (x.x > q) return 1; "
                       "return q; }\n")},

      {"indexed-write", "5:27", with_loop(kUnrolled, "if (p[i] > x.x) continue; v[i] = q;")},
      {"indexed-write", "5:27", with_loop(kFour, "if (p[i] > x.x) continue; v[i] += q;")},
      {"indexed-write", "5:40",
       with_loop(kUnrolled, "if (p[i] > x.x) continue; if (q > 1) { v[3 - i] = q; }")},
      {"indexed-write", "5:45",
       with_loop(kUnrolled, "if (q > 0) { if (p[i] > x.x) continue; }    v[i] = q;")},
      {"indexed-write", "5:27",
       with_loop(kUnrolled, "if (p[i] > x.x) continue; v[i] = q;", "float4x4 v = 0;")},
      {"indexed-write", "5:1",
       with_loop("[loop] for (int i = 0; i < 4; ++i)", "v[i] = t.Load(int3(i, 0, 0));")},
      {"indexed-write", "", with_loop(kUnrolled, "if (p[i] <= x.x) v[i] = q;")},
      {"indexed-write", "", with_loop(kUnrolled, "if (p[i] > x.x) continue; v.x += q;")},
      {"indexed-write", "", with_loop(kUnrolled, "if (i == 2) continue; v[i] = q;")},
      {"indexed-write", "", with_loop(kUnrolled, "int k = 2; if (i > k) continue; v[i] = q;")},
      {"indexed-write", "", with_loop(kUnrolled, "if (p[i] > x.x) break; v[i] = q;")},
      {"indexed-write", "", with_loop(kUnrolled, "v[i] = q; if (p[i] > x.x) continue; v += 1;")},
      {"indexed-write", "", with_loop(kUnrolled, "if (p[i] > x.x) { continue; } else { v[i] = q; }")},
      {"indexed-write", "",
       with_loop(kUnrolled, "if (p[i] > x.x) continue; v[i] = q;", "float v[4] = { 0, 0, 0, 0 };")},
      {"indexed-write", "",
       with_loop(kUnrolled, "if (p[i] > x.x) continue; [unroll] for (int j = 0; j < 4; ++j) v[j] += q;")},
      {"indexed-write", "",
       with_loop("[loop] for (int i = 0; i < q; ++i)",
                 "[unroll] for (int j = 0; j < 4; ++j) v[j] += p[j] * i;")},
  };
  return all;
}

TEST(FxcRules, FindWhatTheCasesHave) {
  for (const Case& tried : cases()) {
    std::vector<std::string> places;
    for (const std::string& said : findings_of(tried.rule, tried.text))
      places.push_back(said.substr(0, said.find(' ')));
    EXPECT_EQ(places,
              *tried.found == '\0' ? std::vector<std::string>() : std::vector<std::string>{tried.found})
        << tried.text;
  }
}

TEST(FxcRules, FxcSaysTheSame) {
  PENUMBRA_NEEDS_FXC();
  fxc::Judge fxc(fxc::require_fxc());
  for (const Case& tried : cases()) {
    const fxc::Verdict verdict = fxc.compile({tried.text, "Main", "ps_5_0"});
    const bool early = std::string(tried.rule) == "early-return";
    const bool said = early ? verdict.messages.find("X4000") != std::string::npos : !verdict.compiled;
    EXPECT_EQ(said, *tried.found != '\0') << tried.text << verdict.messages;
  }
}

TEST(FxcRules, TheRemedyIsSaid) {
  EXPECT_THAT(
      findings_of("early-return", cases()[0].text),
      ElementsAre(HasSubstr("'F' for uninitialised because of this return from within a condition: set a "
                            "variable on both sides")));
  EXPECT_THAT(
      findings_of("indexed-write", with_loop(kUnrolled, "if (p[i] > x.x) continue; v[i] = q;")),
      ElementsAre(HasSubstr("'v' is written by index in a loop that FXC, Unity's compiler, cannot unroll, "
                            "because of the 'continue' before it: put the write into the condition")));
}

TEST(GroupsharedInitialiser, EveryThreadWritesItWithFxc) {
  PENUMBRA_NEEDS_FXC();
  fxc::Judge fxc(fxc::require_fxc());
  const auto bytecode = [&](const std::string& initialiser, const std::string& first) {
    return fxc
        .compile({"groupshared uint n" + initialiser +
                      ";\nRWStructuredBuffer<uint> w;\n[numthreads(8, 1, 1)] void Main(uint t : "
                      "SV_GroupIndex) { " +
                      first + " InterlockedAdd(n, t); GroupMemoryBarrierWithGroupSync(); w[t] = n; }\n",
                  "Main", "cs_5_0"})
        .bytecode;
  };
  EXPECT_FALSE(bytecode(" = 3", "").empty());
  EXPECT_EQ(bytecode(" = 3", ""), bytecode("", "n = 3;"));
}

std::vector<std::string> names_in(const std::string& text) {
  hlsl::SourceFiles sources;
  sources.add("Test.hlsl", text);
  return told(reserved_name_findings(text, "Test.hlsl", sources));
}

// The words in the list of the page.
std::vector<std::string> words_of_page() {
  std::ifstream stream(std::filesystem::path(PENUMBRA_SOURCE_DIR) / "docs" / "lint.md");
  std::string page{std::istreambuf_iterator<char>(stream), {}};
  page.erase(0, page.find("### reserved-name"));
  const std::size_t begin = page.find("```\n") + 4;
  std::istringstream list(page.substr(begin, page.find("```", begin) - begin));
  return {std::istream_iterator<std::string>(list), {}};
}

std::string with_local(const std::string& word) {
  return fragment("    float " + word + " = uv.x;\n", word);
}

TEST(ReservedNames, EveryWordOfThePageIsFoundAndGlslangTakesIt) {
  const std::vector<std::string> words = words_of_page();
  EXPECT_THAT(words, SizeIs(testing::Gt(30)));
  for (const std::string& word : words) {
    EXPECT_THAT(names_in(with_local(word)), ElementsAre(HasSubstr("'" + word + "' is a reserved word")))
        << word;
    shaders::CompileRequest request;
    request.file = "Test.hlsl";
    request.text = with_local(word);
    request.stage = hlsl::Stage::fragment;
    request.prepare = true;
    EXPECT_FALSE(shaders::compile(request).spirv.empty()) << word;
  }
}

TEST(ReservedNames, FxcRefusesEveryWordOfThePage) {
  PENUMBRA_NEEDS_FXC();
  fxc::Judge fxc(fxc::require_fxc());
  for (const std::string& word : words_of_page())
    EXPECT_FALSE(fxc.compile({with_local(word), "Main", "ps_5_0"}).compiled) << word;
}

TEST(ReservedNames, AreFoundWhereverTheyAreDeclared) {
  EXPECT_THAT(
      names_in("float4 Main() : SV_Target\n{\n    int pass = 1; return pass;\n}\n"),
      ElementsAre("3:9 warning reserved-name: 'pass' is a reserved word of FXC, Unity's compiler: choose "
                  "another name"));
  for (const char* text :
       {"float compile(float a) { return a; }", "float F(float4 pass, float b) { return b; }",
        "float F(float a, float decl) { return a; }", "struct S { float asm; };", "float export;",
        "struct pass { float a; };", "cbuffer technique { float a; };",
        "static const float fxgroup[2] = { 1, 2 };", "Texture2D<float4> compile;",
        "Texture2D compile : register(t0);", "float a, pass;", "float PASS, b;", "float4 Technique;",
        "float a = 1, decl = 2;"})
    EXPECT_THAT(names_in(text), SizeIs(1)) << text;
}

TEST(ReservedNames, OtherWordsAndPlacesAreNotTold) {
  for (const char* text :
       {"Texture2D t : register(t0);", "export float F() { return 1; }", "RasterizerState state;",
        "interface I { float F(); };", "float Compile, passes, sample, precise, Asm_fragment, STRING;",
        "float a = b > NULL ? c : d;", "float F() { return NULL; }",
        "inline float F(linear float2 uv) { return 1; }"})
    EXPECT_THAT(names_in(text), IsEmpty()) << text;
}

// Comments become blanks, of as many lines.
std::string without_comments(std::string text) {
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    const bool line = text.compare(at, 2, "//") == 0;
    if (!line && text.compare(at, 2, "/*") != 0) continue;
    const std::size_t end = std::min(text.find(line ? "\n" : "*/", at), text.size());
    for (; at < end; ++at)
      if (text[at] != '\n') text[at] = ' ';
    if (!line && end < text.size()) text[end] = text[end + 1] = ' ';
  }
  return text;
}

TEST(ReservedNames, OurOwnFilesHaveNone) {
  std::size_t files = 0;
  for (const char* folder : {"ShaderLibrary", "Shaders", "Samples~"})
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(PENUMBRA_SOURCE_DIR) / folder)) {
      const std::string kind = entry.path().extension().string();
      if (kind != ".hlsl" && kind != ".shader" && kind != ".compute") continue;
      ++files;
      std::ifstream stream(entry.path());
      const std::string text{std::istreambuf_iterator<char>(stream), {}};
      EXPECT_THAT(names_in(without_comments(text)), IsEmpty()) << entry.path();
    }
  EXPECT_GT(files, 100U);
}

}  // namespace
}  // namespace penumbra::lint
