// Tests constant and structured buffers whose HLSL layout is none of GL's: the same bytes are read and
// written by way of every target's text. The offsets follow HLSL's rules for packing
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-packing-rules).
#include <gmock/gmock.h>

#include <cstring>
#include <numeric>

#include "preparation/executed.h"
#include "shaders/compile.h"
#include "shaders/gl_check.h"
#include "shaders/spirv_module.h"
#include "shaders/word_blocks.h"

namespace penumbra::preparation {
namespace {

using shaders::Target;
using testing::ElementsAreArray;
using testing::IsEmpty;

constexpr Target texts[] = {Target::essl310, Target::glsl450, Target::hlsl50};

std::vector<float> counted(std::size_t size) {
  std::vector<float> values(size);
  std::iota(values.begin(), values.end(), 0.0F);
  return values;
}

void expect_everywhere(const Execution& execution, const std::vector<float>& answer) {
  EXPECT_THAT(run_prepared(execution), ElementsAreArray(answer));
  for (const Target target : texts)
    EXPECT_THAT(run_through(execution, target), ElementsAreArray(answer)) << shaders::target_name(target);
}

// A word of a constant buffer is its number; the second register begins with word 4.
TEST(ExecutedBlocks, MembersLieWhereHlslPacksThem) {
  expect_everywhere({R"(cbuffer K { float a; float2 b; float c; float d; float3 e; };
[numthreads(1, 1, 1)] void Main() {
    Out[0] = a; Out[1] = b.x; Out[2] = b.y; Out[3] = c; Out[4] = d; Out[5] = e.x; Out[6] = e.z; })",
                     {0},
                     {{"K", counted(8)}},
                     7},
                    {0, 1, 2, 3, 4, 5, 7});
}

TEST(ExecutedBlocks, ElementsColumnsAndComponentsAreFoundAtRunTime) {
  // e is at 4, 8 and 12; m at 16, its columns 4 apart; n at 32, its rows 4 apart; s at 44, 8 words each; v at
  // 60.
  expect_everywhere({R"(struct S { float3 q; float p; float4 r; };
cbuffer K {
    float first; float3 pad; float e[3]; float4x4 m; row_major float3x4 n; S s[2]; float3 v[2];
};
[numthreads(1, 1, 1)] void Main() {
    int i = int(In[0]);
    Out[0] = e[i]; Out[1] = m[i][2]; Out[2] = m[2][i]; Out[3] = n[i][3]; Out[4] = n[2][i];
    Out[5] = s[i].q.y; Out[6] = s[1].q[i]; Out[7] = v[i][i + 1];
    S copy = s[i];
    Out[8] = copy.p; Out[9] = copy.r.y; Out[10] = pad[i]; })",
                     {1},
                     {{"K", counted(68)}},
                     11},
                    {8, 25, 22, 39, 41, 53, 53, 66, 55, 57, 2});
}

// The buffer holds bits, not values: -1 is a NaN as a float.
TEST(ExecutedBlocks, IntegersKeepTheirBits) {
  const int bits[] = {-1, 7, -8, 0x7F800001};
  std::vector<float> words(4);
  std::memcpy(words.data(), bits, sizeof bits);
  expect_everywhere({R"(cbuffer K { int a; int2 b; uint c; };
[numthreads(1, 1, 1)] void Main() { Out[0] = a; Out[1] = b.y; Out[2] = c >> 23; Out[3] = c & 255; })",
                     {0},
                     {{"K", words}},
                     4},
                    {-1, -8, 255, 1});
}

TEST(ExecutedBlocks, PackoffsetsAreObeyed) {
  expect_everywhere({R"(
cbuffer K { float4 a : packoffset(c1); float2 b : packoffset(c0.y); float c : packoffset(c3.w); };
[numthreads(1, 1, 1)] void Main() { Out[0] = a.x; Out[1] = b.y; Out[2] = c; })",
                     {0},
                     {{"K", counted(16)}},
                     3},
                    {4, 2, 15});
}

TEST(ExecutedBlocks, StructuredBuffersAreReadAndWrittenWithoutGaps) {
  expect_everywhere({R"(struct S { float b; float3 a; };
RWStructuredBuffer<S> Scratch;
[numthreads(1, 1, 1)] void Main() {
    int i = int(In[0]);
    Out[3] = Scratch[i].a.x;
    S s; s.b = 1; s.a = float3(2, 3, 4);
    Scratch[i] = s;
    Scratch[i].a.y += 10;
    S t = Scratch[i];
    Out[0] = t.b + t.a.x; Out[1] = t.a.y; Out[2] = t.a.z; })",
                     {0},
                     {{"Scratch", counted(8)}},
                     4},
                    {3, 13, 4, 1});
}

std::vector<std::uint32_t> module_of(const std::string& text, hlsl::Stage stage) {
  shaders::CompileRequest request;
  request.file = "blocks.hlsl";
  request.text = text;
  request.stage = stage;
  return shaders::compile(request).spirv;
}

TEST(ExecutedBlocks, TheDriverTakesWhatIsEmitted) {
  const std::vector<std::uint32_t> spirv = module_of(
      "struct S { float p; float3 q; };\n"
      "cbuffer K { float a; float2 b; S s[2]; int n; uint3 m; };\n"
      "float4 Main(float4 p : SV_Position) : SV_Target { return s[int(p.x)].q.xyzx + b.x + m[n]; }",
      hlsl::Stage::fragment);
  for (const Target target : {Target::essl310, Target::glsl450}) {
    const shaders::CrossCompileResult emitted = shaders::cross_compile(spirv, target);
    ASSERT_TRUE(emitted.diagnostics.empty()) << format(emitted.diagnostics.front());
    EXPECT_TRUE(gl_check({{hlsl::Stage::fragment, emitted.text}}, target).empty()) << emitted.text;
  }
  for (const Target target : shaders::all_targets)
    EXPECT_FALSE(cross_compile(spirv, target).text.empty()) << shaders::target_name(target);
  const std::optional<shaders::SpirvModule> words =
      shaders::with_word_blocks(spirv, shaders::BlocksAsWords::not_for_gl);
  ASSERT_TRUE(words.has_value());
  EXPECT_THAT(shaders::validation_problems(*words, shaders::VulkanVersion::v1_1, false), IsEmpty());
}

TEST(ExecutedBlocks, WhatFitsStaysAndAtomicsOnMembersAreRefused) {
  const auto words_of = [](const std::string& members) {
    return shaders::with_word_blocks(
        module_of("struct S { " + members +
                      " };\nRWStructuredBuffer<S> B;\n"
                      "[numthreads(1, 1, 1)] void Main() { InterlockedAdd(B[0].n, 1); B[1].n = 2; }",
                  hlsl::Stage::compute),
        shaders::BlocksAsWords::not_for_gl);
  };
  EXPECT_FALSE(words_of("int n; int a;").has_value());
  EXPECT_FALSE(words_of("int n; int3 a;").has_value());
}

}  // namespace
}  // namespace penumbra::preparation
