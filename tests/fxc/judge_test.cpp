// Runs FXC itself, in its confined process.
#include "fxc/judge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "fxc/at_hand.h"
#include "fxc/fxc.h"
#include "input/input_error.h"
#include "platform/worker_pool.h"

namespace penumbra::fxc {
namespace {

using testing::HasSubstr;

const char* const kDoubles =
    "RWStructuredBuffer<float> o; [numthreads(8, 8, 1)] void Main(uint3 id : SV_DispatchThreadID)\n"
    "{ o[id.x] = 2.0 * o[id.x]; }\n";

Judge judge(JudgeLimits limits = {}) {
  return Judge(require_fxc(), limits);
}

TEST(FxcJudge, CompilesManyProgramsInOneProcess) {
  PENUMBRA_NEEDS_FXC();
  Judge fxc = judge();
  for (int i = 0; i < 3; ++i) {
    const Verdict verdict = fxc.compile({kDoubles, "Main", "cs_5_0"});
    EXPECT_TRUE(verdict.compiled);
    EXPECT_EQ(verdict.messages, "");
    EXPECT_EQ(verdict.bytecode.substr(0, 4), "DXBC");
    const Verdict refused = fxc.compile({kDoubles, "Absent", "cs_5_0"});
    EXPECT_FALSE(refused.compiled);
    EXPECT_THAT(refused.messages, HasSubstr("X3501"));
    EXPECT_EQ(refused.bytecode, "");
  }
}

// URP's macros give the types these names for mobile platforms.
TEST(FxcJudge, KnowsUnitysTypesWithAPrecision) {
  PENUMBRA_NEEDS_FXC();
  Judge fxc = judge();
  const Verdict verdict =
      fxc.compile({"Texture2D_half t; TextureCube_float c; SamplerState_half s; sampler2D_half old;\n"
                   "float4 Main(float2 uv : UV) : SV_Target { return t.Sample(s, uv) + c.Sample(s, uv.xyx) + "
                   "tex2D(old, uv); }",
                   "Main", "ps_5_0"});
  EXPECT_TRUE(verdict.compiled) << verdict.messages;
}

TEST(FxcJudge, SaysWhatUnityWouldShow) {
  PENUMBRA_NEEDS_FXC();
  Judge fxc = judge();
  EXPECT_THAT(
      fxc.compile({"float4 Main(int a : A) : SV_Target { return a / 3; }", "Main", "ps_4_0"}).messages,
      HasSubstr("(1,45-49): warning X3556"));
  const Verdict reserved =
      fxc.compile({"float4 Main() : SV_Target\n{ int pass = 1; return pass; }", "Main", "ps_5_0"});
  EXPECT_FALSE(reserved.compiled);
  EXPECT_THAT(reserved.messages, HasSubstr("(2,7"));
}

TEST(FxcJudge, LeavesNoFilesBehind) {
  PENUMBRA_NEEDS_FXC();
  // Other tests make such folders in the usual place at the same time.
  const std::filesystem::path own = std::filesystem::path(testing::TempDir()) / "fxc-leaves-no-files";
  std::filesystem::create_directories(own);
  ::setenv("TMPDIR", own.c_str(), 1);
  Judge fxc = judge();
  EXPECT_TRUE(std::filesystem::is_empty(own));
  Installation broken = require_fxc();
  broken.library = own.parent_path() / "fxc-broken.dll";
  std::ofstream(broken.library, std::ios::binary) << "MZ" << std::string(3000000, '\x17');
  for (int i = 0; i < 4; ++i) EXPECT_THROW(Judge{broken}, EnvironmentError);
  std::this_thread::sleep_for(std::chrono::seconds(1));
  EXPECT_TRUE(std::filesystem::is_empty(own));
  ::unsetenv("TMPDIR");
  EXPECT_TRUE(fxc.compile({kDoubles, "Main", "cs_5_0"}).compiled);
}

TEST(FxcJudge, FoldersMayHaveLettersBeyondAscii) {
  PENUMBRA_NEEDS_FXC();
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "fxc-für-José-日本";
  std::filesystem::create_directories(folder);
  Installation there = require_fxc();
  for (std::filesystem::path* file : {&there.worker, &there.library}) {
    const std::filesystem::path copy = folder / file->filename();
    std::filesystem::copy_file(*file, copy, std::filesystem::copy_options::overwrite_existing);
    *file = copy;
  }
  EXPECT_TRUE(Judge(there).compile({kDoubles, "Main", "cs_5_0"}).compiled);
  // Wine takes no such folder, so it gets another.
  ::setenv("TMPDIR", folder.c_str(), 1);
  Judge fxc(there);
  ::unsetenv("TMPDIR");
  EXPECT_TRUE(fxc.compile({kDoubles, "Main", "cs_5_0"}).compiled);
}

TEST(FxcJudge, HasStackForNestedExpressions) {
  PENUMBRA_NEEDS_FXC();
  std::string text = "1.0 * a";
  for (int i = 0; i < 1000; ++i) text = "sin(" + text + ")";
  Judge fxc = judge();
  EXPECT_TRUE(fxc.compile({"float4 Main(float a : A) : SV_Target { return " + text + "; }", "Main", "ps_5_0"})
                  .compiled);
}

// FXC unrolls all of it.
const char* const kUnrolled =
    "float4 Main(float4 a : A) : SV_Target { float4 s = 0; [unroll(1000)] for (int i = 0; i < 1000; ++i) "
    "[unroll(1000)] for (int j = 0; j < 1000; ++j) s = sin(s * a + cos(s + i * j)); return s; }";

void expect_spent(const JudgeLimits& limits, const std::string& why) {
  Judge fxc = judge(limits);
  try {
    fxc.compile({kUnrolled, "Main", "ps_5_0"});
    FAIL() << "it compiled";
  } catch (const platform::WorkerSpent& spent) {
    EXPECT_EQ(spent.what(), why);
  }
  EXPECT_THROW(fxc.compile({kDoubles, "Main", "cs_5_0"}), platform::WorkerSpent);
}

TEST(FxcJudge, AProgramThatTakesTooLongEndsIt) {
  PENUMBRA_NEEDS_FXC();
  expect_spent({1, 2048}, "took more than 1 s of CPU time in FXC");
}

TEST(FxcJudge, AProgramThatTakesTooMuchMemoryEndsIt) {
  PENUMBRA_NEEDS_FXC();
  expect_spent({60, 256}, "ran out of memory in FXC, which may take 256 MiB");
}

TEST(FxcJudge, ProfilesAreUnitys) {
  EXPECT_EQ(profile_for(hlsl::Stage::fragment, 0), "ps_4_0");
  EXPECT_EQ(profile_for(hlsl::Stage::vertex, 35), "vs_4_0");
  EXPECT_EQ(profile_for(hlsl::Stage::geometry, 40), "gs_4_0");
  EXPECT_EQ(profile_for(hlsl::Stage::fragment, 45), "ps_5_0");
  EXPECT_EQ(profile_for(hlsl::Stage::compute, 0), "cs_5_0");
  EXPECT_EQ(profile_for(hlsl::Stage::hull, 46), "hs_5_0");
}

}  // namespace
}  // namespace penumbra::fxc
