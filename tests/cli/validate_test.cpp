// penumbra validate compiles, counts, refuses, parts and joins shader files.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/hostile_shaders.h"
#include "cli/program.h"
#include "validate_report.h"

namespace penumbra {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kShader = R"(Shader "Test/Two"
{
    SubShader
    {
        Pass
        {
            Name "Colour"
            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment Frag
            #pragma multi_compile _ WARM
            #pragma multi_compile_fragment _ BRIGHT
            #include "Library.hlsl"
            float4 Vert(float3 p : POSITION) : SV_Position { return float4(p, 1); }
            float4 Frag() : SV_Target { return Tint(0.5); }
            ENDHLSL
        }
    }
}
)";

// A fragment shader with a finding of lint, a warning.
constexpr const char* kEdge =
    "float4 Main(float2 uv : TEXCOORD0) : SV_Target\n{\n    if (uv.x > 0.5) uv.x += ddx(uv.y);\n    return "
    "uv.x;\n}\n";

constexpr const char* kLibrary = R"(float4 Tint(float x)
{
#if defined(WARM) && defined(BRIGHT)
    x *= FACTOR;
#endif
    return x;
}
)";

class Validate : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("Two.shader", kShader);
    set_factor("2.0");
  }
  void set_factor(const std::string& factor) {
    write("Library.hlsl", "#define FACTOR " + factor + "\n" + kLibrary);
  }

  Words command(const Words& more) const {
    const bool cached = std::find(more.begin(), more.end(), "--no-cache") == more.end();
    return joined({"validate", path("Two.shader").string()},
                  cached ? joined({"--cache", path("cache").string()}, more) : more);
  }
  nlohmann::json report(const Words& more) {
    run(joined(command(more), {"--format", "json", "-o", path("report.json").string()}));
    return nlohmann::json::parse(read("report.json"));
  }
  // Validates one file for SPIR-V, without a cache.
  static platform::ChildResult check(const std::filesystem::path& file, const Words& more = {}) {
    return run(joined({"validate", file.string(), "--no-cache", "--target", "spirv"}, more));
  }
};

TEST_F(Validate, CompilesEveryVariantOfEveryStageForEveryTarget) {
  const nlohmann::json json = report({"--target", "spirv,hlsl50"});
  // The vertex stage has _ and WARM, the fragment stage those with and without BRIGHT; each for two targets.
  EXPECT_EQ(json["summary"]["results"], (2 + 4) * 2);
  EXPECT_EQ(json["summary"]["variants"], 2 + 4);
  EXPECT_EQ(json["variants"].size(), 6U);
  EXPECT_EQ(json["summary"]["failed"], 0);
  std::set<std::string> passes;
  for (const nlohmann::json& record : results_of(json))
    if (record.contains("pass")) passes.insert(record["pass"]);
  EXPECT_EQ(passes, std::set<std::string>{"Colour"});
}

TEST_F(Validate, AMistakeOfOneVariantIsSaidOnceAtItsLine) {
  set_factor("undefined_factor");
  const auto result = run(command({"--target", "spirv,essl310,msl23"}));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output, HasSubstrs("Library.hlsl:5:", "undefined_factor", "BRIGHT", "WARM"));
  const std::size_t first = result.output.find("Library.hlsl:5:");
  EXPECT_EQ(result.output.find("Library.hlsl:5:", first + 1), std::string::npos) << result.output;
}

