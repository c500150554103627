#include "shaders/counted_module.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "shader_files.h"
#include "shaders/compile.h"
#include "shaders/reflect.h"
#include "shaders/spirv_module.h"
#include "spirv/code.h"

namespace penumbra::shaders {
namespace {

CompileResult kept(const std::string& text, hlsl::Stage stage = hlsl::Stage::compute,
                   VulkanVersion vulkan = VulkanVersion::v1_1) {
  CompileRequest request;
  request.file = "shader.hlsl";
  request.text = text;
  request.stage = stage;
  request.vulkan = vulkan;
  request.keep_unoptimised = true;
  CompileResult result = compile(request);
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) ADD_FAILURE() << hlsl::format(diagnostic);
  return result;
}

const std::string kReads = compute_shader("Read(_In, id.xy)",
                                          "Texture2D<float> _Unused;\nTexture2D<float> _In;\n"
                                          "float Read(Texture2D<float> map, uint2 at) { return map[at]; }\n");

TEST(CountedModule, BindsWhatTheShippedOneDoesAndTheCounts) {
  const CompileResult result = kept(kReads);
  std::set<std::string> names;
  std::set<std::pair<std::uint32_t, std::uint32_t>> places;
  for (const Resource& resource : reflect(counted_module(result.unoptimised, "Main")).resources) {
    names.insert(resource.name);
    places.emplace(resource.set, resource.binding);
    if (resource.name == texel_counts_name) {
      EXPECT_EQ(resource.kind, ResourceKind::storage_buffer);
      EXPECT_TRUE(resource.written);
    }
  }
  EXPECT_THAT(names, testing::ElementsAre(texel_bytes_name, texel_counts_name, "_In", "_Out"));
  EXPECT_EQ(places.size(), 4U) << "each has a binding of its own";
}

TEST(CountedModule, IsValidForEveryVulkan) {
  const std::string fragment =
      "Texture2D _In;\nfloat4 Main() : SV_Target { clip(_In[uint2(1, 1)].x); return 1; }\n";
  for (const VulkanVersion vulkan : {VulkanVersion::v1_0, VulkanVersion::v1_1, VulkanVersion::v1_2}) {
    for (const auto& [text, stage] :
         {std::pair(kReads, hlsl::Stage::compute), std::pair(fragment, hlsl::Stage::fragment)}) {
      const spirv::Module module = counted_module(kept(text, stage, vulkan).unoptimised, "Main", vulkan);
      EXPECT_THAT(validation_problems(module, vulkan, false), testing::IsEmpty());
    }
  }
}

constexpr std::int64_t kUnknown = -1;

// The growth of a shader's counters without branches, which the optimiser computes: fetches, texels written,
// operations, bytes read, bytes written; invocations; barriers. High words, whose growth is known on the
// device, are left out, and bytes are unknown but for 0.
std::vector<std::int64_t> counts(const std::string& statement) {
  const std::string text = R"(
TextureCube _Cube;
TextureCubeArray _CubeArray;
Texture2DMS<float4> _Samples;
Texture2DMSArray<float4> _SampleArray;
Texture1D _Row;
Buffer<float4> _Texels;
RWBuffer<float4> _Written;
RWTexture3D<float4> _Volume;
RWByteAddressBuffer _Bytes;
SamplerState sampler_Linear;
SamplerComparisonState sampler_Compare;
float4 Main(float4 position : SV_Position) : SV_Target
{
    float4 read = 0;
    )" + statement + "\n    return read;\n}\n";
  const spirv::Code code(counted_module(kept(text, hlsl::Stage::fragment).unoptimised, "Main"));
  std::vector<std::int64_t> found;
  for (const spirv::Instruction& one : code.instructions())
    if (one.op == spv::OpAtomicIAdd &&
        code.name(code.definition(one.operands[0])->operands[0]) == texel_counts_name)
      found.push_back(code.integer(one.operands[3]).value_or(kUnknown));
  for (const std::ptrdiff_t high : {10, 7, 5, 3}) found.erase(found.begin() + high);
  return found;
}

