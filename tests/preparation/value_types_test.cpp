// Names and chains have the type their declaration says, in the block it stands in.
#include "preparation/value_types.h"

#include <gtest/gtest.h>

namespace penumbra::preparation {
namespace {

// The type of the chain that ends just before each `@`, in the order of the text.
std::vector<std::string> types_before_marks(const std::string& marked) {
  const TokenText text(marked, "m");
  std::vector<std::string> found;
  for (std::size_t at = 1; at < text.size(); ++at) {
    if (!text.is(at, "@")) continue;
    const ValueType& type = text.types().at(at - 1);
    std::string name(type.constant ? "const " : "");
    name += std::string(type.name.empty() ? "?" : type.name);
    for (int dimension = 0; dimension < type.dimensions; ++dimension) name += "[]";
    found.push_back(name);
  }
  return found;
}

using Types = std::vector<std::string>;

TEST(ValueTypes, NamesAreGlobalsParametersAndLocals) {
  EXPECT_EQ(types_before_marks("float a; cbuffer C { int c; } void f(Texture2D<float4> t, const S s[2]) {"
                               "half b = 1, d[3]; a@; b@; c@; d@; t@; s@; nothing@; }"),
            (Types{"float", "half", "int", "half[]", "Texture2D", "const S[]", "?"}));
}

TEST(ValueTypes, InnerNamesHideOuterOnesUntilTheirBlockEnds) {
  EXPECT_EQ(types_before_marks(
                "float a; void f(int b) { a@; { half a; a@; { bool a; a@; } a@; } a@; } void g() { b@; }"),
            (Types{"float", "half", "bool", "half", "float", "?"}));
}

TEST(ValueTypes, TwoComparisonsDeclareNothing) {
  EXPECT_EQ(types_before_marks("float v[2]; void f(int a) { for (; a < 2 && (bool)(a > v[0]);) {} v@;"
                               "while (a < 2 > v[0]) {} v@; if (n < 2 || n > v[0]) {} v@; }"),
            (Types{"float[]", "float[]", "float[]"}));
  EXPECT_EQ(
      types_before_marks("void f() { vector<float, 3> v[2]; v@; Texture2DMS<vector<float, 4>, 8> t; t@; }"),
      (Types{"vector[]", "Texture2DMS"}));
}

TEST(ValueTypes, ChainsAreFollowed) {
  EXPECT_EQ(
      types_before_marks(
          "struct A { Texture2D t[2]; }; struct B { A a; A make() { return a@; } }; B b; B[] c;"
          "A get(int i); void f() { b.a@; b.a.t@; b.a.t[1]@; get(2).t[0]@; b.make().t@; (b.a)@; b.x@; }"),
      (Types{"A", "A", "Texture2D[]", "Texture2D", "Texture2D", "Texture2D[]", "A", "?"}));
}

TEST(ValueTypes, MembersAreSeenInMemberFunctionsAndBases) {
  EXPECT_EQ(
      types_before_marks(
          "float a; struct A { int a; }; struct B : A { half b; void f(bool c) { a@; b@; c@; this.a@; } };"
          "void g(B b) { a@; b.a@; }"),
      (Types{"int", "half", "bool", "int", "float", "int"}));
}

TEST(ValueTypes, ElementsOfStructuredBuffersAreTheirStruct) {
  EXPECT_EQ(types_before_marks("struct A { int a; }; StructuredBuffer<A> b; RWStructuredBuffer<A> c; void "
                               "f() { b[1]@; c[1].a@; }"),
            (Types{"const A", "int"}));
}

TEST(ValueTypes, OfWhatIsNotKnownNothingIsSaid) {
  EXPECT_EQ(types_before_marks("float f(int a); half f(float a); void g(float a, S s) {"
                               "f(1)@; (a + a)@; a.xy@; max(a, a)@; s.a@; g::a@; if (a < a) a@; }"),
            (Types{"?", "?", "?", "?", "?", "?", "float"}));
}

TEST(ValueTypes, AFunctionsBodyHasBothItsBraces) {
  const TokenText text(") float f() { return 1; } struct S { float g() { return 2; } };", "a");
  for (const FunctionType& function : text.types().functions())
    EXPECT_TRUE(function.body == npos || text.matching_bracket(function.body) != npos);
}

TEST(ValueTypes, EndlessInheritanceEnds) {
  EXPECT_EQ(
      types_before_marks("struct A : B { int a; }; struct B : A { int b; }; void f(A a) { a.c@; a.b@; }"),
      (Types{"?", "int"}));
}

}  // namespace
}  // namespace penumbra::preparation