TEST_F(Validate, CountSaysWhatItCouldNotRead) {
  write("Broken.shader",
        "Shader \"B\" {\n  CustomEditor Foo\n  SubShader { Pass { HLSLPROGRAM ENDHLSL } }\n}\n");
  const auto result = run({"validate", path("Broken.shader").string(), "--count"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("Broken.shader:2:"));
}

TEST_F(Validate, CountsShowNamesWithoutTheirControls) {
  const std::string kernel = "#pragma kernel Main\n[numthreads(1, 1, 1)] void Main() {}\n";
  for (const char* name : {"::set-output name=a", "##[error]a", "a\u202e", "a\u2028", "a\xff"})
    write("named/" + std::string(name) + ".compute", kernel);
  std::vector<std::string> count{"validate", path("named").string(), "--target", "spirv", "--count"};
  const auto text = run(count);
  EXPECT_EQ(text.exit_code, 0) << text.errors;
  EXPECT_THAT(text.output, HasSubstr("\\x3A:set-output name=a"));
  for (const char* raw : {" ::", "##[", "\u202e", "\u2028", "\xff"})
    EXPECT_THAT(text.output, Not(HasSubstr(raw)));
  count.insert(count.end(), {"--format", "json"});
  const auto json = run(count);
  EXPECT_EQ(json.exit_code, 0) << json.errors;
  EXPECT_EQ(nlohmann::json::parse(json.output)["results"], 5);
}

TEST_F(Validate, KeywordsNarrowAndAreCounted) {
  EXPECT_THAT(run(command({"--target", "spirv", "--count"})).output, HasSubstr("vertex 2   fragment 4"));
  EXPECT_THAT(run(command({"--target", "spirv", "--count", "--keywords=-WARM"})).output,
              HasSubstr("vertex 1   fragment 2"));
  expect_bad_input(command({"--target", "spirv", "--limit", "5"}),
                   HasSubstrs("--limit", "--keywords", "WARM", "--sample 3"));
  EXPECT_EQ(report({"--target", "spirv", "--sample", "1"})["summary"]["variants"], 2);
  EXPECT_THAT(run(command({"--target", "spirv", "--sample", "1"})).errors,
              HasSubstr("6 results of 1 program in 1 file for 1 target; --sample takes at most 1 variant of "
                        "each entry point"));
}

TEST_F(Validate, AKeywordThatNoProgramDeclaresIsRefusedWithTheNearest) {
  for (const char* option : {"--keywords=+WRAM", "--keywords=-BRIGHT WRAM|BRIGHT"}) {
    expect_bad_input(command({"--target", "spirv", "--count", option}),
                     HasSubstrs("--keywords", "no program declares 'WRAM'", "did you mean 'WARM'?"));
  }
}

TEST_F(Validate, AShaderIsNotReplacedByItsReport) {
  const auto shader = write("Main.hlsl", "float4 Main() : SV_Target { return 1; }\n");
  expect_bad_input({"validate", shader.string(), "--format", "json", "-o", shader.string()},
                   HasSubstr("is a source file, which the report would replace"));
  EXPECT_THAT(read("Main.hlsl"), HasSubstr("SV_Target"));
}

TEST_F(Validate, WhatIsGeneratedOfEachVariantIsWritten) {
  const std::string folder = path("out/generated").string();
  const auto result = run(command({"--target", "spirv,essl310,msl23,hlsl50", "--emit-sources", folder}));
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  std::map<std::string, int> endings;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    EXPECT_THAT(name, testing::StartsWith("Two-Colour-"));
    ++endings[name.substr(name.find('.', name.size() - 14))];
    if (name.find("Frag.fragment.WARM-BRIGHT.") == std::string::npos) continue;
    const std::string text = read("out/generated/" + name);
    const std::string begin = text.substr(0, text.find('\n'));
    if (name.ends_with(".essl310.glsl")) {
      EXPECT_EQ(begin, "#version 310 es");
    } else if (name.ends_with(".msl23.metal")) {
      EXPECT_EQ(begin, "#include <metal_stdlib>");
    } else if (name.ends_with(".spirv.spv")) {
      EXPECT_EQ(text.substr(0, 4), "\x03\x02\x23\x07");
    }
  }
  EXPECT_EQ(endings, (std::map<std::string, int>{
                         {".essl310.glsl", 6}, {".hlsl50.hlsl", 6}, {".msl23.metal", 6}, {".spirv.spv", 6}}));
  // Again, although all results are kept.
  std::filesystem::remove_all(folder);
  run(command({"--target", "spirv", "--emit-sources", folder}));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 6);
  expect_bad_input(command({"--emit-sources", path("Two.shader").string()}),
                   HasSubstr("is a file, not a folder"));
}

TEST_F(Validate, NamesInAShaderLeadOutOfNoFolder) {
  std::string shader = kShader;
  shader.replace(shader.find("Colour"), 6, "../../../\\..\\a:b");
  write("..;-.shader", shader);
  run({"validate", path("..;-.shader").string(), "--no-cache", "--target", "spirv", "--emit-sources",
       path("deep/er/out").string()});
  EXPECT_EQ(std::distance(std::filesystem::recursive_directory_iterator(path("deep/er")), {}), 1 + 6);
}

TEST_F(Validate, AProjectWithoutShadersIsRefused) {
  std::filesystem::create_directories(path("Empty/Assets"));
  expect_bad_input({"validate", "--project", path("Empty").string()},
                   HasSubstr("has no shader file to validate"));
}

