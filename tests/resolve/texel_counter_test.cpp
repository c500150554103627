// Counts shaders whose fetches, written texels and operations are known.
#include "resolve/texel_counter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "resolve/counted_run.h"

namespace penumbra::resolve {
namespace {

using testing::Each;
using testing::ElementsAre;

std::string returning(const std::string& expression) {
  return "float4 Main(float4 position : SV_Position) : SV_Target { return " + expression + "; }";
}

TEST(TexelCounter, EveryKindOfReadIsOneFetch) {
  for (const char* read : {"_Plain.Sample(sampler_Linear, position.xy)",
                           "_Plain.SampleLevel(sampler_Linear, position.xy, 1)",
                           "_Plain.SampleBias(sampler_Linear, position.xy, 1)",
                           "_Plain.SampleGrad(sampler_Linear, position.xy, 0.1, 0.2)",
                           "_Plain.Sample(sampler_Linear, position.xy, int2(1, 2))",
                           "_Plain.Load(int3(1, 2, 0))",
                           "_Plain[uint2(1, 2)]",
                           "_Plain.Gather(sampler_Linear, 0.5)",
                           "_Plain.GatherRed(sampler_Linear, 0.5)",
                           "_Plain.GatherAlpha(sampler_Linear, 0.5, int2(1, 1))",
                           "_Depth.SampleCmp(sampler_Compare, position.xy, 0.5)",
                           "_Depth.SampleCmpLevelZero(sampler_Compare, position.xy, 0.5)",
                           "_Depth.GatherCmp(sampler_Compare, position.xy, 0.5)",
                           "_Array.Sample(sampler_Linear, float3(position.xy, 1))",
                           "_Array.Load(int4(1, 2, 1, 0))",
                           "_Array.Gather(sampler_Linear, float3(position.xy, 1))",
                           "_Volume.Sample(sampler_Linear, position.xyz)",
                           "_Volume.Load(int4(1, 2, 3, 0))",
                           "_Image[uint2(1, 2)]",
                           "Read(_Plain, sampler_Linear, position.x)"}) {
    const TexelCounts counts = drawn(returning(read));
    EXPECT_THAT(counts.fetches, Each(1U)) << read;
    EXPECT_THAT(counts.written, Each(1U)) << read;
  }
}

TEST(TexelCounter, QueriesAndBuffersAreNoFetches) {
  const TexelCounts drawing = drawn(R"(
cbuffer Settings { float4 _Setting; };
float4 Main(float4 position : SV_Position) : SV_Target
{
    uint width, height;
    _Plain.GetDimensions(width, height);
    return width + height + _Plain.CalculateLevelOfDetail(sampler_Linear, position.xy) + _In[1];
}
)");
  EXPECT_THAT(drawing.fetches, Each(0U));
  const TexelCounts dispatch = dispatched(R"(
groupshared float shared_sum[4];
[numthreads(4, 1, 1)]
void Main(uint3 id : SV_DispatchThreadID)
{
    shared_sum[id.x] = _In[id.x];
    GroupMemoryBarrierWithGroupSync();
    _Out[id.x] = shared_sum[3 - id.x];
}
)",
                                          {}, {4, 1, 1});
  EXPECT_THAT(dispatch.fetches, Each(0U));
  EXPECT_THAT(dispatch.written, Each(0U));
}

TEST(TexelCounter, LoopsBranchesAndReturnsCountWhatIsReached) {
  const TexelCounts counts = dispatched(R"(
float Walk(Texture2D<float4> map, uint steps)
{
    float sum = 0.0;
    for (uint i = 0; i < 100; ++i)
    {
        if (i == steps) return sum;
        if (i % 2 == 1) continue;
        sum += map.Load(int3(i, 0, 0)).x;
    }
    return sum;
}
[numthreads(8, 1, 1)]
void Main(uint3 id : SV_DispatchThreadID)
{
    if (id.x == 0) return;
    _Out[id.x] = _Plain[uint2(0, 0)].x;
    if (id.x == 1) return;
    float sum = Walk(_Plain, id.x);
    [unroll] for (int i = 0; i < 3; ++i) sum += Read(_Plain, sampler_Linear, i);
    _Out[id.x] = sum;
}
)",
                                        {}, {8, 1, 1});
  EXPECT_THAT(counts.fetches, ElementsAre(0U, 1U, 5U, 6U, 6U, 7U, 7U, 8U));
}

