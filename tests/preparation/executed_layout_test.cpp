// Tests where the members of constant buffers lie, on the device, against HLSL's packing rules
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-packing-rules). Every word of a buffer
// holds its number.
#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "preparation/executed.h"

namespace penumbra::preparation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<float> numbers(std::size_t count) {
  std::vector<float> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = static_cast<float>(i);
  return all;
}

Execution reads(const std::string& declarations, const std::vector<std::string>& values) {
  std::string statements;
  for (std::size_t i = 0; i < values.size(); ++i)
    statements += "Out[" + std::to_string(i) + "] = " + values[i] + "; ";
  Execution execution{
      declarations + "\n[numthreads(1, 1, 1)] void Main() { int i = int(In[0]); " + statements + "}",
      {1},
      {{"C", numbers(1024)}, {"$Global", numbers(1024)}},
      values.size()};
  return execution;
}

TEST(ExecutedPacking, PragmaTurnsMatricesThatFollow) {
  EXPECT_THAT(run_prepared(reads("cbuffer C { float2x3 a; };", {"a[0][1]", "a[1][0]"})), ElementsAre(4, 1));
  EXPECT_THAT(run_prepared(reads("#pragma pack_matrix(row_major)\ncbuffer C { float2x3 a; };",
                                 {"a[0][1]", "a[1][0]"})),
              ElementsAre(1, 4));
  EXPECT_THAT(run_prepared(reads("#pragma pack_matrix(row_major)\ncbuffer C { column_major float2x3 a; };",
                                 {"a[0][1]", "a[1][0]"})),
              ElementsAre(4, 1));
  EXPECT_THAT(
      run_prepared(reads("#pragma pack_matrix(row_major)\n#pragma pack_matrix( COLUMN_MAJOR ) // back\n"
                         "cbuffer C { row_major float2x3 a; float2x3 b; };",
                         {"a[0][1]", "a[1][0]", "b[0][1]", "b[1][0]"})),
      ElementsAre(1, 4, 12, 9));
}

TEST(ExecutedPacking, PragmaReachesStructsAndGlobals) {
  const std::string structure =
      "#pragma pack_matrix(row_major)\nstruct S { float2x2 m; column_major float2x2 n; float2x2 "
      "Get() { return m; } };\n#pragma pack_matrix(column_major)\n";
  EXPECT_THAT(run_prepared(reads(structure + "cbuffer C { S s[2]; float2x2 a; };",
                                 {"s[i].m[0][1]", "s[0].n[0][1]", "s[i].m[i][0]", "a[0][1]"})),
              ElementsAre(17, 12, 20, 36));
  EXPECT_THAT(
      run_prepared(reads("#pragma pack_matrix(row_major)\nfloat2x2 a; float2x2 F(float2x2 m) { return m; }",
                         {"a[0][1]", "F(a)[1][0]"})),
      ElementsAre(1, 4));
}

TEST(ExecutedPacking, WhatThePragmaDoesNotTakeIsAnError) {
  EXPECT_THAT([] { run_prepared(reads("#pragma pack_matrix(push)", {"1"})); },
              ThrowsMessage<std::runtime_error>(HasSubstr(":2: error: unknown '#pragma pack_matrix'")));
  EXPECT_THAT(
      [] {
        run_prepared(reads("#pragma pack_matrix(row_major)\nStructuredBuffer<float4x4> B;", {"B[0][0][0]"}));
      },
      ThrowsMessage<std::runtime_error>(HasSubstr("put the matrix into a struct")));
}

TEST(ExecutedTails, MembersLieInWhatMatricesArraysAndStructsLeaveFree) {
  EXPECT_THAT(run_prepared(reads(
                  "cbuffer C { float3x3 m; float g; float2x4 n; float h; row_major float3x3 q; float r; "
                  "row_major float3x2 t; float2 v; };",
                  {"m[1][0]", "g", "n[0][1]", "h", "q[0][1]", "r", "t[1][0]", "v.x"})),
              ElementsAre(1, 11, 16, 26, 29, 39, 44, 50));
  EXPECT_THAT(run_prepared(reads("cbuffer C { float a[3], g; float2 h; float4 k; };",
                                 {"a[i]", "a[2]", "g", "h.y", "k.x"})),
              ElementsAre(4, 8, 9, 11, 12));
  EXPECT_THAT(
      run_prepared(reads("struct S { float4x4 p; float3 m; }; cbuffer C { S a[2]; float g; float z; };",
                         {"a[i].m.z", "g", "z", "a[i].p[1][2]"})),
      ElementsAre(38, 39, 40, 29));
}

