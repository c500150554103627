// Tests the driver as it is on this machine, on a GPU that is not there.
#include "cost/null_radv.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <vector>

#include "cost/cost_report.h"
#include "cost/families.h"
#include "input/input_error.h"
#include "input/input_error_matcher.h"
#include "shaders/compile.h"

namespace penumbra::cost {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

NullRadv radv(const std::string& family = "navi21") {
  return {family, PENUMBRA_PROGRAM};
}

ModuleToMeasure module_of(const std::string& text, hlsl::Stage stage = hlsl::Stage::fragment) {
  shaders::CompileRequest request;
  request.file = "measured.hlsl";
  request.text = text;
  request.stage = stage;
  const shaders::CompileResult compiled = shaders::compile(request);
  EXPECT_FALSE(compiled.spirv.empty()) << hlsl::format(compiled.diagnostics.at(0));
  return {compiled.spirv, stage, "Main"};
}

Measurement measure_one(const NullRadv& radv, const ModuleToMeasure& module) {
  return measure(radv, std::span(&module, 1)).at(0);
}

Figures figures(const std::string& text, hlsl::Stage stage = hlsl::Stage::fragment) {
  const Measurement measured = measure_one(radv(), module_of(text, stage));
  EXPECT_THAT(measured.failure, IsEmpty());
  return measured.figures;
}

// The shader's average of `taps` comparisons along a line is all written out.
std::string taps_shader(int taps) {
  std::string text =
      "Texture2D<float> map; SamplerComparisonState s;\n"
      "float4 Main(float3 at : TEXCOORD0) : SV_Target { float sum = 0;\n";
  for (int i = 0; i < taps; ++i)
    text += "sum += map.SampleCmpLevelZero(s, at.xy + float2(" + std::to_string(i) + ", 0) * 0.01, at.z);\n";
  return text + "return sum / " + std::to_string(taps) + "; }\n";
}

TEST(NullRadv, OpensAFamilyWithoutItsHardware) {
  const RadvFamily family = open_family(radv());
  EXPECT_THAT(family.device, HasSubstr("RADV"));
  EXPECT_THAT(family.device, HasSubstr("NAVI21"));
  EXPECT_THAT(family.driver, StartsWith("radv Mesa "));
}

TEST(NullRadv, AnUnknownFamilyIsNamedWithTheNearest) {
  expect_input_error([] { open_family(radv("navi-21")); },
                     AllOf(HasSubstr("--family: this machine's RADV does not know the family 'navi-21'"),
                           HasSubstr("did you mean 'navi21'?")));
}

// The list is of the Mesa version that the committed figures are of; others know more, fewer or other names.
TEST(NullRadv, KnownFamiliesOpen) {
  const std::string committed =
      read_cost_report(PENUMBRA_SOURCE_DIR "/Documentation~/results/cost.json").driver;
  const bool same_driver = open_family(radv()).driver == committed;
  const std::vector<std::string> names = same_driver ? known_family_names() : default_families();
  for (const std::string& name : names) EXPECT_NO_THROW(open_family(radv(name))) << name;
}

TEST(NullRadv, EveryFigureIsThere) {
  const Measurement measured = measure_one(radv(), module_of(taps_shader(4)));
  ASSERT_THAT(measured.failure, IsEmpty());
  for (const FigureName& name : figure_names()) {
    // The figures from here on are of Direct3D's bytecode.
    if (name.value == &Figures::arithmetic) break;
    EXPECT_TRUE((measured.figures.*name.value).has_value()) << name.key << " of " << name.driver_name;
  }
  EXPECT_TRUE(measured.subgroup_size == 32 || measured.subgroup_size == 64) << measured.subgroup_size;
}

TEST(NullRadv, MoreTapsCostMore) {
  const Figures four = figures(taps_shader(4));
  const Figures sixteen = figures(taps_shader(16));
  EXPECT_GE(*sixteen.instructions, *four.instructions + 12) << "a tap is an instruction at least";
  EXPECT_GT(*sixteen.code_size_bytes, *four.code_size_bytes);
  EXPECT_GT(*sixteen.latency_cycles, *four.latency_cycles);
  EXPECT_GT(*sixteen.inverse_throughput_cycles, *four.inverse_throughput_cycles);
}

TEST(NullRadv, TheSameShaderCostsTheSameTwice) {
  const ModuleToMeasure module = module_of(taps_shader(9));
  EXPECT_EQ(measure_one(radv(), module).statistics, measure_one(radv(), module).statistics);
}

TEST(NullRadv, FamiliesDiffer) {
  const ModuleToMeasure module = module_of(taps_shader(9));
  EXPECT_NE(measure_one(radv("polaris10"), module).statistics,
            measure_one(radv("gfx1100"), module).statistics);
}

TEST(NullRadv, WhatTheUserSetsForOtherProgramsChangesNothing) {
  const ModuleToMeasure module = module_of(taps_shader(9));
  const Figures before = measure_one(radv(), module).figures;
  ::setenv("ACO_DEBUG", "noopt,nosched", 1);
  ::setenv("RADV_PERFTEST", "pswave32", 1);
  const Figures after = measure_one(radv(), module).figures;
  ::unsetenv("ACO_DEBUG");
  ::unsetenv("RADV_PERFTEST");
  EXPECT_EQ(before, after);
}

// A vertex shader that wrote constants, the same value everywhere or nothing would make interpolation go
// away: on AMD an interpolated component takes two instructions.
TEST(NullRadv, EveryInputOfAFragmentShaderIsInterpolated) {
  std::string parameters;
  std::string sum;
  for (int i = 0; i < 8; ++i) {
    parameters += (i == 0 ? "" : ", ") + std::string("float4 v") + std::to_string(i) + " : TEXCOORD" +
                  std::to_string(i);
    sum += (i == 0 ? "" : " * ") + std::string("v") + std::to_string(i);
  }
  const Figures measured = figures("float4 Main(" + parameters + ") : SV_Target { return " + sum + "; }");
  EXPECT_GE(*measured.instructions, 2U * 8U * 4U + 7U * 4U);
}

TEST(NullRadv, InputsMayBeIntegersArraysAndMatrices) {
  const Figures measured = figures(
      "float4 Main(float4 p : SV_Position, nointerpolation int3 i : A, nointerpolation uint u : B, float3x3 "
      "m : C,\n"
      "            float2 list[2] : D) : SV_Target { return float4(mul(m, i), u) + list[1].xyxy * p; }");
  EXPECT_GT(*measured.instructions, 0U);
}

// A fragment shader that read nothing would take all but the position out of the vertex shader.
TEST(NullRadv, EveryOutputOfAVertexShaderStays) {
  const std::string head =
      "struct Passed { float4 position : SV_Position; float4 colour : COLOR; uint id : ID; };\n"
      "Passed Main(float4 position : POSITION, float4 colour : COLOR, uint4 bones : BONES) {\n"
      "Passed passed; passed.position = position; passed.id = bones.w;\n";
  const Figures plain = figures(head + "passed.colour = 0; return passed; }", hlsl::Stage::vertex);
  const Figures sines = figures(head + "passed.colour = sin(colour); return passed; }", hlsl::Stage::vertex);
  EXPECT_GE(*sines.instructions, *plain.instructions + 8) << "four times scale and sine";
}

TEST(NullRadv, ComputeShadersAndEveryKindOfResource) {
  const Figures measured = figures(
      "cbuffer Block { float4 a; }; Texture2D<float4> t; SamplerState s; RWTexture2D<float4> image;\n"
      "Buffer<float4> texels; RWBuffer<float4> writable; StructuredBuffer<float4> in_; Texture2D<float> "
      "list[4];\n"
      "RWStructuredBuffer<float4> out_; groupshared float4 shared_[64];\n"
      "[numthreads(64, 1, 1)] void Main(uint3 id : SV_DispatchThreadID, uint at : SV_GroupIndex) {\n"
      "shared_[at] = in_[id.x] + texels[id.x] + t.SampleLevel(s, a.xy, 0) + list[3].SampleLevel(s, a.xy, "
      "0);\n"
      "GroupMemoryBarrierWithGroupSync(); image[id.xy] = shared_[63 - at]; writable[id.x] = a; out_[id.x] = "
      "a; }",
      hlsl::Stage::compute);
  EXPECT_EQ(measured.lds_bytes, 64U * 16U);
}

TEST(NullRadv, ABrokenModuleIsSaidAndNeverReachesTheDriver) {
  const ModuleToMeasure good = module_of(taps_shader(1));
  ModuleToMeasure truncated = good;
  truncated.spirv.resize(truncated.spirv.size() / 2);
  ModuleToMeasure poisoned = good;
  poisoned.spirv.back() = 0xFFFFFFFF;
  for (const ModuleToMeasure& broken : {truncated, poisoned, ModuleToMeasure{}})
    EXPECT_THAT(measure_one(radv(), broken).failure, StartsWith("not valid SPIR-V for Vulkan 1.1: "));
}

TEST(NullRadv, AnEntryPointThatIsNotThereIsAFailure) {
  ModuleToMeasure module = module_of(taps_shader(1));
  module.entry = "NoSuchEntry";
  const Measurement measured = measure_one(radv(), module);
  EXPECT_THAT(measured.failure, HasSubstr("NoSuchEntry"));
}

TEST(NullRadv, AStageWithoutAMeasureIsAFailure) {
  ModuleToMeasure module = module_of(taps_shader(1));
  module.stage = hlsl::Stage::geometry;
  EXPECT_THAT(measure_one(radv(), module).failure, HasSubstr("geometry shaders are not measured"));
}

// These programs end as a driver's compiler might, in the worker's place.
class Ending : public testing::Test {
 protected:
  NullRadv worker(const std::string& script) const {
    const std::filesystem::path file =
        std::filesystem::path(testing::TempDir()) /
        (std::string("penumbra-worker-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return {"navi21", file};
  }
  const ModuleToMeasure module_ = module_of(taps_shader(1));
};

TEST_F(Ending, AKilledChildIsAFailureWithSignalAndLastWords) {
  const Measurement measured = measure_one(worker("echo 'last words' >&2; kill -SEGV $$"), module_);
  EXPECT_EQ(measured.failure, "the driver's compiler was terminated by signal 11: last words");
  EXPECT_EQ(measured.figures, Figures());
}

TEST_F(Ending, AHangingChildIsAFailureAfterTheTimeLimit) {
  NullRadv hanging = worker("sleep 3000");
  hanging.time_limit = std::chrono::milliseconds(200);
  EXPECT_EQ(measure_one(hanging, module_).failure, "the driver's compiler did not finish within 0.2 s");
}

TEST_F(Ending, AnAnswerThatIsNoneIsAFailure) {
  EXPECT_EQ(measure_one(worker("echo nonsense"), module_).failure,
            "the worker ended with exit code 0 without a response");
  EXPECT_THAT(measure_one(worker("echo '{}'; echo '{\"subgroup_size\": 3}'"), module_).failure,
              Not(IsEmpty()));
  EXPECT_THAT(
      measure_one(worker("echo '{}'; echo '{\"subgroup_size\": 64, \"statistics\": [{}]}'"), module_).failure,
      StartsWith("the worker's response cannot be parsed"));
  EXPECT_EQ(
      measure_one(worker("echo '{}'; echo '{\"subgroup_size\": 64, \"statistics\": []}'"), module_).failure,
      "the driver has no statistics of the shader");
}

// The first of a worker's modules has its figures, the second ends it, the third has a worker of its own.
TEST_F(Ending, OneOfSeveralCostsItsOwnResultAlone) {
  const NullRadv ends = worker(
      "echo '{}'; echo '{\"subgroup_size\": 64, \"statistics\": [{\"name\": \"Instructions\", \"value\": "
      "7}]}'; "
      "kill -SEGV $$");
  const std::vector<Measurement> measured = measure(ends, std::vector(3, module_));
  ASSERT_EQ(measured.size(), 3U);
  EXPECT_EQ(measured[0].figures.instructions, 7U);
  EXPECT_EQ(measured[1].failure, "the driver's compiler was terminated by signal 11");
  EXPECT_EQ(measured[2].figures.instructions, 7U);
}

TEST(NullRadv, ABrokenModuleAmongOthersLeavesThemTheirFigures) {
  const ModuleToMeasure good = module_of(taps_shader(4));
  const std::vector<Measurement> measured = measure(radv(), std::vector{good, ModuleToMeasure{}, good});
  ASSERT_EQ(measured.size(), 3U);
  EXPECT_THAT(measured[1].failure, StartsWith("not valid SPIR-V for Vulkan 1.1: "));
  EXPECT_EQ(measured[0].statistics, measured[2].statistics);
  EXPECT_EQ(measured[0].statistics, measure_one(radv(), good).statistics);
}

TEST_F(Ending, AMissingWorkerIsTheEnvironments) {
  EXPECT_THROW(measure_one({"navi21", "/no/such/program"}, module_), EnvironmentError);
}

}  // namespace
}  // namespace penumbra::cost
