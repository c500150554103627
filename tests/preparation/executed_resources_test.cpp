// Draws shaders that read from textures, buffers and constants after the passes over resources, on the
// device, against answers worked out here. `p` is a pixel's centre: p.xy / 4 is the centre of the same texel.
#include <gmock/gmock.h>

#include <algorithm>

#include "fxc/at_hand.h"
#include "preparation/drawn.h"

namespace penumbra::preparation {
namespace {

Pixel sum(const Pixel& a, const Pixel& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
}
Pixel scaled(const Pixel& a, float by) {
  return {a[0] * by, a[1] * by, a[2] * by, a[3] * by};
}

// The shader is refused or wrong without the stage; with it the picture is the answer.
template <typename Answer>
void expect_only_prepared(const Drawing& drawing, Answer answer) {
  EXPECT_THROW(draw_unprepared(drawing), std::runtime_error);
  EXPECT_EQ(draw_prepared(drawing), picture(answer));
}

// glslang refuses the shader, and from FXC's bytecode the picture is the answer.
template <typename Answer>
void expect_from_bytecode(const Drawing& drawing, Answer answer) {
  EXPECT_THROW(draw_prepared(drawing), std::runtime_error);
  EXPECT_EQ(draw_by_fxc(drawing), picture(answer));
}

// The stage changes nothing that was right before.
template <typename Answer>
void expect_both(const Drawing& drawing, Answer answer) {
  EXPECT_EQ(draw_unprepared(drawing), picture(answer));
  EXPECT_EQ(draw_prepared(drawing), picture(answer));
}

// glslang takes the constant as it is, and makes it a member that nobody sets.
TEST(ExecutedResources, StaticConstantsInCbuffersKeepTheirValue) {
  const Drawing drawing{
      "cbuffer C { float first; static const float kTwice = 2; float second; }\n"
      "float4 Main(float4 p : SV_Position) : SV_Target { return float4(first, kTwice, second, first * "
      "kTwice); "
      "}",
      {},
      {{"C", {5, 7, 9, 11}}}};
  EXPECT_EQ(draw_prepared(drawing), picture([](int, int) { return Pixel{5, 2, 7, 10}; }));
  EXPECT_NE(draw_unprepared(drawing), draw_prepared(drawing));
}

const std::string kSurface =
    "Texture2D A; Texture2D B; SamplerState Point;\n"
    "struct Surface { Texture2D map; SamplerState smp; float scale;\n"
    "  float4 Read(float2 uv) { return map.Sample(smp, uv) * scale; } };\n"
    "Surface Build(Texture2D map, SamplerState smp, float scale)\n"
    "{ Surface s; s.map = map; s.smp = smp; s.scale = scale; return s; }\n";

TEST(ExecutedResources, StructsOfTexturesMeanTheSameWhereGlslangTakesThem) {
  expect_both({kSurface + R"(
struct Layers { Surface one; Surface two; float weight; };
float4 Blend(Layers l, float2 uv) { return l.one.Read(uv) + l.two.Read(uv) * l.weight; }
float4 Main(float4 p : SV_Position) : SV_Target {
  Layers l; l.one = Build(A, Point, 2); l.two = Build(B, Point, 1); l.weight = 3;
  Surface copy = l.one; l.one = l.two; l.two = copy;
  return Blend(l, p.xy / 4); })",
               {{"A", 100}, {"B", 200}}},
              [](int x, int y) { return sum(texel(200, x, y), scaled(texel(100, x, y), 6)); });
}

TEST(ExecutedResources, CbuffersGiveTheirResourcesAway) {
  expect_only_prepared({R"(
cbuffer C : register(b0) { float first; Texture2D T : register(t0); SamplerState Point; float4 second : packoffset(c1); }
float4 Main(float4 p : SV_Position) : SV_Target { return T.Sample(Point, p.xy / 4) * first + second; })",
                        {{"T", 10}},
                        {{"C", {2, 0, 0, 0, 1, 2, 3, 4}}}},
                       [](int x, int y) {
                         return sum(scaled(texel(10, x, y), 2), {1, 2, 3, 4});
                       });
}