TEST_F(Validate, AFileInAProjectsAssetsHasTheProjectsPackages) {
  write("Game/Packages/com.me.tint/package.json", R"({"name": "com.me.tint", "version": "1.0.0"})");
  write("Game/Packages/com.me.tint/Tint.hlsl", "float4 Tint() { return UNITY_VERSION; }\n");
  std::filesystem::create_directories(path("Game/ProjectSettings"));
  const std::string text =
      "#include \"Packages/com.me.tint/Tint.hlsl\"\nfloat4 Main() : SV_Target { return Tint(); }\n";
  const auto deep = write("Game/Assets/Deep/Main.hlsl", text);
  const auto inside = check(deep);
  EXPECT_EQ(inside.exit_code, 0) << inside.output;
  EXPECT_THAT(inside.errors, HasSubstrs("the Unity project " + path("Game").string(), "--no-project"));
  EXPECT_EQ(check(deep, {"--no-project"}).exit_code, 1) << "there is no such package";
  EXPECT_EQ(check(deep, {write("Other.hlsl", text).string()}).exit_code, 1)
      << "not all files are in the project";
  const auto beside = check(write("Game/Main.hlsl", text));
  EXPECT_THAT(beside.errors, Not(HasSubstr("the Unity project"))) << "Unity does not import it";
}

TEST_F(Validate, APatternThatMatchesNothingIsRefused) {
  expect_bad_input({"validate", path("").string(), "--count", "--only", "zzz/**"},
                   HasSubstr("--only 'zzz/**' matches no shader file"));
}

TEST_F(Validate, WhatAKeywordAddsIsCounted) {
  const auto text = run(command({"--target", "spirv", "--count", "--what-if=-WARM"}));
  EXPECT_THAT(text.output, HasSubstrs("vertex 2 (1)   fragment 4 (2)", "in all 6 results (3 with -WARM)"));
  const auto list = run(command({"--api", "d3d11", "--count", "--what-if=-WARM", "--format", "json"}));
  const auto json = nlohmann::json::parse(list.output);
  EXPECT_EQ(json["programs"][0]["api"], "d3d11");
  EXPECT_EQ(json["programs"][0]["stages"][1],
            (nlohmann::json{{"stage", "fragment"}, {"variants", 4}, {"what_if", 2}}));
  EXPECT_EQ(json["results"], 6 * 5) << "for each of the targets";
  EXPECT_EQ(json["what_if"], 3 * 5);
  EXPECT_EQ(json["condition"], "-WARM");
  const auto plain =
      nlohmann::json::parse(run(command({"--api", "d3d11", "--count", "--format", "json"})).output);
  EXPECT_FALSE(plain.contains("what_if"));
  EXPECT_FALSE(plain["programs"][0]["stages"][1].contains("what_if"));
}

TEST_F(Validate, WhatCannotBeListedIsSaid) {
  EXPECT_THAT(run(command({"--count", "--what-if=-WRAM"})).errors, HasSubstrs("WRAM", "WARM"));
  EXPECT_EQ(run(command({"--what-if=-WARM"})).exit_code, 2);
  expect_bad_input(command({"--count", "--format", "sarif"}), HasSubstr("text or json"));
  expect_bad_input({"validate", "--count"}, HasSubstr("shader files"));
}

TEST_F(Validate, APipelineAssetNarrowsKeywordsAndPasses) {
  write(
      "Lit.shader",
      "Shader \"Lit\" { SubShader {\n"
      "Pass { Name \"Forward\"\nHLSLPROGRAM\n#pragma vertex V\n#pragma multi_compile _ _SHADOWS_SOFT _OTHER\n"
      "#pragma multi_compile _ _MAIN_LIGHT_SHADOWS\n"
      "float4 V() : SV_Position { return 0; }\nENDHLSL\n}\n"
      "Pass { Tags { \"LightMode\" = \"UniversalGBuffer\" }\nHLSLPROGRAM\n#pragma vertex V\n"
      "float4 V() : SV_Position { return 0; }\nENDHLSL\n} } }\n");
  const std::string asset = write("Urp.asset", "MonoBehaviour:\n  m_SoftShadowsSupported: 0\n").string();
  const std::string renderer = write("Renderer.asset", "MonoBehaviour:\n  m_RenderingMode: 0\n").string();
  const std::vector<std::string> lit{"validate", path("Lit.shader").string(), "--count", "--target", "spirv"};
  const auto listed = [&](const Words& more) { return run(joined(lit, more)).output; };
  EXPECT_THAT(listed({}), HasSubstrs("Forward   vertex 6", "0.1"));
  EXPECT_THAT(listed({"--urp-asset", asset}), HasSubstrs("Forward   vertex 4", "0.1"));
  EXPECT_THAT(listed({"--urp-asset", asset, "--urp-asset", renderer}),
              AllOf(HasSubstr("Forward   vertex 4"), Not(HasSubstr("0.1"))));
}

