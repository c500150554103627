#include "validation/validate_techniques.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "input/input_error.h"
#include "shaders/shader_files.h"
#include "validate_report.h"

namespace penumbra::validation {

using shaders::ShaderFiles;

namespace {

using testing::HasSubstr;

// The library, and the variants of its techniques that studies measure.
ValidationRequest library_request() {
  ValidationRequest request;
  request.techniques =
      techniques::read_technique_list(PENUMBRA_SOURCE_DIR "/tests/study/StudyVariants.technique.json");
  request.engine.jobs = 2;
  return request;
}

constexpr const char* fragment =
    "float4 Main(float2 u : TEXCOORD0) : SV_Target\n{\n    return u.xyxy KEYWORD;\n}\n";

ValidationRequest file_request(const ShaderFiles& files) {
  ValidationRequest request;
  request.files = {{files.path("f.hlsl"), "Main", hlsl::Stage::fragment, {{}}}};
  return request;
}

TEST(Validate, EveryTechniqueOfTheLibraryPassesEveryTarget) {
  ValidationRequest request = library_request();
  request.lint.wanted = true;
  const ValidationReport report = validate(request);
  for (const VariantRecord& record : report.records)
    EXPECT_TRUE(std::none_of(record.diagnostics.begin(), record.diagnostics.end(),
                             [](const hlsl::Diagnostic& said) { return !said.rule.empty(); }))
        << report_text(report);
  std::vector<techniques::Technique> all = request.techniques->techniques;
  std::size_t expected = 0;
  for (const techniques::Technique& technique : all) {
    // A kernel stands alone; other programs are a fragment and a vertex shader, or a fragment and a compute
    // shader; those of opaque casters have alpha test, too.
    std::size_t programs = 0;
    for (const techniques::GraphPass& pass : technique.graph.passes) {
      const bool opaque_casters =
          pass.kind == techniques::PassKind::casters && pass.casters == techniques::DrawnCasters::opaque;
      programs += pass.kind == techniques::PassKind::compute ? 1 : opaque_casters ? 4 : 2;
    }
    expected += technique.keyword_sets.size() * programs * request.targets.size();
  }
  EXPECT_EQ(report.records.size(), expected);
  EXPECT_EQ(report.count(VariantStatus::failed), 0U) << report_text(report);
  EXPECT_EQ(report.count(VariantStatus::unreached), 0U);
  EXPECT_GT(report.unique, 0U);
  EXPECT_LE(report.unique, expected);
}

TEST(Validate, AFunctionThatDoesNotExistIsReportedWithItsManifest) {
  ValidationRequest request = library_request();
  techniques::Technique technique = request.techniques->find("hard");
  for (techniques::GraphPass& pass : technique.graph.passes)
    if (pass.filter) pass.filter->function += "s";
  request.techniques->techniques = {technique};
  const ValidationReport report = validate(request);
  ASSERT_GT(report.count(VariantStatus::failed), 0U);
  EXPECT_THAT(report_text(report),
              testing::ContainsRegex(
                  "HardTest.technique.json:[0-9]+:[0-9]+ .fragment "
                  "entry.:[0-9]+:[0-9]+: error: no matching overloaded function found .FilterHards."));
}

TEST(Validate, EachVersionOfVulkanHasItsOwnAnswer) {
  const ShaderFiles files;
  files.write("f.hlsl", "float4 Main(float2 u : TEXCOORD0) : SV_Target { return WaveActiveSum(u.x); }\n");
  ValidationRequest request = file_request(files);
  request.targets = {"vulkan1.2", "spirv", "vulkan1.0", "msl23", "vulkan1.1"};
  const ValidationReport report = validate(request);
  std::map<std::string, VariantStatus> status;
  for (const VariantRecord& record : report.records) status[record.target] = record.status;
  EXPECT_EQ(status.size(), 5U);
  EXPECT_EQ(status["vulkan1.0"], VariantStatus::failed);
  for (const char* target : {"spirv", "vulkan1.1", "vulkan1.2", "msl23"})
    EXPECT_EQ(status[target], VariantStatus::passed) << target;
  EXPECT_EQ(report.checks.at("vulkan1.0"), "glslang, then SPIRV-Tools for Vulkan 1.0");
  EXPECT_THAT(report_text(report), HasSubstr("SPIR-V validation for Vulkan 1.0: there is no capability"));
}

// A failed compilation is told once for each version, and by no target made from it.
TEST(Validate, AMistakeFailsEveryVersionOfVulkan) {
  const ShaderFiles files;
  files.write("f.hlsl", "float4 Main() : SV_Target { return nothing; }\n");
  ValidationRequest request = file_request(files);
  request.targets = {"vulkan1.0", "vulkan1.2", "msl23"};
  const ValidationReport report = validate(request);
  EXPECT_EQ(report.count(VariantStatus::failed), 3U);
  request.targets.push_back("spirv");
  EXPECT_EQ(validate(request).count(VariantStatus::unreached), 1U);
}

TEST(Validate, OneMistakeIsPrintedOnceHoweverManyVariantsItFails) {
  const ShaderFiles files;
  files.write("part.hlsl", "float F() { return $; }\n");
  files.write("f.hlsl", std::string("#include \"part.hlsl\"\n#define KEYWORD\n") + fragment);
  ValidationRequest request = file_request(files);
  request.files[0].keyword_sets = {{}, {"A"}, {"B"}, {"A", "B"}};
  const ValidationReport report = validate(request);
  EXPECT_EQ(report.count(VariantStatus::failed), 4U);
  EXPECT_EQ(report.count(VariantStatus::unreached), 16U);
  const std::string text = report_text(report);
  const std::string message = "part.hlsl:1:20: error: unexpected token '$'";
  ASSERT_THAT(text, HasSubstr(message));
  EXPECT_EQ(text.find(message, text.find(message) + 1), std::string::npos);
}

TEST(Validate, KeywordsDecideAndOrderIsThatOfTheRequest) {
  const ShaderFiles files;
  files.write(
      "f.hlsl",
      std::string("#if defined(BROKEN)\n#define KEYWORD $\n#else\n#define KEYWORD\n#endif\n") + fragment);
  ValidationRequest request = file_request(files);
  request.files[0].keyword_sets = {{}, {"BROKEN"}};
  request.targets = {"spirv", "msl23"};
  for (const unsigned jobs : {1U, 4U}) {
    request.engine.jobs = jobs;
    const ValidationReport report = validate(request);
    std::vector<VariantStatus> statuses;
    for (const VariantRecord& record : report.records) statuses.push_back(record.status);
    EXPECT_THAT(statuses, testing::ElementsAre(VariantStatus::passed, VariantStatus::passed,
                                               VariantStatus::failed, VariantStatus::unreached));
  }
}

TEST(Validate, FailuresAreReportedWithoutSpirvAmongTheTargets) {
  const ShaderFiles files;
  files.write("f.hlsl", "float4 Main() : SV_Target { return $; }\n");
  ValidationRequest request = file_request(files);
  request.targets = {"msl23", "hlsl50"};
  EXPECT_EQ(validate(request).count(VariantStatus::failed), 1U);
}

TEST(Validate, SameModuleIsTriedOncePerTarget) {
  const ShaderFiles files;
  files.write("f.hlsl", std::string("#define KEYWORD\n") + fragment);
  ValidationRequest request = file_request(files);
  request.files[0].keyword_sets = {{}, {"UNUSED"}};
  const ValidationReport report = validate(request);
  EXPECT_EQ(report.records.size(), 10U);
  EXPECT_EQ(report.unique, 5U);
}

TEST(Validate, AbsentTargetsAreReportedAndTriedAllTheSame) {
  const ShaderFiles files;
  files.write("Platform/Platform.hlsl",
              "#define TEXTURE2D_SHADOW(n) Texture2D<float> n\n#define SAMPLER_CMP(n) "
              "SamplerComparisonState n\n#define TEXTURE2D_SHADOW_ARGS(n, s) n, s\n");
  files.write("F.hlsl",
              "#include \"Core/ShadowStructs.hlsl\"\nfloat F(Texture2D<float> m, SamplerComparisonState s, "
              "ShadowReceiver r, ShadowTile t)\n"
              "{\n    return r.shadowCoord.x;\n}\n");
  files.write("Core/ShadowStructs.hlsl",
              "#ifndef STRUCTS\n#define STRUCTS\nstruct ShadowReceiver { float3 "
              "shadowCoord; float2 depthGradient; float2 rotation; };\nstruct ShadowTile { float4 "
              "offsetScale; };\n#endif\n");
  const std::string list = R"({"techniques": [{"name": "f", "title": "F", "family": "f", "source": "s",
    "filter": {"file": "F.hlsl", "function": "F"}, "keyword_sets": [[]],
    "targets_absent": {"msl23": "for the test"}}]})";
  ValidationRequest request;
  request.techniques = techniques::read_technique_list(files.write("f.technique.json", list));
  request.targets = {"spirv", "msl23"};
  const ValidationReport works = validate(request);
  EXPECT_EQ(works.count(VariantStatus::failed), 0U) << report_text(works);
  EXPECT_THAT(report_text(works), HasSubstr("works, although its manifest lists it as absent: for the test"));
  request.techniques->techniques[0].targets_absent = {{"spirv", "never compiles"}};
  files.write("F.hlsl", "$\n");
  const ValidationReport fails = validate(request);
  EXPECT_EQ(fails.count(VariantStatus::absent), 2U);
  EXPECT_EQ(fails.count(VariantStatus::failed), 0U);
  EXPECT_THAT(report_text(fails), HasSubstr("absent: f, spirv: never compiles (2 variants)"));
}

