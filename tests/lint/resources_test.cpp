// Tests the rules sampler-name, sampler-limit and register-limit; tests/lint/found has typed-load.
#include "lint/stage_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lint/linted_shader.h"

namespace penumbra::lint {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(InlineSampler, NamesUnityReads) {
  for (const char* name : {"sampler_linear_clamp", "sampler_PointRepeat", "my_trilinear_mirroronce_sampler",
                           "sampler_LinearClamp_compare", "sampler_linear_clampU_repeatV",
                           "SAMPLER_POINT_MIRROR", "sampler_linear_repeat_aniso8"})
    EXPECT_TRUE(is_inline_sampler(name)) << name;
  for (const char* name :
       {"sampler_linear", "sampler_clamp", "sampler_Bilinear_edge", "sampler", "sampler_Map"})
    EXPECT_FALSE(is_inline_sampler(name)) << name;
}

std::vector<std::string> names(const std::string& declarations, const std::string& expression) {
  return findings_of("sampler-name", fragment("", expression, declarations));
}

TEST(SamplerName, OfATextureOrOfASetting) {
  EXPECT_THAT(names("Texture2D _Map; SamplerState sampler_Map;\n", "_Map.Sample(sampler_Map, uv)"),
              IsEmpty());
  EXPECT_THAT(
      names("Texture2D _Map; SamplerState sampler_linear_clamp;\n", "_Map.Sample(sampler_linear_clamp, uv)"),
      IsEmpty());
}

TEST(SamplerName, OfNothing) {
  EXPECT_THAT(
      names("Texture2D _Map;\nSamplerState mySampler;\n", "_Map.Sample(mySampler, uv)"),
      ElementsAre("2:14 error sampler-name: sampler 'mySampler' is not named after a texture that this "
                  "shader samples, nor after a filter and a wrap mode, such as sampler_linear_clamp"));
}

TEST(SamplerName, OfATextureTheShaderDoesNotSample) {
  EXPECT_THAT(names("Texture2D _Map; Texture2D _Other;\nSamplerState sampler_Other;\n",
                    "_Map.Sample(sampler_Other, uv)"),
              ElementsAre(HasSubstr("2:14 error sampler-name: sampler 'sampler_Other' is not named after a "
                                    "texture that this shader samples ('_Other' is not)")));
}

TEST(SamplerName, UnusedOnesDoNotMatter) {
  EXPECT_THAT(names("Texture2D _Map; SamplerState sampler_Map; SamplerState mySampler;\n",
                    "_Map.Sample(sampler_Map, uv)"),
              IsEmpty());
}

// `count` textures, each sampled with a sampler of its own.
std::string sampling(int count) {
  std::string before;
  std::string expression = "0";
  for (int i = 0; i < count; ++i) {
    const std::string name = "_Map" + std::to_string(i);
    before += "Texture2D " + name + "; SamplerState sampler" + name + ";\n";
    expression += " + " + name + ".Sample(sampler" + name + ", uv)";
  }
  return fragment("", expression, before);
}

TEST(SamplerLimit, SixteenAreAllowed) {
  EXPECT_THAT(findings_of("sampler-limit", sampling(16)), IsEmpty());
  EXPECT_THAT(
      findings_of("sampler-limit", sampling(17)),
      ElementsAre(HasSubstr(
          "17:32 error sampler-limit: 17 samplers are used; Direct3D 11 has 16, and 'sampler_Map16' is the "
          "first above: sample several textures with one, such as sampler_linear_repeat (sampler_Map0, ")));
  std::string silenced = sampling(17);
  silenced.insert(silenced.find("\n", silenced.find("sampler_Map16;")),
                  "  // penumbra-lint: disable=sampler-limit");
  EXPECT_THAT(findings_of("sampler-limit", silenced), IsEmpty());
}

TEST(SamplerLimit, OnlyUsedOnesCount) {
  std::string before;
  for (int i = 0; i < 20; ++i)
    before += "Texture2D _T" + std::to_string(i) + "; SamplerState sampler_T" + std::to_string(i) + ";\n";
  EXPECT_THAT(findings_of("sampler-limit", fragment("", "_T0.Sample(sampler_T0, uv)", before)), IsEmpty());
}

std::vector<std::string> limits(const std::string& text, hlsl::Stage stage = hlsl::Stage::fragment,
                                int target = 0) {
  return findings_of("register-limit", text, stage, target);
}

std::string reading_buffers(int count) {
  std::string before;
  std::string expression = "0";
  for (int i = 0; i < count; ++i) {
    before += "cbuffer B" + std::to_string(i) + " { float4 _V" + std::to_string(i) + "; };\n";
    expression += " + _V" + std::to_string(i);
  }
  return fragment("", expression, before);
}

TEST(RegisterLimit, ConstantBuffers) {
  EXPECT_THAT(limits(reading_buffers(14)), IsEmpty());
  EXPECT_THAT(limits(reading_buffers(15)),
              ElementsAre(HasSubstr(
                  "15:9 error register-limit: 15 constant buffers are used; Direct3D 11 has 14, and 'B14' "
                  "is the first above: put several into one (B0, ")));
}

TEST(RegisterLimit, BytesOfAConstantBuffer) {
  const auto shader = [](int elements) {
    return fragment("", "_Many[flat]", "cbuffer Big { float4 _Many[" + std::to_string(elements) + "]; };\n");
  };
  EXPECT_THAT(limits(shader(4096)), IsEmpty());
  EXPECT_THAT(
      limits(shader(4097)),
      ElementsAre("1:9 error register-limit: constant buffer 'Big' has 65552 bytes; Direct3D 11 has 65536"));
}

TEST(RegisterLimit, CountersAreInTheirBuffers) {
  const auto shader = [](int count) {
    std::string before;
    std::string body;
    for (int i = 0; i < count; ++i) {
      before += "AppendStructuredBuffer<float> _B" + std::to_string(i) + ";\n";
      body += "    _B" + std::to_string(i) + ".Append(_In[id.x]);\n";
    }
    return "StructuredBuffer<float> _In;\n" + before +
           "[numthreads(1, 1, 1)]\nvoid Main(uint3 id : SV_DispatchThreadID)\n{\n" + body + "}\n";
  };
  EXPECT_THAT(limits(shader(8), hlsl::Stage::compute), IsEmpty());
  EXPECT_THAT(limits(shader(9), hlsl::Stage::compute),
              ElementsAre(testing::AllOf(HasSubstr("9 writable textures and buffers are used"),
                                         testing::Not(HasSubstr("@count")))));
}

TEST(RegisterLimit, WritableBuffers) {
  const auto shader = [](int count) {
    std::string before;
    std::string body;
    for (int i = 0; i < count; ++i) {
      before += "RWStructuredBuffer<float> _B" + std::to_string(i) + ";\n";
      body += "    _B" + std::to_string(i) + "[id.x] = _In[id.x];\n";
    }
    return "StructuredBuffer<float> _In;\n" + before +
           "[numthreads(1, 1, 1)]\nvoid Main(uint3 id : SV_DispatchThreadID)\n{\n" + body + "}\n";
  };
  EXPECT_THAT(limits(shader(8), hlsl::Stage::compute), IsEmpty());
  EXPECT_THAT(
      limits(shader(9), hlsl::Stage::compute),
      ElementsAre(testing::AllOf(
          HasSubstr(
              "10:27 error register-limit: 9 writable textures and buffers are used; Direct3D 11 has 8"),
          HasSubstr("'_B8' is the first above"), HasSubstr("(_B0, _B1, "))));
}

TEST(RegisterLimit, BytesOfGroupSharedMemory) {
  const auto found = [](int elements) {
    return limits("struct Item { float3 a; half b; };\ngroupshared uint _Few[4];\ngroupshared Item _Items[" +
                      std::to_string(elements) +
                      "];\nRWStructuredBuffer<float> _Out;\n[numthreads(8, 1, 1)]\nvoid Main(uint3 id : "
                      "SV_DispatchThreadID)\n{\n    _Items[id.x].a = _Few[id.x] = id.x;\n    "
                      "_Out[id.x] = _Items[id.x].a.y + _Items[id.x].b + _Few[id.x];\n}\n",
                  hlsl::Stage::compute);
  };
  EXPECT_THAT(found(1023), IsEmpty());
  EXPECT_THAT(
      found(1024),
      ElementsAre("3:18 note register-limit: 16400 bytes of group shared memory are used ('_Items' 16384, "
                  "'_Few' 16); some devices with Vulkan or OpenGL ES have only 16384"));
  EXPECT_THAT(
      found(2048),
      ElementsAre("3:18 error register-limit: 32784 bytes of group shared memory are used ('_Items' 32768, "
                  "'_Few' 16); Direct3D 11 and Metal have 32768: keep values in 16 bits, or let the group be "
                  "smaller"));
}

std::string interpolating(int count) {
  std::string members;
  std::string set;
  for (int i = 0; i < count; ++i) {
    members += "    float4 t" + std::to_string(i) + " : TEXCOORD" + std::to_string(i) + ";\n";
    set += "    o.t" + std::to_string(i) + " = p.xyzz;\n";
  }
  return "struct V\n{\n    float4 p : SV_Position;\n" + members +
         "};\nV Main(float3 p : POSITION)\n{\n    V o;\n    o.p = p.xyzz;\n" + set + "    return o;\n}\n";
}

TEST(RegisterLimit, Interpolators) {
  EXPECT_THAT(limits(interpolating(32), hlsl::Stage::vertex), IsEmpty());
  EXPECT_THAT(limits(interpolating(33), hlsl::Stage::vertex),
              ElementsAre("0 error register-limit: at least 33 interpolators are used; Direct3D 11 has 32"));
}

TEST(RegisterLimit, InterpolatorsOfThePragmaTarget) {
  EXPECT_THAT(limits(interpolating(10), hlsl::Stage::vertex, 30), IsEmpty());
  EXPECT_THAT(
      limits(interpolating(11), hlsl::Stage::vertex, 30),
      ElementsAre("0 note register-limit: 11 interpolators are used; devices of #pragma target 3.0 may "
                  "have only 10"));
  EXPECT_THAT(limits(interpolating(9), hlsl::Stage::vertex, 25), testing::SizeIs(1));
  EXPECT_THAT(limits(interpolating(15), hlsl::Stage::vertex, 35), IsEmpty());
  EXPECT_THAT(limits(interpolating(16), hlsl::Stage::vertex, 45), IsEmpty());
}

}  // namespace
}  // namespace penumbra::lint