TEST_F(Validate, WarningsFailWhereTheyAreToldTo) {
  const auto file = write("Edge.hlsl", kEdge);
  const std::string report = path("edge.json").string();
  EXPECT_EQ(check(file, {"--format", "json", "-o", report}).exit_code, 0);
  EXPECT_EQ(check(file, {"--werror"}).exit_code, 1);
  EXPECT_EQ(run({"merge", report, "--werror"}).exit_code, 1);
  const auto known = check(file, {"--werror", "--baseline", report});
  EXPECT_EQ(known.exit_code, 0) << known.output;
  EXPECT_THAT(known.errors, HasSubstr("1 finding compared, 0 findings not in the baseline, 0 only there"));
}

TEST_F(Validate, OnlyWhatABaselineLacksFails) {
  set_factor("undefined_factor");
  const std::string baseline = path("report.json").string();
  report({"--target", "spirv"});
  std::rename(baseline.c_str(), path("baseline.json").c_str());
  const std::vector<std::string> again{"--target", "spirv", "--baseline", path("baseline.json").string()};
  write("Library.hlsl", "\n\n" + read("Library.hlsl"));
  const auto known = run(command(again));
  EXPECT_EQ(known.exit_code, 0) << known.output;
  EXPECT_THAT(known.output, testing::StartsWith("passed: 1 finding of the baseline\n"));
  set_factor("another_factor");
  const auto other = run(command(again));
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.errors, HasSubstrs("not in the baseline: ", "another_factor", "only in the baseline: ",
                                       "undefined_factor", "1 finding not in the baseline, 1 only there"));
  expect_bad_input(command({"--baseline", path("Two.shader").string()}), HasSubstr("Two.shader:1:1"));
}

TEST_F(Validate, MessagesInPackagesAreNotesUnlessAskedFor) {
  write("Game/Packages/com.me.tint/package.json", R"({"name": "com.me.tint", "version": "1.0.0"})");
  write("Game/Packages/com.me.tint/Tint.hlsl",
        "groupshared float _Sum = 0;\nfloat4 Tint() { return _Sum; }\n");
  write("Game/Packages/com.me.tint/Broken.compute",
        "#pragma kernel K\n[numthreads(1, 1, 1)] void K() { no; }\n");
  write("Game/Assets/K.compute",
        "#pragma kernel K\n#include \"Packages/com.me.tint/Tint.hlsl\"\nRWBuffer<float4> Out;\n"
        "[numthreads(1, 1, 1)] void K() { Out[0] = Tint(); }\n");
  const auto with = [&](const Words& more) {
    return run(joined(words("validate --no-cache --target spirv --werror --project", {path("Game").string()}),
                      more));
  };
  EXPECT_EQ(with({}).exit_code, 0) << with({}).output;
  EXPECT_THAT(with({}).output, HasSubstrs("passed\n", "2 notes, of which 2 in packages", "1 failed"));
  EXPECT_EQ(with({"--packages"}).exit_code, 1);
  EXPECT_THAT(with({"--packages"}).output, testing::StartsWith("failed: 1 error, 1 warning\n"));
  EXPECT_EQ(with({path("Game/Packages/com.me.tint").string()}).exit_code, 1) << "the package is named";
}

TEST_F(Validate, ASecondRunIsFromTheCacheUntilAnIncludeChanges) {
  EXPECT_EQ(report({"--target", "spirv"})["summary"]["cached"], 0);
  EXPECT_EQ(report({"--target", "spirv"})["summary"]["cached"], 6);
  set_factor("3.0");
  // Only the fragment variant with both keywords reads it: the text of all others is what it was.
  EXPECT_EQ(report({"--target", "spirv"})["summary"]["cached"], 5);
}