TEST(CountedModule, CountsTexturesOfEveryShape) {
  for (const char* read :
       {"read = _Cube.Sample(sampler_Linear, position.xyz);",
        "read = _Cube.Gather(sampler_Linear, position.xyz);",
        "read = _Cube.SampleCmpLevelZero(sampler_Compare, position.xyz, 0.5);",
        "read = _CubeArray.SampleLevel(sampler_Linear, position, 0);",
        "read = _CubeArray.SampleCmpLevelZero(sampler_Compare, position, 0.5);",
        "read = _Samples.Load(int2(1, 2), 3);", "read = _SampleArray.Load(int3(1, 2, 0), 3);",
        "read = _Row.Load(int2(1, 0));", "read = _Texels[3];", "read = _Volume[uint3(1, 2, 3)];",
        "_Cube.Sample(sampler_Linear, position.xyz);"})
    EXPECT_THAT(counts(read), testing::ElementsAre(1, 1, 0, kUnknown, kUnknown, 1, 0)) << read;
  EXPECT_THAT(counts("_Volume[uint3(1, 2, 3)] = 1; _Written[2] = 2;"),
              testing::ElementsAre(0, 3, 0, 0, kUnknown, 1, 0));
  EXPECT_THAT(counts("_Volume[uint3(1, 2, 3)] += 1;"),
              testing::ElementsAre(1, 2, 4, kUnknown, kUnknown, 1, 0));
  EXPECT_THAT(counts("_Bytes.Store(4, _Bytes.Load(8));"), testing::ElementsAre(0, 1, 2, 0, kUnknown, 1, 0));
}

// No entry point may have two variables for one of them.
TEST(CountedModule, ReadsItsPositionFromTheShadersOwnVariable) {
  for (const char* text : {"float4 Main() : SV_Target { return 1; }\n",
                           "float4 Main(float4 position : SV_Position) : SV_Target { return position; }\n"}) {
    const spirv::Code code(counted_module(kept(text, hlsl::Stage::fragment).unoptimised, "Main"));
    const auto positions =
        std::count_if(code.instructions().begin(), code.instructions().end(), [](const auto& one) {
          return one.op == spv::OpDecorate && one.operands[1] == spv::DecorationBuiltIn &&
                 one.operands[2] == spv::BuiltInFragCoord;
        });
    EXPECT_EQ(positions, 1) << text;
  }
}

// From version 1.4 on the interface lists every variable; glslang writes 1.3 at most here.
TEST(CountedModule, OfALaterSpirvListsItsVariables) {
  CompileResult result = kept("[numthreads(1, 1, 1)] void Main() {}\n");
  result.unoptimised[1] = 0x00010500U;
  const spirv::Module module = counted_module(result.unoptimised, "Main", VulkanVersion::v1_2);
  EXPECT_THAT(validation_problems(module, VulkanVersion::v1_2, false), testing::IsEmpty());
}

bool has(const spirv::Module& module, spv::Op op, std::uint32_t second) {
  const spirv::Code code(module);
  return std::any_of(code.instructions().begin(), code.instructions().end(), [&](const auto& one) {
    return one.op == op && one.operands.size() > 1 && one.operands[1] == second;
  });
}

TEST(CountedModule, TestsDepthFirstWhereNothingButOutputsIsWritten) {
  const std::string declared =
      "Texture2D _In;\nRWTexture2D<float> _Image;\nRWStructuredBuffer<float> _Out;\n"
      "StructuredBuffer<float> _Numbers;\n";
  const auto first = [&](const std::string& text) {
    return has(counted_module(kept(declared + text, hlsl::Stage::fragment).unoptimised, "Main"),
               spv::OpExecutionMode, spv::ExecutionModeEarlyFragmentTests);
  };
  EXPECT_TRUE(first("float4 Main() : SV_Target { return _In[uint2(1, 1)] + _Numbers[1]; }"));
  for (const char* other :
       {"float4 Main() : SV_Target { clip(_In[uint2(1, 1)].x); return 1; }",
        "float Main() : SV_Depth { return _In[uint2(1, 1)].x; }",
        "float4 Main(out uint covered : SV_Coverage) : SV_Target { covered = 1; return 1; }",
        "float4 Main() : SV_Target { _Image[uint2(1, 1)] = 1; return 1; }",
        "float4 Main() : SV_Target { _Out[1] = 1; return 1; }"})
    EXPECT_FALSE(first(other)) << other;
}

TEST(CountedModule, OfOtherStagesNamesAndWordsIsRefused) {
  const CompileResult compute = kept(kReads);
  EXPECT_THROW(counted_module(compute.unoptimised, "Mian"), std::invalid_argument);
  const CompileResult vertex = kept("float4 Main() : SV_Position { return 1; }\n", hlsl::Stage::vertex);
  EXPECT_THROW(counted_module(vertex.unoptimised, "Main"), std::invalid_argument);
  EXPECT_THROW(counted_module({}, "Main"), std::invalid_argument);
  EXPECT_THROW(counted_module({1, 2, 3, 4, 5}, "Main"), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::shaders
