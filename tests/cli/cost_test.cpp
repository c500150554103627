#include <nlohmann/json.hpp>

#include "cli/hostile_shaders.h"
#include "cli/program.h"
#include "fxc/at_hand.h"

namespace penumbra {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class Cost : public ProgramTest {
 protected:
  std::string shader() const {
    return write("tinted.hlsl",
                 "float4 tint; float4 Main(float4 colour : COLOR) : SV_Target {\n"
                 "#ifdef DARK\n  colour = sqrt(colour);\n#endif\n  return colour * tint; }\n")
        .string();
  }
  // A baseline of the shader, with the first `from` in it made `to`.
  std::string baseline(const std::string& from, const std::string& to) const {
    const auto written = expect_success({"cost", shader(), "--family", "navi21", "--format", "json"});
    std::string text = written.output;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from << " in\n" << text;
    return write("baseline.json", text.replace(at, from.size(), to)).string();
  }
};

TEST_F(Cost, TheWorkersSubcommandIsNotInHelp) {
  const auto help = run({"--help"});
  EXPECT_THAT(help.output, HasSubstr("\n  cost "));
  EXPECT_THAT(help.output, Not(HasSubstr("cost-worker")));
}

TEST_F(Cost, AUsersFileWithKeywordSetsGivesTheSameBytesTwice) {
  const std::vector<std::string> command{"cost",   shader(),        "--family", "navi21",   "--keyword-set",
                                         "UNUSED", "--keyword-set", "DARK",     "--format", "csv"};
  const auto once = expect_success(command);
  EXPECT_THAT(once.output, StartsWith("family,techniques,file,entry,stage,keywords,instructions,"));
  EXPECT_THAT(once.output, HasSubstr("Main,fragment,+UNUSED,"));
  EXPECT_THAT(once.output, HasSubstr("Main,fragment,+DARK,"));
  EXPECT_EQ(run(command).output, once.output);
}

// The counts are those of Unity's inspector, for the macros of Direct3D 11.
TEST_F(Cost, BytecodeIsCountedWithoutADriver) {
  PENUMBRA_NEEDS_FXC();
  const std::string file =
      write("Group.compute",
            "#pragma kernel Main\n#if !defined(SHADER_API_D3D11)\n#error another API\n"
            "#endif\ngroupshared float4 shared_values[64];\nTexture2D<float4> t;\n"
            "RWStructuredBuffer<float4> o;\n[numthreads(64, 1, 1)] void Main(uint i : "
            "SV_GroupIndex)\n{\n    shared_values[i] = t.Load(int3(i, 0, 0));\n    "
            "GroupMemoryBarrierWithGroupSync();\n    o[i] = shared_values[63 - i] * 2;\n}\n")
          .string();
  const auto result =
      run_with_fxc({"cost", file, "--family", "d3d11", "--format", "json", "-o", path("cost.json").string()});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  const nlohmann::json report = nlohmann::json::parse(read("cost.json"));
  EXPECT_THAT(report["driver"].get<std::string>(), StartsWith("FXC "));
  EXPECT_EQ(report["compiler"], report["driver"]);
  ASSERT_EQ(report["rows"].size(), 1U);
  EXPECT_THAT(run_with_fxc({"cost", "--list-families"}).output, HasSubstr("d3d11"));
  const nlohmann::json figures = report["rows"][0]["figures"];
  EXPECT_EQ(figures["lds_bytes"], 64 * 16);
  EXPECT_EQ(figures["textures"], 1);
  EXPECT_EQ(figures["branches"], 0);
  EXPECT_GE(figures["arithmetic"], 1);
  EXPECT_GE(figures["temporaries"], 1);
  EXPECT_GT(figures["instructions"], 4);
  const auto table = run_with_fxc({"cost", file, "--family", "d3d11"});
  EXPECT_THAT(table.output, AllOf(HasSubstr("d3d11: Direct3D bytecode, FXC "), HasSubstr("temporaries"),
                                  Not(HasSubstr("lanes")), Not(HasSubstr("VGPRs"))));
}

TEST_F(Cost, WhatFxcRefusesIsAFindingAtItsLine) {
  PENUMBRA_NEEDS_FXC();
  const std::string file =
      write("reserved.hlsl", "float4 Main() : SV_Target\n{ float pass = 1; return pass; }\n").string();
  const auto result = run_with_fxc({"cost", file, "--family", "d3d11"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("reserved.hlsl:2:9: error: X3000: syntax error: unexpected token"));
}

TEST_F(Cost, WithoutFxcBytecodeIsAnEnvironmentError) {
  const auto result = run({"cost", shader(), "--family", "d3d11"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.errors, HasSubstr("FXC"));
  const auto families = run_with_fxc({"cost", "--list-families", "--fxc", "off"});
  EXPECT_THAT(families.output, AllOf(HasSubstr("navi21"), Not(HasSubstr("d3d11"))));
}

TEST_F(Cost, StagesThatAreNotMeasuredAreNamed) {
  const std::string file =
      write("Geometry.shader",
            "Shader \"G\" { SubShader { Pass {\nHLSLPROGRAM\n#pragma vertex Vert\n#pragma geometry "
            "Geom\n#pragma "
            "fragment Frag\nstruct V { float4 p : SV_Position; };\nV Vert(float4 p : POSITION) { V v; v.p = "
            "p; return "
            "v; }\n[maxvertexcount(1)] void Geom(point V v[1], inout PointStream<V> s) { s.Append(v[0]); }\n"
            "float4 Frag() : SV_Target { return 1; }\nENDHLSL\n} } }\n")
          .string();
  const auto result = expect_success({"cost", file, "--family", "navi21", "--format", "csv"});
  EXPECT_THAT(result.errors,
              HasSubstr("Geometry.shader:2:1: warning: the geometry program 'Geom' is not measured: only "
                        "vertex, fragment and compute programs are"));
  EXPECT_THAT(result.output, HasSubstrs(",Vert,", ",Frag,"));
}

TEST_F(Cost, EveryPassOfAShaderHasItsRows) {
  const std::string file =
      write(
          "Two.shader",
          "Shader \"Two\" { SubShader {\nPass { Name \"One\"\nHLSLPROGRAM\n#pragma vertex Vert\n#pragma "
          "fragment "
          "Frag\n#pragma multi_compile _ DARK\nfloat4 tint;\n#ifdef SHADER_API_VULKAN\nfloat4 Vert(float4 p "
          ": "
          "POSITION) : SV_Position { return p; }\n#endif\nfloat4 Frag() : SV_Target {\n#ifdef DARK\n    "
          "return "
          "sqrt(tint);\n#endif\n    return tint; }\nENDHLSL }\nPass {\nHLSLPROGRAM\n#pragma vertex "
          "Vert\n#pragma "
          "fragment Frag\nfloat4 Vert(float4 p : POSITION) : SV_Position { return p.yxzw; }\nfloat4 Frag() : "
          "SV_Target { return 1; }\nENDHLSL }\n} }\n")
          .string();
  const auto result = expect_success({"cost", file, "--family", "navi21", "--format", "csv"});
  for (const char* row :
       {": One,Vert,vertex,", ": One,Frag,fragment,", ": 0.1,Vert,vertex,", ": 0.1,Frag,fragment,"})
    EXPECT_THAT(result.output, HasSubstr(file + row));
  const auto dark = run({"cost", file, "--family", "navi21", "--format", "csv", "--keyword-set", "DARK"});
  EXPECT_THAT(dark.output, HasSubstr(": One,Frag,fragment,+DARK,"));
}

TEST_F(Cost, AUsersFileSeesTheMacrosThatUnityDefines) {
  const std::string file = write("Own.hlsl",
                                 "#if !defined(SHADER_API_VULKAN) || !defined(UNITY_VERSION) || "
                                 "!defined(SHADER_STAGE_FRAGMENT)\n#error no macros\n#endif\n"
                                 "float4 Main() : SV_Target { return 1; }\n")
                               .string();
  const auto result = expect_success({"cost", file, "--family", "navi21", "--format", "csv"});
  EXPECT_THAT(result.output, HasSubstr(file + ",Main,fragment,"));
}

TEST_F(Cost, WhatHasNoEffectOrIsNoShaderIsRefused) {
  EXPECT_THAT(run({"cost", "--technique", "tent-5", "--entry", "Main"}).errors,
              HasSubstr("--entry has no effect without a file"));
  EXPECT_THAT(run({"cost", shader(), "--tolerance", "5"}).errors,
              HasSubstr("--tolerance has no effect without --baseline"));
  EXPECT_THAT(run({"cost", write("a.shadergraph", "{}").string()}).errors,
              HasSubstr("View Generated Shader"));
}

// A shader that compiles beside it has its row.
TEST_F(Cost, AShaderThatEndsTheCompilerIsNamedAndTheOthersAreMeasured) {
  const std::string main = "float4 Main() : SV_Target";
  const std::string crashes = write("crashes.hlsl", comma_chain(main)).string();
  const std::string nests = write("nests.hlsl", deep_parentheses(main)).string();
  const auto result = run({"cost", crashes, shader(), nests, "--family", "navi21", "--format", "csv"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors,
              HasSubstr(crashes + ": error: the compiler crashed with SIGSEGV; leave out parts"));
  EXPECT_THAT(result.errors, HasSubstr(nests + ":3:1011: error: more than 1000 levels of nesting"));
  EXPECT_THAT(result.output, HasSubstr("tinted.hlsl,Main,fragment,"));
}

TEST_F(Cost, AShaderThatNeverEndsOrFillsTheMemoryEndsAtTheLimit) {
  const std::string main = "float4 Main() : SV_Target";
  const std::string bomb = write("bomb.hlsl", macro_bomb(main)).string();
  const std::string unrolls = write("unrolls.hlsl", endless_unrolling(main)).string();
  const auto result =
      run({"cost", bomb, unrolls, "--family", "navi21", "--time-limit", "3", "--memory-limit", "128"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr(bomb + ":43:12: error: a macro expansion that is too large"));
  EXPECT_THAT(result.errors, HasSubstr(unrolls + ": error: the compiler took more than "));
}

#ifdef PENUMBRA_FILTERS_SYSTEM_CALLS
// The driver's process waits for its module: by then it has given up what it does not need.
TEST_F(Cost, TheDriversProcessIsConfinedBeforeItReadsAModule) {
  ASSERT_EQ(shell("mkfifo '" + path("module").string() + "'").exit_code, 0);
  const auto result = shell(
      "export RADV_FORCE_FAMILY=navi21; '" PENUMBRA_PROGRAM "' cost-worker 60 <'" + path("module").string() +
      "' & worker=$!; exec 9>'" + path("module").string() +
      "'; for i in $(seq 600); do grep -q 'Seccomp:.2' /proc/$worker/status && break; sleep 0.05; done; "
      "grep -E 'Seccomp:|NoNewPrivs' /proc/$worker/status; "
      "echo '{\"stage\": \"fragment\", \"entry\": \"Main\", \"words\": 0}' >&9; exec 9>&-; wait $worker");
  EXPECT_THAT(result.output, HasSubstrs("NoNewPrivs:\t1", "Seccomp:\t2", "not valid SPIR-V for Vulkan 1.1"));
}
#endif

TEST_F(Cost, AFamilyOrTechniqueNamedTwiceIsMeasuredOnce) {
  const std::vector<std::string> once{"cost", "--technique", "hard", "--family", "navi21", "--format", "csv"};
  std::vector<std::string> twice = once;
  twice.insert(twice.end(), {"--technique", "hard", "--family", "navi21"});
  const auto result = expect_success(twice);
  EXPECT_EQ(result.output, run(once).output);
}

TEST_F(Cost, ItsOwnBaselinePasses) {
  const auto result =
      expect_success({"cost", shader(), "--family", "navi21", "--baseline", baseline("{", "{")});
  EXPECT_THAT(result.errors, HasSubstr("1 row compared, 0 figures worse"));
}

TEST_F(Cost, AWorseFigureIsAFindingAndATolerancePermitsIt) {
  baseline("{", "{");
  std::string text = read("baseline.json");
  const std::size_t at = text.find("\"code_size_bytes\":") + std::string("\"code_size_bytes\":").size();
  const std::size_t end = text.find(',', at);
  const int bytes = std::stoi(text.substr(at, end - at));
  text.replace(at, end - at, std::to_string(bytes - 4));
  const std::string file = write("baseline.json", text).string();
  std::vector<std::string> command{"cost", shader(), "--family", "navi21", "--baseline", file};
  const auto result = run(command);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("tinted.hlsl Main: code bytes " + std::to_string(bytes - 4) + " -> " +
                                       std::to_string(bytes)));
  command.insert(command.end(), {"--tolerance", "900"});
  EXPECT_EQ(run(command).exit_code, 0);
}

TEST_F(Cost, ABaselineOfAnotherDriverIsRefusedUnlessAsked) {
  const std::string file = baseline("radv Mesa ", "radv Mesa 1.");
  std::vector<std::string> command{"cost", shader(), "--family", "navi21", "--baseline", file};
  const auto refused = run(command);
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.output, IsEmpty()) << "it is said before anything is measured";
  EXPECT_THAT(refused.errors, HasSubstrs("measured with radv Mesa 1.", "--any-driver"));
  command.emplace_back("--any-driver");
  const auto compared = expect_success(command);
  EXPECT_THAT(compared.errors, HasSubstr("note: "));
}

TEST_F(Cost, BadInputIsTwo) {
  const auto family = run({"cost", shader(), "--family", "navi2l"});
  EXPECT_EQ(family.exit_code, 2);
  EXPECT_THAT(family.errors, HasSubstr("did you mean 'navi21'?"));
  EXPECT_THAT(run({"cost", shader(), "--family", "d3d12"}).errors, HasSubstr("d3d11"));
  expect_bad_input({"cost", "--technique", "tent5"}, HasSubstr("tent-5"));
  EXPECT_EQ(run({"cost", path("absent.hlsl").string()}).exit_code, 2);
  const auto baseline_file = write("bad.json", "{\"rows\": [}");
  expect_bad_input({"cost", shader(), "--baseline", baseline_file.string()}, HasSubstr("bad.json:1:"));
}

TEST_F(Cost, AShaderThatDoesNotCompileIsAFindingAtItsLine) {
  const auto file = write("broken.hlsl", "float4 Main() : SV_Target\n{ return undeclared; }\n");
  const auto result = run({"cost", file.string(), "--family", "navi21"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("broken.hlsl:2:10: error:"));
}

TEST_F(Cost, WithoutRadvItSaysWhatToInstall) {
  const auto result = shell("VK_DRIVER_FILES=/no/such.json VK_ICD_FILENAMES=/no/such.json " PENUMBRA_PROGRAM
                            " cost --technique hard --family navi21");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.errors,
              HasSubstrs("RADV, Mesa's Vulkan driver for AMD, cannot be used", "mesa-vulkan-drivers"));
}

}  // namespace
}  // namespace penumbra
