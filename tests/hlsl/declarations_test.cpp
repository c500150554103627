#include "hlsl/declarations.h"

#include <gmock/gmock.h>

namespace penumbra::hlsl {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Kind = Declaration::Kind;

const char* kind_name(Kind kind) {
  constexpr const char* names[] = {"function", "prototype", "structure", "buffer",
                                   "variable", "alias",     "empty",     "other"};
  return names[static_cast<int>(kind)];
}

// The text "kind scope::name" of each declaration.
std::vector<std::string> declared_in(const std::string& text) {
  const std::vector<Token> tokens = lex(text);
  std::vector<std::string> list;
  for (const Declaration& declaration : read_declarations(tokens)) {
    std::string line = kind_name(declaration.kind);
    if (declaration.name != Declaration::none)
      line += " " + declaration.scope + std::string(tokens[declaration.name].spelling);
    list.push_back(line);
  }
  return list;
}

TEST(Declarations, TellsDeclarationsApart) {
  EXPECT_THAT(declared_in("float f(float x) { return x; } float f(float x); struct S { float a; } s, t;\n"
                          "cbuffer C : register(b0) { float a; } float4 v : register(c1), w;\n"
                          "typedef float real; ; Texture2D<float4> t : register(t0);\n"
                          "static const float a[2] = { 1, 2 }; SamplerState s { Filter = POINT; };"),
              ElementsAre("function f", "prototype f", "structure S", "buffer C", "variable v", "alias",
                          "empty", "variable t", "variable a", "variable s"));
}

TEST(Declarations, AttributesSemanticsAndScopesBelongToTheDeclaration) {
  const std::string text =
      "namespace A { [numthreads(8, 8, 1)] float4 f(uint3 i : SV_DispatchThreadID) : SV_Target { } } struct "
      "T g() {}";
  EXPECT_THAT(declared_in(text), ElementsAre("function A::f", "function g"));
  const std::vector<Token> tokens = lex(text);
  const Declaration f = read_declarations(tokens)[0];
  EXPECT_EQ(tokens[f.first].spelling, "[");
  EXPECT_EQ(tokens[f.type].spelling, "float4");
  EXPECT_EQ(tokens[f.last].spelling, "}");
  EXPECT_THAT(parameter_types(tokens, f), ElementsAre("uint3"));
}

TEST(Declarations, WhatIsNeverClosedIsLeftOut) {
  EXPECT_THAT(declared_in("float f(float x) {"), IsEmpty());
  EXPECT_THAT(declared_in("struct S { float a;"), IsEmpty());
  EXPECT_THAT(declared_in("float a; float b"), ElementsAre("variable a"));
  EXPECT_THAT(declared_in("float a = (1; float b;"), IsEmpty());
}

TEST(Declarations, WhatFollowsABracketThatClosesNothingIsLeftOut) {
  EXPECT_THAT(declared_in("float a; ) float f() { return 1; }"), ElementsAre("variable a"));
  EXPECT_THAT(declared_in("float f() { return a); } float g() { return 1; }"), IsEmpty());
  EXPECT_THAT(declared_in("float a[2}; float f() { return 1; }"), IsEmpty());
}

TEST(Declarations, EveryTokenBelongsToOneDeclarationAtMost) {
  const std::string text = "a; b(c){d} namespace N { e f; } struct {x} y; = ; <>; } ] ) g(h){i}";
  const std::vector<Token> tokens = lex(text);
  std::size_t next = 0;
  for (const Declaration& declaration : read_declarations(tokens)) {
    EXPECT_GE(declaration.first, next);
    EXPECT_GE(declaration.last, declaration.first);
    next = declaration.last + 1;
  }
  EXPECT_LE(next, tokens.size());
}

}  // namespace
}  // namespace penumbra::hlsl
