// penumbra validate with FXC, Unity's compiler, as a user runs it.
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <map>
#include <set>

#include "cli/program.h"
#include "fxc/at_hand.h"
#include "validate_report.h"

namespace penumbra {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class ValidateFxc : public ProgramTest {
 protected:
  // There is one variant that both compilers take, one that FXC alone refuses, one that glslang alone
  // refuses, and one that both do.
  std::string four_variants() const {
    write("Include.hlsl", "#if defined(RESERVED)\nint Wrong() { int pass = 1; return pass; }\n#endif\n");
    return write("Four.compute",
                 "#pragma kernel Main\n#pragma multi_compile _ RESERVED VECTOR UNKNOWN\n#include "
                 "\"Include.hlsl\"\n"
                 "#define THIRD(x) ((x) / 3)\nRWStructuredBuffer<float> o;\n"
                 "[numthreads(8, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)\n{\n    o[id.x] = "
                 "THIRD(int(id.x));\n"
                 "#if defined(RESERVED)\n    o[id.x] = Wrong();\n#endif\n"
                 "#if defined(VECTOR)\n    float1 v; v.x = id.x; o[id.x] = v.x;\n#endif\n"
                 "#if defined(UNKNOWN)\n    o[id.x] = unknown;\n#endif\n}\n")
        .string();
  }

  nlohmann::json report_of(const std::string& text) const;
};

TEST_F(ValidateFxc, ErrorsAndWarningsAreAtTheirPlacesAndTheTwoCompilersAreToldApart) {
  PENUMBRA_NEEDS_FXC();
  const auto result =
      run_with_fxc({"validate", four_variants(), "--target", "spirv,d3d11", "--no-cache", "--no-lint"});
  EXPECT_EQ(result.exit_code, 1) << result.errors;
  EXPECT_THAT(result.output,
              HasSubstr("Include.hlsl:2:19: error: X3000: syntax error: unexpected token 'pass'"));
  EXPECT_THAT(result.output, HasSubstr("with RESERVED, for d3d11"));
  EXPECT_THAT(result.output,
              HasSubstr("Four.compute:8:15: warning: X3556: integer divides may be much slower"));
  EXPECT_THAT(
      result.output,
      HasSubstr("of 4 variants that both compilers read, FXC alone refuses 1, glslang alone 1, both 1"));
  EXPECT_THAT(result.output, HasSubstr("d3d11: FXC "));
}

// Direct3D 11 has two targets, whose variants are the same; FXC's have no module to be compared.
TEST_F(ValidateFxc, VariantsOfAnApiAreCountedOnceAndTheirKeywordsAreLooked) {
  PENUMBRA_NEEDS_FXC();
  std::filesystem::create_directories(path("Game/ProjectSettings"));
  const std::string file = write("Game/Assets/Unused.hlsl",
                                 "#pragma multi_compile _ _OLD\n#pragma multi_compile _ _NEW\n"
                                 "float4 Main(float2 uv : TEXCOORD0) : SV_Target\n{\n#if defined(_NEW)\n"
                                 "    return 0;\n#endif\n    return uv.xyxy;\n}\n")
                               .string();
  const auto counted =
      run_with_fxc({"validate", file, "--target", "hlsl50,d3d11,spirv", "--count", "--format", "json"});
  EXPECT_EQ(counted.exit_code, 0) << counted.errors;
  const nlohmann::json counts = nlohmann::json::parse(counted.output);
  EXPECT_EQ(counts["results"], 12);
  EXPECT_EQ(counts["programs"].size(), 2U);
  for (const char* targets : {"spirv", "hlsl50,d3d11,spirv"})
    EXPECT_THAT(run_with_fxc({"validate", file, "--target", targets, "--no-cache"}).output,
                testing::AllOf(HasSubstr("Unused.hlsl:1:1: warning: "), HasSubstr("[unused-keyword]"),
                               Not(HasSubstr("Unused.hlsl:2"))))
        << targets;
}

// A limit of ours says nothing of what Unity would do.
TEST_F(ValidateFxc, WhatTakesFxcTooLongIsNotCountedAsRefused) {
  PENUMBRA_NEEDS_FXC();
  const std::string file =
      write("Long.compute",
            "#pragma kernel Main\nRWStructuredBuffer<float> o;\n[numthreads(1, 1, 1)] void Main() {\n"
            "float s = o[0];\n[unroll(1000)] for (int i = 0; i < 1000; ++i)\n"
            "[unroll(1000)] for (int j = 0; j < 1000; ++j) s = sin(s + cos(s + i * j));\nfloat1 v; v.x = s; "
            "o[0] = v.x; }\n")
          .string();
  const auto result = run_with_fxc({"validate", file, "--target", "spirv,d3d11", "--no-cache", "--no-lint",
                                    "--time-limit", "2", "--format", "json"});
  EXPECT_EQ(result.exit_code, 1) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("took more than 2 s of CPU time in FXC"));
  const nlohmann::json report = nlohmann::json::parse(result.output);
  for (const nlohmann::json& record : results_of(report))
    EXPECT_EQ(record["status"], record["target"] == "d3d11" ? "failed" : "unchecked") << record;
}