TEST(TexelCounter, AFetchThatNothingNeedsCounts) {
  EXPECT_THAT(drawn(R"(
float4 Main(float4 position : SV_Position) : SV_Target
{
    const float4 unused = _Plain.Sample(sampler_Linear, position.xy) + _Plain[uint2(1, 1)];
    return 1.0 + 0.0 * _Volume.Load(int4(0, 0, 0, 0));
}
)")
                  .fetches,
              Each(3U));
}

TEST(TexelCounter, AFragmentCountsUpToItsDiscardAndWritesNothing) {
  const std::string before = R"(
void GiveUp(float2 position)
{
    const float4 read = _Plain[uint2(1, 1)];
    for (int i = 0; i < 4; ++i)
    {
        )";
  const std::string after = R"(
        _Plain[uint2(2, 2)];
    }
}
float4 Main(float4 position : SV_Position) : SV_Target
{
    GiveUp(position.xy);
    return _Plain[uint2(3, 3)];
}
)";
  for (const char* statement : {"if (position.x < 1.0) discard;", "clip(position.x - 1.0);"}) {
    std::string text = before;
    text.append(statement).append(after);
    const TexelCounts counts = drawn(text, {.size = 2});
    EXPECT_THAT(counts.fetches, ElementsAre(1U, 6U, 1U, 6U)) << statement;
    EXPECT_THAT(counts.written, ElementsAre(0U, 1U, 0U, 1U)) << statement;
    EXPECT_EQ(counts.invocations, 4U) << statement;
  }
}

TEST(TexelCounter, EachColourOutputIsATexel) {
  const char* three = R"(
struct Colours
{
    float4 first : SV_Target0;
    float2 second : SV_Target1;
    float third : SV_Target2;
    float depth : SV_Depth;
};
Colours Main(float4 position : SV_Position)
{
    Colours colours;
    colours.first = 1.0;
    colours.second = 2.0;
    colours.third = 3.0;
    colours.depth = 0.5;
    return colours;
}
)";
  EXPECT_THAT(drawn(three, {.colours = 3, .depth = true}).written, Each(3U));
  EXPECT_THAT(drawn("void Main() { _Image[uint2(0, 0)] = 1.0; }", {.colours = 0, .depth = true}).written,
              Each(1U));
}

TEST(TexelCounter, StoresToTexturesAreTexelsAndAtomicsAreBoth) {
  const TexelCounts counts = dispatched(R"(
void Store(RWTexture2D<float> image, uint2 at) { image[at] = 1.0; }
[numthreads(4, 1, 1)]
void Main(uint3 id : SV_DispatchThreadID)
{
    for (uint i = 0; i < id.x; ++i) Store(_Image, uint2(id.x, i));
    if (id.x == 3) InterlockedAdd(_Numbers[uint2(0, 0)], 1);
    _Out[id.x] = 1.0;
}
)",
                                        {}, {4, 1, 1});
  EXPECT_THAT(counts.written, ElementsAre(0U, 1U, 2U, 4U));
  EXPECT_THAT(counts.fetches, ElementsAre(0U, 0U, 0U, 1U));
}