TEST(ExecutedResources, BuffersInStructsAndLocalsStandForTheirGlobal) {
  expect_only_prepared({R"(
StructuredBuffer<float> First; StructuredBuffer<float> Second; ByteAddressBuffer Bytes; Texture2D T;
struct Cells { StructuredBuffer<float> index; StructuredBuffer<float> values; ByteAddressBuffer raw; Texture2D map; };
Cells Fill(StructuredBuffer<float> values) { Cells c; c.index = First; c.values = values; c.raw = Bytes; c.map = T; return c; }
float Look(Cells c, int i) { return c.values[int(c.index[i])] + asfloat(c.raw.Load(4)); }
float4 Main(float4 p : SV_Position) : SV_Target {
  Cells c = Fill(Second); Cells d = c;
  StructuredBuffer<float> local = Second;
  return c.map.Load(int3(p.xy, 0)) + float4(Look(d, 1), Look(c, 0), local[2], 0); })",
                        {{"T", 0}},
                        {},
                        {{"First", {2, 0}}, {"Second", {10, 20, 30}}, {"Bytes", {0, 0.5F}}}},
                       [](int x, int y) {
                         return sum(texel(0, x, y), {10.5F, 30.5F, 30, 0});
                       });
}

TEST(ExecutedResources, ArraysOfTexturesHoldWhatTheyAreGiven) {
  PENUMBRA_NEEDS_FXC();
  expect_from_bytecode({R"(
Texture2D A; Texture2D B; SamplerState Point;
float4 Main(float4 p : SV_Position) : SV_Target {
  Texture2D maps[] = { A, B }; SamplerState only = { Point };
  float4 r = 0;
  [unroll] for (int i = 0; i < 2; ++i) r += maps[i].Sample(only, p.xy / 4) * (i + 1);
  return r; })",
                        {{"A", 100}, {"B", 200}}},
                       [](int x, int y) { return sum(texel(100, x, y), scaled(texel(200, x, y), 2)); });
}

// glslang alone gives other numbers in other runs, so there is nothing to compare with before.
TEST(ExecutedResources, ATextureIsReadByComparisonAndOtherwise) {
  expect_only_prepared(
      {R"(
Texture2D Depth; SamplerState Point; SamplerComparisonState Compare;
float4 Both(Texture2D map, float2 uv) {
  return float4(map.SampleLevel(Point, uv, 0).x, map.SampleCmpLevelZero(Compare, uv, 0.5),
                map.Load(int3(uv * 4, 0)).x, map.SampleCmpLevelZero(Compare, uv, 0.25)); }
float4 Main(float4 p : SV_Position) : SV_Target { return Both(Depth, p.xy / 4); })"},
      [](int x, int y) {
        const float depth = static_cast<float>(4 * y + x) / 16.0F;
        return Pixel{depth, 0.5F <= depth ? 1.0F : 0.0F, depth, 0.25F <= depth ? 1.0F : 0.0F};
      });
}

TEST(ExecutedResources, TexturesInResultsAndArraysOfStructsAreRead) {
  expect_only_prepared({kSurface + R"(
struct Outer { Surface inner; };
float4 Main(float4 p : SV_Position) : SV_Target {
  float2 uv = p.xy / 4;
  Surface s[2]; s[0] = Build(A, Point, 1); s[1] = Build(B, Point, 1);
  Outer n; n.inner = s[1];
  return Build(A, Point, 1).map.SampleLevel(Build(B, Point, 1).smp, uv, 0) + n.inner.map.Sample(s[0].smp, uv) * 2
    + s[0].map.GatherRed(s[1].smp, float2(0.25, 0.25)).xyzw; })",
                        {{"A", 100}, {"B", 200}}},
                       [](int x, int y) {
                         return sum(sum(texel(100, x, y), scaled(texel(200, x, y), 2)), {104, 105, 101, 100});
                       });
}

TEST(ExecutedMatrixCasts, EveryElementIsTheNumber) {
  const Drawing drawing{R"(
static const int three = 3;
float4 Sum(float4x4 m) { return m[0] + 10 * m[1] + 100 * m[2] + 1000 * m[3]; }
float4 Main(float4 p : SV_Position) : SV_Target {
  return Sum((float4x4)2) + Sum((float4x4)three) + Sum((float4x4)-1) + Sum((float4x4)0); })"};
  for (int run = 0; run < 20; ++run)
    EXPECT_EQ(draw_prepared(drawing), picture([](int, int) { return Pixel{4444, 4444, 4444, 4444}; }));
}