// The absence is no error of the shader's; a mistake in it is one all the same.
TEST(Validate, StagesThatATargetDoesNotHaveAreAbsentWithTheReason) {
  const ShaderFiles files;
  files.write(
      "g.hlsl",
      "struct V { float4 p : SV_Position; };\n"
      "[maxvertexcount(3)] void Geometry(triangle V v[3], inout TriangleStream<V> s) { s.Append(v[0]); }\n"
      "struct T { float edges[3] : SV_TessFactor; float inside : SV_InsideTessFactor; };\n"
      "[domain(\"tri\")] V Domain(T t, float3 l : SV_DomainLocation, OutputPatch<V, 3> p)\n"
      "{ V v; v.p = p[0].p * l.x; return v; }\n");
  files.write(
      "w.hlsl",
      "struct V { float4 p : SV_Position; };\n"
      "[maxvertexcount(3)] void Wrong(triangle V v[3], inout TriangleStream<V> s) { s.Append(w[0]); }\n");
  ValidationRequest request;
  request.targets = {"spirv", "glsl450", "msl23", "hlsl50"};
  request.files = {{files.path("g.hlsl"), "Geometry", hlsl::Stage::geometry, {{}}},
                   {files.path("g.hlsl"), "Domain", hlsl::Stage::domain, {{}}},
                   {files.path("w.hlsl"), "Wrong", hlsl::Stage::geometry, {{}}}};
  const ValidationReport report = validate(request);
  std::vector<std::string> said;
  for (const VariantRecord& record : report.records)
    if (record.status != VariantStatus::passed)
      said.push_back(record.entry + " " + record.target + " " + status_name(record.status));
  EXPECT_THAT(said,
              testing::ElementsAre("Geometry msl23 absent", "Geometry hlsl50 absent", "Domain hlsl50 absent",
                                   "Wrong spirv failed", "Wrong glsl450 unreached", "Wrong msl23 unreached",
                                   "Wrong hlsl50 unreached"));
  EXPECT_THAT(report_text(report), HasSubstr("msl23: Metal has no geometry stage (1 variant)"));
  EXPECT_THAT(report_text(report),
              HasSubstr("hlsl50: SPIRV-Cross writes no hull, domain and geometry stages"));
}