// _Plain has texels of 16 bytes, _Depth, _Image and _Numbers of 4. Functions get their textures from
// arguments, local variables and structs, and two calls of one get different ones.
TEST(TexelCounter, BytesAreThoseOfTheTexelsThatAreNamedByTheirFormats) {
  const TexelCounts counts = dispatched(R"(
struct Map { Texture2D<float4> colours; SamplerState filtering; };
float4 Gather(Texture2D<float4> map, SamplerState s) { return map.Gather(s, 0.5); }
float Twice(Map map) { return Gather(map.colours, map.filtering).x + map.colours.Load(int3(0, 0, 0)).x; }
float Texel(Texture2D<float> map) { return map[uint2(1, 1)]; }
[numthreads(4, 1, 1)]
void Main(uint3 id : SV_DispatchThreadID)
{
    Map map;
    map.colours = _Plain;
    map.filtering = sampler_Linear;
    float sum = 0.0;
    if (id.x == 1) sum = Twice(map);
    if (id.x == 2) sum = Texel(_Depth) + Read(_Plain, sampler_Linear, 0.5);
    if (id.x == 3)
    {
        for (uint i = 0; i < 3; ++i) sum += _Depth.SampleCmpLevelZero(sampler_Compare, 0.5, 0.5);
        InterlockedAdd(_Numbers[uint2(0, 0)], 1);
        _Image[uint2(1, 1)] = sum;
    }
    _Out[id.x] = sum;
}
)",
                                        {}, {4, 1, 1});
  EXPECT_THAT(counts.bytes_read, ElementsAre(0U, 4U * 16U + 16U, 4U + 4U * 16U, 3U * 4U * 4U + 4U));
  EXPECT_THAT(counts.bytes_written, ElementsAre(0U, 0U, 0U, 4U + 4U));
  const TexelCounts drawing = drawn(returning("_Plain[uint2(1, 1)]"), {.size = 2});
  EXPECT_THAT(drawing.bytes_read, Each(16U));
  EXPECT_THAT(drawing.bytes_written, Each(16U));
}

TEST(TexelCounter, BarriersAreThoseThatEachThreadPasses) {
  const TexelCounts counts = dispatched(R"(
groupshared float passed[4];
[numthreads(4, 1, 1)]
void Main(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    passed[thread] = 0.0;
    for (uint i = 0; i < group.x + 1; ++i)
    {
        GroupMemoryBarrierWithGroupSync();
        passed[thread] += passed[3 - thread];
    }
    DeviceMemoryBarrier();
    _Out[thread] = passed[thread];
}
)",
                                        {3, 1, 1}, {});
  EXPECT_EQ(counts.invocations, 12U);
  EXPECT_EQ(counts.barriers, 4U * (1U + 2U + 3U));
}

std::uint64_t operations_of(const std::string& statements) {
  return dispatched(
             "groupshared float2 shared_value;\n[numthreads(1, 1, 1)]\nvoid Main()\n{\n"
             "    const float4 a = float4(_In[0], _In[1], _In[2], _In[3]);\n    " +
                 statements + "\n}\n",
             {}, {})
      .operations.front();
}

TEST(TexelCounter, EachScalarOfArithmeticIsAnOperation) {
  const std::pair<const char*, std::uint64_t> cases[] = {
      {"_Out[0] = a.w;", 0},
      {"_Out[0] = a.x + a.y;", 1},
      {"_Out[0] = -a.x;", 1},
      {"if (a.x / (a.y + 1.0) > 0.5) _Out[0] = a.x;", 3},
      {"_Out[0] = sqrt(a.x);", 1},
      {"_Out[0] = max(a.x, a.y);", 1},
      {"_Out[0] = (a + a).x;", 4},
      {"_Out[0] = (a * a.x).x;", 4},
      {"_Out[0] = exp2(a).x;", 4},
      {"_Out[0] = dot(a, a);", 7},
      {"_Out[0] = dot(a.xy, a.zw);", 3},
      {"_Out[0] = length(a);", 8},
      {"if (normalize(a).x > 0.5) _Out[0] = a.x;", 13},
      {"_Out[0] = cross(a.xyz, a.yzw).x;", 9},
      {"_Out[0] = mul(float2x2(a), a.xy).x;", 2 * 3},
      {"_Out[0] = mul(float3x2(a, a.xy), a.xy).x;", 3 * 3},
      {"_Out[0] = mul(a.xyz, float3x2(a, a.xy)).x;", 2 * 5},
      {"_Out[0] = mul(float2x2(a), float2x2(a))[0].x;", 4 * 3},
      {"_Out[0] = float(int(a.x));", 2},
      {"_Out[0] = asfloat(asuint(a.x) & 3);", 1},
      {"_Out[0] = asfloat(asuint(a.x) << 3);", 1},
      {"_Out[0] = asfloat(countbits(asuint(a.x)));", 1},
      {"if (a.x < a.y) _Out[0] = a.x;", 1},
      {"if (all(a.xy < a.zw)) _Out[0] = a.x;", 2 + 2},
      {"_Out[0] = _Plain.SampleLevel(sampler_Linear, a.xy, 0).x;", 0},
      {"shared_value = a.xy;", 2},
      // Groupshared memory has no value before the first write.
      {"shared_value = a.xy; GroupMemoryBarrierWithGroupSync(); _Out[0] = shared_value.x;", 2 + 1}};
  for (const auto& [statement, expected] : cases) EXPECT_EQ(operations_of(statement), expected) << statement;
}