TEST_F(Validate, ShardsJoinToTheWhole) {
  const nlohmann::json whole = report({"--target", "spirv", "--no-cache"});
  std::vector<std::string> join{"merge"};
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const std::string file = path(std::string("shard") + shard[0] + ".json").string();
    run(command({"--target", "spirv", "--no-cache", "--shard", shard, "--format", "json", "-o", file}));
    join.push_back(file);
  }
  join.insert(join.end(), {"--format", "json", "-o", path("joined.json").string()});
  EXPECT_EQ(run(join).exit_code, 0);
  const nlohmann::json joined = nlohmann::json::parse(read("joined.json"));
  EXPECT_EQ(joined["variants"], whole["variants"]);
  EXPECT_EQ(joined["summary"]["unique"], whole["summary"]["unique"]);
  EXPECT_EQ(run(command({"--shard", "4/3"})).exit_code, 2);
}

TEST_F(Validate, WhatOnlyTheEditorHasIsUncheckedAndNoFailure) {
  write("Library.hlsl", "#include \"UnityCG.cginc\"\n");
  const auto result = run(command({"--target", "spirv"}));
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstrs("UnityCG.cginc", "--cginc-root"));
  std::filesystem::create_directories(path("cginc"));
  write("cginc/UnityCG.cginc", "#define FACTOR 1\nfloat4 Tint(float x) { return x * FACTOR; }\n");
  EXPECT_EQ(report({"--target", "spirv", "--cginc-root", path("cginc").string()})["summary"]["failed"], 0);
}

TEST_F(Validate, ABrokenShaderLabFileFailsAtItsPlace) {
  write("Two.shader", "Shader \"Test/Broken\"\n{\n    SubShader\n    {\n        Pass {\n    }\n}\n");
  const auto result = run(command({"--target", "spirv"}));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output, HasSubstr("Two.shader:"));
}

// glslang 12 ends its process on it.
TEST_F(Validate, AShaderThatCrashesTheCompilerFailsAlone) {
  const auto result = run(command({write("crashes.hlsl", comma_chain("float4 Main() : SV_Target")).string(),
                                   "--target", "spirv", "--keep", path("kept").string()}));
  EXPECT_EQ(result.exit_code, 70);
  EXPECT_THAT(result.errors,
              HasSubstrs("penumbra: internal error: " + path("crashes.hlsl").string() +
                             ": the compiler crashed with SIGSEGV: fragment entry Main, with no keyword, for "
                             "spirv; its text is in " +
                             path("kept").string(),
                         "please report it"));
  EXPECT_THAT(result.output, HasSubstrs("crashes.hlsl: error: the compiler crashed with SIGSEGV",
                                        "to reproduce: " + path("kept").string(),
                                        "7 variants for 1 target: 7 results", "1 failed"));
}

TEST_F(Validate, WhatIsNoMacrosNameIsRefused) {
  for (const char* define : {"3X", "3X=1", "A B=1", "=1"}) {
    expect_bad_input({"validate", write("a.hlsl", kShader).string(), "-D", define},
                     HasSubstr("is not a macro's name"));
  }
}

TEST_F(Validate, NoVariantsLessThanNoneAreAskedFor) {
  for (const char* option : {"--limit", "--sample"}) {
    expect_bad_input({"validate", write("a.hlsl", kShader).string(), option, "-1"}, HasSubstr(option));
  }
}

// The text that crashed goes where no other user of the machine can read it, or put something first.
TEST_F(Validate, WithoutACacheWhatCrashedIsKeptInANewFolderOfTheUsersAlone) {
  const std::filesystem::path temporary = path("temporary");
  std::filesystem::create_directory(temporary);
  const std::string file = write("crashes.hlsl", comma_chain("float4 Main() : SV_Target")).string();
  for (int i = 0; i < 2; ++i)
    shell("TMPDIR='" + temporary.string() + "' " PENUMBRA_PROGRAM " validate --no-cache --target spirv " +
          file);
  std::set<std::filesystem::path> folders;
  for (const auto& entry : std::filesystem::directory_iterator(temporary))
    if (entry.path().filename().string().starts_with("penumbra-failures-")) folders.insert(entry.path());
  ASSERT_EQ(folders.size(), 2U);
  EXPECT_FALSE(std::filesystem::is_empty(*folders.begin()));
  EXPECT_EQ(std::filesystem::status(*folders.begin()).permissions(), std::filesystem::perms::owner_all);
}