TEST_F(ValidateFxc, TheReportHasCountsAndIsReadAgain) {
  PENUMBRA_NEEDS_FXC();
  const std::string file = four_variants();
  for (const char* cached : {"0", "8"}) {
    const auto result =
        run_with_fxc({"validate", file, "--target", "spirv,d3d11", "--cache", path("cache").string(),
                      "--format", "json", "-o", path("report.json").string()});
    EXPECT_EQ(result.exit_code, 1) << result.errors;
    const nlohmann::json report = nlohmann::json::parse(read("report.json"));
    EXPECT_EQ(report["front_ends"]["compared"], 4);
    EXPECT_EQ(report["front_ends"]["fxc_alone_refuses"], 1);
    EXPECT_EQ(report["front_ends"]["glslang_alone_refuses"], 1);
    EXPECT_EQ(report["summary"]["cached"].dump(), cached);
  }
  EXPECT_EQ(run({"merge", path("report.json").string()}).exit_code, 1);
}

// Both compilers read the same text: FXC's verdict is not glslang's, in whatever order they are asked.
TEST_F(ValidateFxc, TheCacheTellsTheCompilersApart) {
  PENUMBRA_NEEDS_FXC();
  const std::string file =
      write("Reserved.hlsl",
            "float4 Main(float2 uv : TEXCOORD0) : SV_Target { float pass = uv.x; return pass; }\n")
          .string();
  const auto failures = [&](const std::string& targets) {
    const auto result = run_with_fxc({"validate", file, "--target", targets, "--no-lint", "--cache",
                                      path("cache").string(), "--format", "json"});
    return nlohmann::json::parse(result.output)["summary"]["failed"].get<int>();
  };
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(failures("d3d11,hlsl50"), 1);
    EXPECT_EQ(failures("d3d11"), 1);
    EXPECT_EQ(failures("hlsl50"), 0);
  }
}

TEST_F(ValidateFxc, AProgramThatFxcDoesNotFinishFailsAloneAndIsKept) {
  PENUMBRA_NEEDS_FXC();
  write("Slow.compute",
        "#pragma kernel Main\n#pragma multi_compile _ SLOW\nRWStructuredBuffer<float4> o;\n"
        "[numthreads(8, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)\n{\n    float4 s = 0;\n#if "
        "defined(SLOW)\n"
        "    [unroll(1000)] for (int i = 0; i < 1000; ++i) [unroll(1000)] for (int j = 0; j < 1000; ++j)\n"
        "        s = sin(s * o[i] + cos(s + i * j));\n#endif\n    o[id.x] = s;\n}\n");
  const auto result = run_with_fxc({"validate", path("Slow.compute").string(), "--target", "d3d11",
                                    "--no-cache", "--time-limit", "2", "--keep", path("kept").string()});
  EXPECT_EQ(result.exit_code, 1) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("took more than 2 s of CPU time in FXC"));
  EXPECT_THAT(result.output, HasSubstr("1 failed"));
}