TEST(TexelCounter, OperationsAreThoseThatAreExecuted) {
  const TexelCounts counts = dispatched(R"(
float Sum(float value, uint times)
{
    float sum = value;
    for (uint i = 0; i < times; ++i) sum += value;
    return sum;
}
[numthreads(4, 1, 1)]
void Main(uint3 id : SV_DispatchThreadID)
{
    if (_In[0] > 1.0) return;
    _Out[id.x] = Sum(_In[id.x], id.x);
}
)",
                                        {}, {4, 1, 1});
  // The operations are the branch and the loop's first comparison, then a sum, the next i and a comparison.
  EXPECT_THAT(counts.operations, ElementsAre(2U, 5U, 8U, 11U));
  EXPECT_EQ(counts.invocations, 4U);
}

// The optimiser unrolls these loops, one inside of a function and one with a break.
TEST(TexelCounter, OperationsOfUnrolledLoopsCountEachTime) {
  const TexelCounts counts = dispatched(R"(
float Sum(float4 values[4], uint most)
{
    float all = 0.0;
    [unroll] for (int i = 0; i < 4; ++i)
    {
        if (uint(i) == most) break;
        all += dot(values[i], values[i]);
    }
    return all;
}
[numthreads(6, 1, 1)]
void Main(uint3 id : SV_DispatchThreadID)
{
    float4 values[4];
    [unroll] for (int i = 0; i < 4; ++i) values[i] = 2.0 * float4(_In[0], _In[1], _In[2], _In[3]);
    _Out[id.x] = Sum(values, id.x);
}
)",
                                        {}, {6, 1, 1});
  // There are 5 tests, 4 steps and 4 products of vectors; then for each i a test, the comparison with the
  // most (a conversion from int to uint is none) and, unless it ends there, 7 + 1 for the sum and 1 for the
  // step.
  constexpr std::uint64_t kFirst = 5 + 4 + 4 * 4;
  const auto turns = [](std::uint64_t number) { return kFirst + 11 * number; };
  EXPECT_THAT(counts.operations, ElementsAre(turns(0) + 2, turns(1) + 2, turns(2) + 2, turns(3) + 2,
                                             turns(4) + 1, turns(4) + 1));
}

TEST(TexelCounter, OperationsDoNotWrapAtThirtyTwoBits) {
  const TexelCounts counts = dispatched(R"(
[numthreads(64, 1, 1)]
void Main(uint3 id : SV_DispatchThreadID)
{
    float4x4 turned = float4x4(_In[id.x].xxxx, _In[1].xxxx, _In[2].xxxx, _In[3].xxxx);
    for (uint i = 0; i < 60000; ++i) turned = mul(turned, mul(turned, mul(turned, turned)));
    _Out[id.x] = turned[0].x;
}
)",
                                        {4, 1, 1}, {});
  EXPECT_EQ(counts.operations.front(), 4 * 64 * (1 + 60000ULL * (2 + 3 * 16 * 7)));
  EXPECT_EQ(counts.invocations, 4U * 64U);
}

constexpr const char* kAsManyAsItsNumber = R"(
[numthreads(2, 2, 2)]
void Main(uint3 id : SV_DispatchThreadID)
{
    for (uint i = 0; i < id.x + 4 * (id.y + 6 * id.z); ++i) _Out[0] = _Plain[uint2(i, 0)].x;
}
)";