TEST_F(Validate, AProgramThatIsNotCompiledIsNotPassedOverInSilence) {
  const auto shader = [&](const std::string& pragmas) {
    return check(write("Odd.shader", "Shader \"Odd\" { SubShader { Pass {\n  HLSLPROGRAM\n" + pragmas +
                                         "float4 F() : SV_Target { return 1; }\nENDHLSL\n} } }\n"));
  };
  const auto without = shader("");
  EXPECT_EQ(without.exit_code, 1);
  EXPECT_THAT(without.output, HasSubstr("Odd.shader:2:3: error: this program names no entry point"));
  const auto elsewhere = shader("#pragma fragment F\n#pragma only_renderers metal\n");
  EXPECT_EQ(elsewhere.exit_code, 0);
  EXPECT_THAT(elsewhere.output,
              HasSubstr("unchecked: 1 program: only_renderers or exclude_renderers leave out"));
}

TEST_F(Validate, EachTargetSeesTheMacrosOfItsApi) {
  write("Library.hlsl",
        "#if defined(SHADER_API_D3D11)\n#error only d3d11\n#endif\nfloat4 Tint(float x) { return x; }\n");
  const nlohmann::json json = report({"--target", "spirv,hlsl50"});
  for (const nlohmann::json& record : results_of(json))
    EXPECT_EQ(record["status"] == "failed", record["target"] == "hlsl50") << record.dump();
  EXPECT_EQ(report({"--target", "spirv,hlsl50", "--api", "vulkan"})["summary"]["failed"], 0);
}

TEST_F(Validate, ExplainShowsAVariantWithTheOriginOfEveryLine) {
  const auto shown = run(command({"--explain", "Colour/Frag: WARM BRIGHT"}));
  EXPECT_EQ(shown.exit_code, 0);
  EXPECT_THAT(shown.output, HasSubstrs("Library.hlsl\n/* 2 */ float4 Tint(float x)", "/* 5 */ x *= 2.0;",
                                       "/* 15 */ float4 Frag()"));
  EXPECT_THAT(run(command({"--explain", "Frag: WARM"})).output, Not(HasSubstr("x *=")));
  // The whole shader is shown.
  const std::string file = path("Shown.hlsl").string();
  EXPECT_EQ(run(command({"--explain", "Frag: WARM BRIGHT", "-o", file})).exit_code, 0);
  EXPECT_EQ(run({"validate", file, "--entry", "Frag", "--no-cache"}).exit_code, 0);
}

TEST_F(Validate, ExplainAsksForOneVariantThatThereIs) {
  const auto refused = [&](const std::string& variant) {
    return run(command({"--explain", variant})).errors;
  };
  EXPECT_THAT(refused("Fragg"), HasSubstrs("--explain: unknown entry point 'Fragg'", "Frag"));
  EXPECT_THAT(refused(""), HasSubstrs("names 2 entry points", "Two.shader: Colour/Vert"));
  EXPECT_THAT(refused("Vert: WORM"), HasSubstrs("declares no keyword 'WORM'", "WARM"));
  EXPECT_THAT(run({"validate", "--explain", "Frag"}).errors, HasSubstr("--explain: needs a shader file"));
  const std::string broken = write("broken.shader", "Shader \"A\" {").string();
  EXPECT_THAT(run({"validate", broken, "--explain", "Frag"}).errors,
              AllOf(HasSubstr("--explain: there is no entry point 'Frag', nor any other"),
                    Not(HasSubstr("known are:"))));
  write("Library.hlsl", "#include \"Missing.hlsl\"\n");
  const auto failed = run(command({"--explain", "Frag"}));
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_THAT(failed.errors, HasSubstr("Library.hlsl:1:"));
}

TEST_F(Validate, MinimizeNamesTheKeywordsThatAnErrorNeeds) {
  std::string shader = kShader;
  shader.replace(shader.find("#pragma multi_compile _ WARM"), 0,
                 "#pragma multi_compile A B\n#pragma multi_compile C D\n#pragma multi_compile _ E\n");
  write("Two.shader", shader);
  set_factor("undefined_factor");
  const auto minimal = report({"--target", "spirv", "--minimize"})["minimal_keywords"];
  ASSERT_EQ(minimal.size(), 1U);
  EXPECT_EQ(minimal[0]["keywords"], (std::vector<std::string>{"WARM", "BRIGHT"}));
  EXPECT_EQ(minimal[0]["error"]["line"], 5);
  EXPECT_THAT(run(command({"--target", "spirv", "--minimize"})).output,
              HasSubstr("  enough for it: WARM BRIGHT\n"));
  // There are two ways to one error: one of them is enough.
  std::string either = kLibrary;
  either.replace(either.find("defined(WARM) && defined(BRIGHT)"), 32, "defined(A) || defined(B)       ");
  write("Library.hlsl", "#define FACTOR undefined_factor\n" + either);
  const auto one = report({"--target", "spirv", "--minimize"})["minimal_keywords"];
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0]["keywords"].size(), 1U);
  // There is no keyword at all.
  write("Library.hlsl", "float4 Tint(float x) { return undefined; }\n");
  EXPECT_THAT(run(command({"--target", "spirv", "--minimize"})).output,
              HasSubstr("  without any keyword as well\n"));
}