TEST(ExecutedTails, StandBesidePackoffsets) {
  EXPECT_THAT(run_prepared(reads("cbuffer C { float2x2 m : packoffset(c1); float g : packoffset(c3.y); };",
                                 {"m[1][0]", "g"})),
              ElementsAre(5, 13));
}

// Other targets are given the same words.
TEST(ExecutedTails, HoldThroughEveryTarget) {
  const Execution execution =
      reads("cbuffer C { float a[2]; float3 b; float3x3 m; float g; float c[2]; float2 d; };",
            {"a[i]", "b.x", "m[1][2]", "g", "c[i]", "d.y"});
  const auto expected = ElementsAre(4, 5, 17, 19, 24, 26);
  EXPECT_THAT(run_prepared(execution), expected);
  for (const shaders::Target target :
       {shaders::Target::hlsl51, shaders::Target::glsl450, shaders::Target::essl310})
    EXPECT_THAT(run_through(execution, target), expected);
}

// OpenGL allows no member there either, also where the matrix is the only one with a tail.
TEST(ExecutedTails, OfAMatrixAloneHoldThroughEveryTarget) {
  const Execution execution = reads("cbuffer C { float3x3 m; float g; };", {"m[1][0]", "g"});
  EXPECT_THAT(run_prepared(execution), ElementsAre(1, 11));
  for (const shaders::Target target :
       {shaders::Target::hlsl51, shaders::Target::glsl450, shaders::Target::essl310})
    EXPECT_THAT(run_through(execution, target), ElementsAre(1, 11));
}

TEST(ExecutedTails, InStructsOfBuffersAreAnError) {
  EXPECT_THAT(
      [] { run_prepared(reads("struct S { float3x3 m; float g; }; cbuffer C { S s; };", {"s.g"})); },
      ThrowsMessage<std::runtime_error>(HasSubstr("'g' shares the last register of the member before it")));
  EXPECT_THAT([] { run_prepared(reads("struct S { float a[2], b; }; ConstantBuffer<S> C;", {"C.b"})); },
              ThrowsMessage<std::runtime_error>(HasSubstr("'b' shares the last register")));
}

// The members of a random cbuffer are packed, and the rules are applied once more.
struct Member {
  std::string declaration;  // declaration of NAME
  std::string last;         // its last number
  int words;                // words up to it
  bool of_registers;
};

const std::vector<Member>& members() {
  static const std::vector<Member> all{
      {"float NAME", "NAME", 1, false},
      {"float2 NAME", "NAME.y", 2, false},
      {"float3 NAME", "NAME.z", 3, false},
      {"float4 NAME", "NAME.w", 4, false},
      {"float2x2 NAME", "NAME[1][1]", 6, true},
      {"float3x3 NAME", "NAME[2][2]", 11, true},
      {"float4x4 NAME", "NAME[3][3]", 16, true},
      {"float2x4 NAME", "NAME[1][3]", 14, true},
      {"row_major float2x4 NAME", "NAME[1][3]", 8, true},
      {"row_major float3x2 NAME", "NAME[2][1]", 10, true},
      {"float NAME[3]", "NAME[i + 1]", 9, true},
      {"float2 NAME[2]", "NAME[i].y", 6, true},
      {"float3 NAME[2]", "NAME[i].z", 7, true},
      {"float4 NAME[2]", "NAME[i].w", 8, true},
      {"float3x3 NAME[2]", "NAME[i][2][2]", 23, true},
      {"One NAME", "NAME.a", 1, true},
      {"Two NAME", "NAME.b.x", 4, true},
      {"Two NAME[2]", "NAME[i].b.x", 8, true},
  };
  return all;
}

TEST(ExecutedTails, RandomBuffersArePackedByTheRules) {
  std::mt19937 random(3);
  for (int buffer = 0; buffer < 40; ++buffer) {
    std::string declarations = "struct One { float a; }; struct Two { float3 a; float1 b; };\ncbuffer C {";
    std::vector<std::string> values;
    std::vector<float> expected;
    int next = 0;
    for (int i = 0; i < 7; ++i) {
      const Member& member = members()[random() % members().size()];
      const std::string name = "m" + std::to_string(i);
      const auto named = [&](std::string text) { return text.replace(text.find("NAME"), 4, name); };
      const bool straddles = next % 4 + member.words > 4;
      if (member.of_registers || straddles) next = (next + 3) / 4 * 4;
      declarations += " " + named(member.declaration) + ";";
      values.push_back(named(member.last));
      expected.push_back(static_cast<float>(next + member.words - 1));
      next += member.words;
    }
    EXPECT_EQ(run_prepared(reads(declarations + " };", values)), expected) << declarations;
  }
}

}  // namespace
}  // namespace penumbra::preparation