TEST(TexelCounter, CellsAreThreadsOfADispatchInOrder) {
  std::vector<std::uint32_t> expected(96);
  std::iota(expected.begin(), expected.end(), 0U);
  EXPECT_EQ(dispatched(kAsManyAsItsNumber, {2, 3, 2}, {4, 6, 4}).fetches, expected);
}

TEST(TexelCounter, WhatLiesOutsideOfTheGridAddsToTheNearestCell) {
  EXPECT_THAT(dispatched(kAsManyAsItsNumber, {2, 3, 2}, {}).fetches, ElementsAre(96U * 95U / 2U));
  const TexelCounts wide = dispatched(kAsManyAsItsNumber, {2, 1, 1}, {3, 1, 1});
  EXPECT_THAT(wide.fetches, ElementsAre(56U, 60U, 64U + 68U));
  const TexelCounts picture = drawn(returning("_Plain[uint2(1, 1)]"), {.size = 4, .grid = Extent{2, 3}});
  EXPECT_THAT(picture.fetches, ElementsAre(1U, 3U, 1U, 3U, 2U, 6U));
  EXPECT_THAT(picture.written, ElementsAre(1U, 3U, 1U, 3U, 2U, 6U));
}

// A shader may ask for the number of the thread in each of these forms.
TEST(TexelCounter, TheCellIsFoundWithoutTheShadersHelp) {
  const std::pair<const char*, const char*> cases[] = {
      {"uint3 group : SV_GroupID, uint3 thread : SV_GroupThreadID", "2 * group.x + thread.x"},
      {"int3 id : SV_DispatchThreadID", "id.x"},
      {"uint id : SV_DispatchThreadID", "id"},
      {"uint2 id : SV_DispatchThreadID, uint3 again : SV_DispatchThreadID", "id.x + again.y"}};
  for (const auto& [parameters, number] : cases) {
    const TexelCounts counts = dispatched(std::string("[numthreads(2, 1, 1)] void Main(") + parameters +
                                              ")\n{\n    for (int i = 0; i < int(" + number +
                                              "); ++i) _Out[0] = _Plain[uint2(0, 0)].x;\n}\n",
                                          {2, 1, 1}, {4, 1, 1});
    EXPECT_THAT(counts.fetches, ElementsAre(0U, 1U, 2U, 3U)) << parameters;
  }
  EXPECT_THAT(drawn("float4 Main() : SV_Target { return _Plain[uint2(1, 1)]; }").fetches, Each(1U));
}

TEST(TexelCounter, OnlyPixelsThatAreDrawnCount) {
  const TexelCounts counts =
      drawn(returning("_Plain.Sample(sampler_Linear, position.xy)"), {.vertex = kHalf});
  EXPECT_THAT(counts.fetches, ElementsAre(1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 0, 0, 1, 0, 0, 0));
  EXPECT_EQ(counts.written, counts.fetches);
  EXPECT_EQ(counts.invocations, 10U) << "helpers do not count";
}

TEST(TexelCounter, DrawsOverEachOtherAddUpUnlessHidden) {
  const std::string read = returning("_Plain.Sample(sampler_Linear, position.xy)");
  EXPECT_THAT(drawn(read, {.triangles = 3}).fetches, Each(3U));
  EXPECT_THAT(drawn(read, {.triangles = 3, .depth = true}).fetches, Each(1U));
  EXPECT_THAT(drawn(read, {.triangles = 3, .depth = true}).written, Each(1U));
}

// Where a device cuts a triangle in two, the pixels along the cut are shaded for both parts.
TEST(TexelCounter, EachShadingOfAPixelCounts) {
  const std::string read = returning("_Plain[uint2(1, 1)]");
  EXPECT_THAT(drawn(read, {.samples = 4}).fetches, Each(testing::AnyOf(1U, 2U)));
  EXPECT_THAT(drawn(read, {.samples = 4, .shade_each_sample = true}).fetches, Each(4U));
}

TEST(TexelCounter, NeedsACell) {
  EXPECT_THROW(TexelCounter(test_device(), 4, 0), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::resolve