TEST_F(ValidateFxc, PragmasOfFxcHold) {
  PENUMBRA_NEEDS_FXC();
  write("Quiet.compute",
        "#pragma kernel Main\n#pragma warning(disable : 3556)\n#pragma pack_matrix(row_major)\n#define "
        "NOTHING()\nNOTHING()\n"
        "RWStructuredBuffer<float> o; float4x4 m;\n[numthreads(8, 1, 1)] void Main(uint3 id : "
        "SV_DispatchThreadID)\n"
        "{\n    int a = id.x;\n    o[id.x] = a / 3 + m[0][1];\n}\n");
  const auto result =
      run_with_fxc({"validate", path("Quiet.compute").string(), "--target", "spirv,d3d11", "--no-cache"});
  EXPECT_EQ(result.exit_code, 0) << result.output << result.errors;
  EXPECT_THAT(result.output, Not(HasSubstr("X3556")));
}

// `text` is the body of a kernel with the buffer `o`. Returns the report of all targets.
nlohmann::json ValidateFxc::report_of(const std::string& text) const {
  write("One.compute",
        "#pragma kernel Main\nRWStructuredBuffer<float> o; StructuredBuffer<float> r;\n" + text);
  const auto result =
      run_with_fxc({"validate", path("One.compute").string(), "--no-cache", "--no-lint", "--format", "json"});
  EXPECT_LE(result.exit_code, 1) << result.errors;
  return nlohmann::json::parse(result.output);
}

TEST_F(ValidateFxc, WhatGlslangAloneRefusesIsCheckedForEveryTargetFromFxcsBytecode) {
  PENUMBRA_NEEDS_FXC();
  const nlohmann::json report = report_of(
      "[numthreads(8, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)\n"
      "{\n    float1 v; v.x = r[id.x]; o[id.x] = v.x;\n}\n");
  EXPECT_EQ(report["summary"]["failed"], 0);
  EXPECT_EQ(report["summary"]["unreached"], 0);
  for (const nlohmann::json& record : results_of(report)) {
    EXPECT_EQ(record["status"], "passed") << record;
    if (record["target"] == "d3d11") continue;
    ASSERT_EQ(record["messages"].size(), 1U) << record;
    EXPECT_EQ(record["messages"][0]["rule"], "from-bytecode");
  }
}

TEST_F(ValidateFxc, ACrashOfGlslangLeavesTheVerdictToFxc) {
  PENUMBRA_NEEDS_FXC();
  const nlohmann::json report = report_of(
      "float Get(StructuredBuffer<float> b, uint i) { return b[i]; }\n"
      "[numthreads(8, 1, 1)] void Main(uint3 id : SV_DispatchThreadID) { o[id.x] = Get(o, id.x); }\n");
  for (const nlohmann::json& record : results_of(report)) {
    ASSERT_EQ(record["status"], "failed") << record;
    EXPECT_THAT(record["messages"][0]["message"].get<std::string>(), HasSubstr("X3017")) << record;
  }
}

// A target's text from the bytecode is not Unity's, so that an error in it is none of the shader; and a stage
// that a target does not have is absent, whatever made the module.
TEST_F(ValidateFxc, AnErrorInWhatIsMadeFromBytecodeIsUncheckedAndAnAbsentStageIsAbsent) {
  PENUMBRA_NEEDS_FXC();
  const auto statuses = [&](const std::string& stage, const std::string& text) {
    const std::string file = write("Stage.hlsl", text).string();
    const auto result =
        run_with_fxc({"validate", file, "--stage", stage, "--no-cache", "--no-lint", "--format", "json"});
    const nlohmann::json report = nlohmann::json::parse(result.output);
    std::map<std::string, std::string> found;
    for (const nlohmann::json& record : results_of(report)) found[record["target"]] = record["status"];
    return found;
  };
  const auto vertex = statuses(
      "vertex", "float4 Main(uint id : SV_VertexID) : SV_Position { float1 v; v.x = id; return v.x; }\n");
  EXPECT_EQ(vertex.at("essl310"), "unchecked");
  EXPECT_EQ(vertex.at("glsl450"), "passed");
  const auto geometry = statuses(
      "geometry",
      "#pragma target 5.0\nstruct V { float4 p : SV_Position; };\n[maxvertexcount(3)] void Main(triangle V "
      "v[3], inout "
      "TriangleStream<V> s)\n{\n    float1 k; k.x = v[0].p.x; V o = v[0]; o.p.x = k.x; s.Append(o);\n}\n");
  EXPECT_EQ(geometry.at("spirv"), "passed");
  EXPECT_EQ(geometry.at("hlsl50"), "absent");
  EXPECT_EQ(geometry.at("msl23"), "absent");
}