TEST_F(Validate, LintSpeaksUnlessItIsToldNotTo) {
  const auto file = write("Edge.hlsl", kEdge);
  const auto with = [&](const Words& more) { return check(file, more); };
  EXPECT_EQ(with({}).exit_code, 0) << "a warning";
  EXPECT_THAT(with({}).output,
              HasSubstr("Edge.hlsl:3:29: warning: a derivative is taken where only some pixels"));
  EXPECT_THAT(with({"--no-lint"}).output, Not(HasSubstr("derivative")));
  EXPECT_THAT(with({"--disable-rule", "typed-load,divergent-derivative"}).output,
              Not(HasSubstr("derivative")));
  const auto unknown = with({"--disable-rule", "divergent-derivate"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.errors, HasSubstrs("unknown rule 'divergent-derivate'", "divergent-derivative"));
}

TEST_F(Validate, RulesOfUnityAreForUnitysProjects) {
  const std::string text =
      "#pragma multi_compile _ OLD\n#if UNITY_VERSION >= 600010\n#endif\nTexture2D _Map;\nSamplerState "
      "odd;\nfloat4 Main(float2 uv : TEXCOORD0) : "
      "SV_Target\n{\n    return _Map.Sample(odd, uv);\n}\n";
  const auto outside = check(write("Plain.hlsl", text));
  EXPECT_EQ(outside.exit_code, 0) << outside.output;
  EXPECT_THAT(outside.output, testing::StartsWith("passed\nspirv"));
  std::filesystem::create_directories(path("Game/ProjectSettings"));
  const auto inside = check(write("Game/Assets/Unitys.hlsl", text));
  EXPECT_EQ(inside.exit_code, 1);
  EXPECT_THAT(inside.output, HasSubstrs("[unity-version]", "[unused-keyword]", "[sampler-name]"));
}

TEST_F(Validate, APassLacksNoStageAndItsEntryPointsAreThere) {
  const std::string begin =
      "Shader \"S\" { SubShader { Pass { Name \"P\"\nHLSLPROGRAM\n#pragma vertex Vert\n";
  const std::string end =
      "float4 Vert(float4 p : POSITION) : SV_Position { return p; }\nfloat4 Frag() : SV_Target { return 1; "
      "}\n"
      "ENDHLSL } } }\n";
  const auto lacking = run({"validate", write("Lacking.shader", begin + end).string(), "--no-cache"});
  EXPECT_EQ(lacking.exit_code, 1);
  EXPECT_THAT(lacking.output,
              HasSubstr("Lacking.shader:2:1: error: this program has no fragment stage, and Unity "
                        "leaves such a pass out: add #pragma fragment NAME"));
  const auto elsewhere =
      run({"validate", write("Metal.shader", begin + "#pragma only_renderers metal\n" + end).string(),
           "--no-cache"});
  EXPECT_THAT(elsewhere.output, HasSubstr("Metal.shader:2:1: error: this program has no fragment stage"));
  const auto misspelt =
      run({"validate", write("Misspelt.shader", begin + "#pragma fragment Fragg\n" + end).string(),
           "--no-cache"});
  EXPECT_EQ(misspelt.exit_code, 1);
  EXPECT_THAT(misspelt.output,
              HasSubstr("Misspelt.shader:4:1: error: the entry point 'Fragg' is not defined\n"
                        "    #pragma fragment Fragg\n"));
}

TEST_F(Validate, AnErrorOfRenderStateDoesNotHideThoseOfPrograms) {
  std::string shader = kShader;
  shader.replace(shader.find("HLSLPROGRAM"), 0, "Cull Bak\n");
  write("Two.shader", shader);
  set_factor("undefined_factor");
  const auto result = run(command({"--target", "spirv"}));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output,
              HasSubstrs("error: 'Bak' is not a value of Cull: did you mean 'Back'?", "undefined_factor"));
}