TEST(Validate, JsonHasTheDesignsMembers) {
  const ShaderFiles files;
  files.write("f.hlsl", "#error no\n");
  const nlohmann::json report = nlohmann::json::parse(report_json(validate(file_request(files))));
  for (const char* key : {"variants", "results", "unique", "failed", "cached", "seconds"})
    EXPECT_TRUE(report.at("summary").at(key).is_number()) << key;
  EXPECT_EQ(report.at("summary").at("variants"), 1);
  EXPECT_EQ(report.at("summary").at("results"), 5);
  EXPECT_EQ(report.at("summary").at("failed"), 1);
  ASSERT_EQ(report.at("variants").size(), 1U);
  ASSERT_EQ(report.at("messages").size(), 1U) << "each message once";
  const nlohmann::json record = results_of(report).at(0);
  EXPECT_EQ(record.at("entry"), "Main");
  EXPECT_EQ(record.at("stage"), "fragment");
  EXPECT_EQ(record.at("target"), "spirv");
  EXPECT_EQ(record.at("status"), "failed");
  EXPECT_TRUE(record.at("keywords").is_array());
  const nlohmann::json& diagnostic = record.at("messages").at(0);
  EXPECT_EQ(diagnostic.at("line"), 1);
  EXPECT_EQ(diagnostic.at("severity"), "error");
  for (const char* key : {"file", "column", "message"}) EXPECT_TRUE(diagnostic.contains(key)) << key;
}

TEST(Validate, FileNameThatIsNoUtf8StaysInAReadableReport) {
  const ShaderFiles files;
  ValidationRequest request = file_request(files);
  request.files[0].file = files.write("caf\xE9.hlsl", "float4 Main() : SV_Target { return $; }\n");
  const nlohmann::json report = nlohmann::json::parse(report_json(validate(request)));
  EXPECT_THAT(report.at("variants").at(0).at("file").get<std::string>(), HasSubstr("caf\xEF\xBF\xBD.hlsl"));
}

TEST(Validate, FileThatCannotBeReadIsBadInput) {
  const ShaderFiles files;
  EXPECT_THROW(validate(file_request(files)), InputError);
}

TEST(Validate, ProgressReachesTheTotal) {
  const ShaderFiles files;
  files.write("f.hlsl", std::string("#define KEYWORD\n") + fragment);
  ValidationRequest request = file_request(files);
  request.files[0].keyword_sets = {{}, {"A"}, {"B"}};
  request.targets = {"spirv"};
  request.engine.jobs = 2;
  std::vector<std::size_t> seen;
  request.engine.progress = [&seen](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 3U);
    seen.push_back(done);
  };
  validate(request);
  EXPECT_THAT(seen, testing::ElementsAre(1U, 2U, 3U));
}

}  // namespace
}  // namespace penumbra::validation