// The fragment program is made from bytecode, the vertex program by glslang.
TEST_F(ValidateFxc, AStageFromBytecodeIsComparedWithTheStageBeforeIt) {
  PENUMBRA_NEEDS_FXC();
  const auto errors_of = [&](const std::string& written) {
    const std::string file = write("Linked.shader",
                                   "Shader \"L\" { SubShader { Pass { HLSLPROGRAM\n#pragma vertex V\n#pragma "
                                   "fragment F\nfloat4 V(float4 p : POSITION, out float2 uv : " +
                                       written +
                                       ") : SV_Position { uv = p.xy; return p; }\n"
                                       "float4 F(float4 p : SV_Position, float2 uv : TEXCOORD1) : SV_Target\n"
                                       "{ float1 v; v.x = uv.x; return v.x; }\nENDHLSL } } }\n")
                                 .string();
    return run_with_fxc({"validate", file, "--no-cache", "--no-lint"}).output;
  };
  EXPECT_THAT(errors_of("TEXCOORD1"), Not(HasSubstr("error:")));
  EXPECT_THAT(
      errors_of("TEXCOORD0"),
      HasSubstr("the fragment program reads 'TEXCOORD1', which the vertex program 'V' does not write"));
}

// On mobile devices half has minimum precision, for which the bytecode has other chunks of signatures.
TEST_F(ValidateFxc, BytecodeWithMinimumPrecisionIsTranslated) {
  PENUMBRA_NEEDS_FXC();
  const std::string file = write("Half.hlsl",
                                 "min16float4 k;\nmin16float4 Main(float1 fog : TEXCOORD1) : COLOR\n{\n    "
                                 "min16float4 c = 1; fog.x = fog.x * 2;\n"
                                 "    c.rgb = lerp(k.rgb, c.rgb, saturate(fog.x));\n    return c;\n}\n")
                               .string();
  const auto result = run_with_fxc(
      {"validate", file, "--target", "spirv,d3d11", "--no-cache", "--no-lint", "--format", "json"});
  EXPECT_EQ(result.exit_code, 0) << result.output;
  const nlohmann::json report = nlohmann::json::parse(result.output);
  for (const nlohmann::json& record : results_of(report)) EXPECT_EQ(record["status"], "passed") << record;
}

// Unity gives such a text to DXC, so FXC's verdict says nothing about it.
TEST_F(ValidateFxc, FxcIsNotAskedAfterUseDxc) {
  PENUMBRA_NEEDS_FXC();
  const nlohmann::json report = report_of(
      "#pragma use_dxc\n[numthreads(8, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)\n"
      "{\n    float1 v; v.x = r[id.x]; o[id.x] = v.x;\n}\n");
  for (const nlohmann::json& record : results_of(report))
    if (record["target"] == "spirv") {
      EXPECT_EQ(record["status"], "failed") << record;
    }
}

