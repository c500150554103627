// Tests where the members of constant buffers lie, on the device, against HLSL's packing rules
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-packing-rules). Every word of a buffer
// holds its number.
#include <gmock/gmock.h>

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

}  // namespace
}  // namespace penumbra::preparation