// Unity puts three includes before such a block; its lines stay those of the file.
TEST_F(Validate, ACgProgramHasUnitysIncludesAndItsOwnLines) {
  for (const char* file : {"HLSLSupport", "UnityShaderVariables", "UnityShaderUtilities"})
    write(std::string("cginc/") + file + ".cginc",
          std::string("float4 Of") + file +
              "() { return 1; }\n#if !defined(UNITY_PASS_SHADOWCASTER)\n#error\n#endif\n");
  const std::string file =
      write("Cg.shader",
            "Shader \"Cg\"\n{\n    SubShader\n    {\n        Pass\n        {\n            Tags { "
            "\"LightMode\" = "
            "\"ShadowCaster\" }\n            CGPROGRAM\n#pragma vertex Vert\n#pragma fragment Frag\n"
            "float4 Vert(float4 p : POSITION) : SV_POSITION { return p + OfHLSLSupport(); }\n"
            "float4 Frag() : SV_Target { return OfUnityShaderVariables() + OfUnityShaderUtilities(); }\n"
            "#if defined(WRONG)\nfloat4 f = nothing;\n#endif\n            ENDCG\n        }\n    }\n}\n")
          .string();
  const Words validate{"validate", file, "--no-cache", "--no-lint", "--cginc-root", path("cginc").string()};
  EXPECT_EQ(run(validate).exit_code, 0) << run(validate).output;
  EXPECT_THAT(run(joined(validate, {"-D", "WRONG"})).output,
              HasSubstr("Cg.shader:14:12: error: unknown variable 'nothing'"));
}

TEST_F(Validate, OptionsWithoutEffectAreRefused) {
  const std::vector<std::vector<std::string>> lists{
      {"validate", "--only", "Assets/**"},
      {"validate", "--keywords", "+A"},
      command({"--count", "--minimize"}),
      command({"--explain", "Frag", "--minimize"}),
      command({"--format", "json", "--verbose"}),
      command({"--root", path("").string()}),
      command({"--no-lint", "--disable-rule", "typed-load"}),
      command({"--no-cache", "--cache", path("cache").string()})};
  for (const std::vector<std::string>& list : lists) {
    expect_bad_input(list, HasSubstr(" has no effect with"));
  }
  const auto warned = run(command({"--target", "spirv", "--entry", "Frag"}));
  EXPECT_EQ(warned.exit_code, 0);
  EXPECT_THAT(warned.errors, HasSubstr("warning: --entry has no effect: no .hlsl file is given"));
}

TEST_F(Validate, AKeywordThatNobodyDeclaresIsRefusedBesideOtherErrorsToo) {
  EXPECT_THAT(run(command({"--count", "--keywords", "+BRIHGT"})).errors,
              HasSubstr("--keywords +BRIHGT: no program declares 'BRIHGT'; did you mean 'BRIGHT'?"));
  std::string shader = kShader;
  shader.replace(shader.find("HLSLPROGRAM"), 0, "Cull Bak\n");
  write("Two.shader", shader);
  EXPECT_EQ(run(command({"--count", "--keywords", "+BRIHGT"})).exit_code, 2);
  write("Two.shader", shader.substr(0, shader.rfind('}')));
  const auto warned = run({"validate", path("Two.shader").string(), write("One.shader", kShader).string(),
                           "--count", "--keywords", "+BRIHGT"});
  EXPECT_EQ(warned.exit_code, 1);  // Two.shader could not be read
  EXPECT_THAT(warned.errors,
              HasSubstr("warning: --keywords +BRIHGT: no program declares 'BRIHGT'; did you mean "
                        "'BRIGHT'?; not every program was understood"));
}

TEST_F(Validate, UnknownTargetsAndFoldersSayTheRemedy) {
  EXPECT_THAT(run(command({"--target", "essl301"})).errors, HasSubstr("essl300"));
  EXPECT_EQ(run({"validate", path("nowhere").string()}).exit_code, 2);
  EXPECT_EQ(run(command({"--cginc-root", path("nowhere").string()})).exit_code, 3);
  EXPECT_EQ(run({"validate", "--project", path("").string()}).exit_code, 2);
}

}  // namespace
}  // namespace penumbra