// tex2D reads the texel p / 4 names; tex2Dproj the one p / 4 names after a division by w; tex2Dlod and
// tex2Dbias take their level from w and nothing from z.
TEST(ExecutedDx9Samplers, ReadWhereTheDocumentationSays) {
  expect_only_prepared({R"(
sampler2D A; uniform sampler2D B : register(s1), C;
float4 Main(float4 p : SV_Position) : SV_Target {
  float4 uv = float4(p.xy / 4, 99, 99);
  float4 r = tex2D(A, uv) + 2 * tex2D(B, uv.yx, float2(0, 0), float2(0, 0));
  r += 3 * tex2Dlod(C, float4(uv.xy, 77, 0)) + 4 * tex2Dbias(A, float4(uv.yx, 77, 0));
  r += 5 * tex2Dproj(B, float4(uv.xy * 8, 77, 8)) + 6 * tex2Dgrad(C, uv.yx, 0, 0);
  return r; })",
                        {{"A", 100}, {"B", 200}, {"C", 300}}},
                       [](int x, int y) {
                         Pixel r = sum(texel(100, x, y), scaled(texel(200, y, x), 2));
                         r = sum(r, sum(scaled(texel(300, x, y), 3), scaled(texel(100, y, x), 4)));
                         return sum(r, sum(scaled(texel(200, x, y), 5), scaled(texel(300, y, x), 6)));
                       });
}

TEST(ExecutedDx9Samplers, ArePassedKeptAssignedAndReadOnce) {
  expect_only_prepared({R"(
sampler2D A, B; sampler Old;
struct Layer { float weight; sampler2D map; };
float4 Read(sampler2D map, float2 uv);
float4 Read(sampler2D map, float2 uv) { return tex2D(map, uv); }
float4 OfLayer(Layer l, float2 uv) { return Read(l.map, uv) * l.weight; }
float4 Plain(sampler s, float2 uv) { return tex2D(s, uv); }
float2 Step(inout float n, float2 uv) { n += 1; return uv; }
float4 Main(float4 p : SV_Position) : SV_Target {
  float2 uv = p.xy / 4; float calls = 0;
  Layer l; l.weight = 2; l.map = B;
  sampler2D local = A;
  float4 r = tex2D(local, uv) + OfLayer(l, uv);
  local = B;
  if (p.x > 0) l.map = local;
  r += Plain(Old, uv.yx) + tex2Dlod(l.map, float4(Step(calls, uv), 0, 0));
  return r + float4(calls, 0, 0, 0); })",
                        {{"A", 100}, {"B", 200}, {"Old", 300}}},
                       [](int x, int y) {
                         const Pixel r = sum(texel(100, x, y), scaled(texel(200, x, y), 3));
                         return sum(sum(r, texel(300, y, x)), {1, 0, 0, 0});
                       });
}

// b0, t0 and s0 are registers of different kinds, and spaces set them apart, so every resource is read as
// itself.
TEST(ExecutedRegisters, DoNotCollide) {
  expect_both({R"(
cbuffer One : register(b0) { float4 one; } cbuffer Two : register(b0, space1) { float4 two; }
Texture2D A : register(t0); Texture2D B : register(t0, space1); SamplerState Point : register(s0);
StructuredBuffer<float> Data : register(t0, space2);
float4 Main(float4 p : SV_Position) : SV_Target {
  return one + two * 10 + A.Sample(Point, p.xy / 4) + B.Load(int3(p.xy, 0)) + Data[1]; })",
               {{"A", 100}, {"B", 200}},
               {{"One", {1, 2, 3, 4}}, {"Two", {5, 6, 7, 8}}},
               {{"Data", {0, 1000}}}},
              [](int x, int y) {
                return sum(sum(texel(100, x, y), texel(200, x, y)), {1051, 1062, 1073, 1084});
              });
}