// No lint rule repeats these messages of FXC.
TEST_F(ValidateFxc, WhatFxcSaysOfValuesLoopsAndPowersIsInTheReport) {
  PENUMBRA_NEEDS_FXC();
  const std::string file =
      write("Fxc.hlsl",
            "#pragma multi_compile READ RETURN RESULT PARAMETER EARLY UNROLL VARYING INDEX POW\n"
            "Texture2D m; SamplerState sampler_m; float4 p; int n;\n"
            "#if defined(RETURN)\nfloat F(float2 uv) { if (uv.x > 0.5) return 1; }\n"
            "#elif defined(EARLY)\nfloat F(float2 uv) { [branch] if (uv.x > p.x) return 1; return uv.y; "
            "}\n#endif\n"
            "#if defined(PARAMETER)\nvoid Set(out float2 a) { a.x = 1; }\n#endif\n"
            "float4 Main(float2 uv : TEXCOORD0) : SV_Target {\nfloat4 c = 0; float2 a; int i;\n"
            "#if defined(READ)\n[branch] if (uv.x > p.x) a.x = 1; c = a.x;\n"
            "#elif defined(RETURN) || defined(EARLY)\nc = F(uv);\n"
            "#elif defined(RESULT)\nfloat4 d; d.x = 1; return d;\n"
            "#elif defined(PARAMETER)\nSet(a); c = a.x;\n"
            "#elif defined(UNROLL)\n[unroll] for (i = 0; i < n; ++i) c += p * i;\n"
            "#elif defined(VARYING)\nfor (i = 0; i < 8; ++i) { if (i > uv.x * 8) break; "
            "c += m.Sample(sampler_m, uv * i); }\n"
            "#elif defined(INDEX)\n[loop] for (i = 0; i < 4; ++i) c[i] = m.Load(int3(i, 0, 0)).x;\n"
            "#elif defined(POW)\nc = pow(uv.x, p.y);\n#endif\nreturn c; }\n")
          .string();
  const auto result = run_with_fxc({"validate", file, "--target", "spirv,d3d11", "--no-cache"});
  EXPECT_EQ(result.exit_code, 1) << result.errors;
  for (const char* said :
       {"4:7: error: X3507: 'F': Not all control paths return a value",
        "6:55: warning: X4000: use of potentially uninitialized variable (F)",
        "9:21: error: X3508: 'Set': output parameter 'a' not completely initialized",
        "11:8: warning: X3578: Output value 'Main' is not completely initialized",
        "14:33: warning: X4000: use of potentially uninitialized variable (a)",
        "22:10: error: X3511: unable to unroll loop",
        "24:57: warning: X3570: gradient instruction used in a loop with varying iteration",
        "26:8: error: X3531: can't unroll loops", "28:5: warning: X3571: pow(f, e)"})
    EXPECT_THAT(result.output, HasSubstr(std::string("Fxc.hlsl:") + said));
  EXPECT_THAT(result.output, HasSubstr("failed: 4 errors, 6 warnings\n")) << "and X3550";
}

// A mistake that glslang takes, in a kernel with the buffers `o` and `r`.
struct Mistake {
  const char* name;
  const char* body;  // of Main(), on line 5
  const char* code;  // FXC's
};
void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.name;
}

class MistakesThatFxcRefuses : public ValidateFxc, public testing::WithParamInterface<Mistake> {};