TEST(ExecutedRegisters, PackoffsetsHoldAndRegistersOfConstantsGo) {
  expect_both({R"(
cbuffer C { float4 a : packoffset(c1); float b : packoffset(c0.y); float2 c : packoffset(c0.z); }
float4 Main(float4 p : SV_Position) : SV_Target { return a + float4(b, c, 0); })",
               {},
               {{"C", {9, 1, 2, 3, 10, 20, 30, 40}}}},
              [](int, int) {
                return Pixel{11, 22, 33, 40};
              });
  expect_only_prepared({R"(
float4 a : register(c4); float b : register(c1.y);
float4 Main(float4 p : SV_Position) : SV_Target { return a + b; })",
                        {},
                        {{"$Global", {1, 2, 3, 4, 10}}}},
                       [](int, int) {
                         return Pixel{11, 12, 13, 14};
                       });
}

// Elements are packed, 25 words each, in every module: FXC's bytecode reads the same words.
TEST(ExecutedResources, StructuredBuffersHaveDirect3DsOffsets) {
  Drawing drawing{
      "struct S { float a; float3 b; float2 c; float3 d[2]; uint e; float3x4 m; };\n"
      "StructuredBuffer<S> Data;\n"
      "float4 Main(float4 p : SV_Position) : SV_Target {\n"
      "  S s = Data[1]; int i = (int)p.x % 2;\n"
      "  return p.y < 2 ? float4(s.a, s.b.z, s.c.y, s.d[i].y) : float4(asfloat(s.e), s.m[i][3], "
      "Data[2].b[i], "
      "Data[0].m[2][1]); }",
      {},
      {},
      {{"Data", {}}}};
  for (int i = 0; i < 75; ++i) drawing.buffers["Data"].push_back(static_cast<float>(i));
  const auto expected = picture([](int x, int y) {
    const float i = static_cast<float>(x % 2);
    if (y < 2) return Pixel{25, 28, 30, 32 + 3 * i};
    return Pixel{37, 47 + i, 51 + i, 18};
  });
  EXPECT_EQ(draw_prepared(drawing), expected);
  PENUMBRA_NEEDS_FXC();
  EXPECT_EQ(draw_by_fxc(drawing), expected);
}

// The texel of each offset is read, at the border the nearest one.
TEST(ExecutedResources, GathersWithFourOffsetsReadOneTexelOfEach) {
  const auto column = [](int x) { return static_cast<float>(std::clamp(x, 0, 3)); };
  EXPECT_EQ(
      draw_prepared({"Texture2D A; SamplerState Point;\nfloat4 Main(float4 p : SV_Position) : SV_Target {\n"
                     "  return A.GatherGreen(Point, (p.xy + 0.25) / 4, int2(0, 0), int2(1, 0), int2(0, 1), "
                     "int2(2, -1)); }",
                     {{"A", 10}}}),
      picture([&](int x, int) {
        return Pixel{column(x), column(x + 1), column(x), column(x + 2)};
      }));
}

// The four texels around the middle hold (4y + x) / 16; those of a gather are counted from the lower left,
// against the clock. An offset of one texel to the right moves to those beside.
TEST(ExecutedResources, GatherCmpComparesFourTexels) {
  const Drawing drawing{
      "Texture2D<float> Depth; SamplerComparisonState Compare;\n"
      "float4 Main(float4 p : SV_Position) : SV_Target { return p.x < 2 ? Depth.GatherCmp(Compare, 0.5, 5.5 "
      "/ 16)\n"
      "  : Depth.GatherCmp(Compare, 0.5, 9.5 / 16, int2(1, 0)); }",
      {},
      {}};
  expect_both(drawing, [](int x, int) { return x < 2 ? Pixel{1, 1, 1, 0} : Pixel{1, 1, 0, 0}; });
}

// FXC's compatibility mode, in which Unity runs it, reads system values in them; glslang reads names of its
// user.
TEST(ExecutedResources, Direct3D9sNamesAreSystemValues) {
  const Drawing drawing{"float4 Main(float4 p : VPOS) : COLOR { return float4(p.xy, 2, 1); }"};
  const auto answer = picture([](int x, int y) {
    return Pixel{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 2, 1};
  });
  EXPECT_EQ(draw_prepared(drawing), answer);
}

}  // namespace
}  // namespace penumbra::preparation