TEST_P(MistakesThatFxcRefuses, AreErrorsAtTheirLine) {
  PENUMBRA_NEEDS_FXC();
  const nlohmann::json report = report_of(
      std::string(
          "groupshared float big[4];\n[numthreads(8, 1, 1)] void Main(uint3 id : SV_DispatchThreadID) {\n") +
      GetParam().body + "\n}\n");
  for (const nlohmann::json& record : results_of(report)) {
    if (record["target"] != "d3d11") continue;
    ASSERT_EQ(record["status"], "failed") << record;
    EXPECT_EQ(record["messages"][0]["line"], 5) << record;
    EXPECT_THAT(record["messages"][0]["message"].get<std::string>(), HasSubstr(GetParam().code)) << record;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of, MistakesThatFxcRefuses,
    testing::Values(Mistake{"numbers_of_a_constructor", "float4 v = float4(1, 2, r[0]); o[0] = v.x;",
                            "X3014"},
                    Mistake{"component_written_twice", "float2 v = 0; v.xx = r[0]; o[0] = v.x;", "X3025"},
                    Mistake{"division_by_zero", "uint z = 0; o[0] = id.x / z;", "X4010"},
                    Mistake{"bits_of_a_float", "float v = r[0] & 3; o[0] = v;", "X3082"},
                    Mistake{"larger_cast", "float4 v = (float4)float2(r[0], 1); o[0] = v.w;", "X3017"},
                    Mistake{"initialiser_too_long", "float2 v = { r[0], 1, 2 }; o[0] = v.x;", "X3017"},
                    Mistake{"local_interlocked", "uint v = 1; InterlockedAdd(v, 1); o[0] = v;", "X3549"},
                    Mistake{"discard_in_a_kernel", "clip(r[0]); o[id.x] = 1;", "X4532"}),
    [](const auto& given) { return given.param.name; });

// A target that no bytecode leads to is unchecked, not failed: Unity compiles the program.
// The first line of each file says where glslang sees its mistake. FXC sees some at other lines: what is
// missing it notices at the next token, or at the end of the file.
TEST_F(ValidateFxc, EachMistakeIsAnErrorAtFxcsLine) {
  PENUMBRA_NEEDS_FXC();
  const std::map<std::string, int> of_fxc{{"cbuffer_member_without_semicolon.hlsl", 5},
                                          {"cbuffer_without_closing_brace.hlsl", 10},
                                          {"cut_off_file.hlsl", 4},
                                          {"function_without_body.hlsl", 5},
                                          {"missing_brace.hlsl", 8},
                                          {"missing_semicolon.hlsl", 5},
                                          {"missing_semicolon_last_statement.hlsl", 5},
                                          {"mutual_recursion.hlsl", 3},
                                          {"negative_array_size.hlsl", 4},
                                          {"return_without_value.hlsl", 4},
                                          {"shader_missing_semicolon.shader", 15},
                                          {"struct_without_semicolon.hlsl", 6}};
  const fs::path folder = fs::path(PENUMBRA_SOURCE_DIR) / "tests" / "validation" / "broken";
  std::vector<std::string> arguments{"validate",
                                     "--no-cache",
                                     "--no-lint",
                                     "--target",
                                     "d3d11",
                                     "--package-root",
                                     "com.example.tools=" + (folder / "packages" / "tools").string(),
                                     "--format",
                                     "json"};
  std::map<std::string, std::pair<std::string, int>> expected;  // the file and line of each file's message
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    arguments.push_back(entry.path().string());
    std::ifstream text(entry.path());
    std::string comment;
    std::string place;
    std::string severity;
    text >> comment >> place >> severity;  // "// parts/file.hlsl:12:5: error: ..."
    if (severity != "error:") continue;
    const std::string name = entry.path().filename().string();
    const std::size_t colon = place.find(':');
    const auto other = of_fxc.find(name);
    expected[name] = {
        fs::path(place.substr(0, colon)).filename().string(),
        other == of_fxc.end() ? std::atoi(place.c_str() + std::min(colon + 1, place.size())) : other->second};
  }
  ASSERT_GT(expected.size(), 100U);
  const auto report = nlohmann::json::parse(run_with_fxc(arguments).output);
  const auto file_name = [](const std::string& file) { return fs::path(file).filename().string(); };
  std::map<std::string, std::set<std::pair<std::string, int>>> said;
  for (const auto& result : results_of(report))
    for (const auto& message : result.at("messages"))
      said[file_name(result.at("file"))].emplace(file_name(message.at("file")), message.value("line", 0));
  for (const auto& [file, place] : expected) EXPECT_THAT(said[file], testing::Contains(place)) << file;
}

TEST_F(ValidateFxc, WhatNeitherGlslangNorTheBytecodeBringsToATargetIsUnchecked) {
  PENUMBRA_NEEDS_FXC();
  const nlohmann::json report = report_of(
      "[numthreads(8, 1, 1)] void Main(uint3 id : SV_DispatchThreadID)\n"
      "{\n    float1 v; uint n, s; r.GetDimensions(n, s); v.x = n; o[id.x] = v.x;\n}\n");
  EXPECT_EQ(report["summary"]["failed"], 0);
  for (const nlohmann::json& record : results_of(report))
    EXPECT_EQ(record["status"], record["target"] == "d3d11" ? "passed" : "unchecked") << record;
}

TEST_F(ValidateFxc, WithoutFxcItIsSaidOrRefused) {
  const std::string file = four_variants();
  const auto asked = run({"validate", file, "--target", "d3d11"});
  EXPECT_EQ(asked.exit_code, 3);
  EXPECT_THAT(
      asked.errors,
      HasSubstr(
          "FXC, Unity's compiler for Direct3D, is not at hand: it is turned off, by --fxc or PENUMBRA_FXC"));
  const auto silent = run({"validate", file, "--no-cache"});
  EXPECT_THAT(silent.errors, HasSubstr("note: FXC, Unity's compiler, checked nothing"));
  EXPECT_THAT(silent.output, Not(HasSubstr("d3d11")));
  const auto wrong =
      run_with_fxc({"validate", file, "--fxc", "/nowhere/d3dcompiler_47.dll", "--target", "d3d11"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.errors, HasSubstr("'/nowhere/d3dcompiler_47.dll' does not exist"));
}

}  // namespace
}  // namespace penumbra
