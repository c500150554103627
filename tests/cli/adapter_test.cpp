// Tests a user's own shadow function through the command: what follows the file, whose includes, and from
// where it looks.
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace penumbra {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class AdapterCommand : public ProgramTest {
 protected:
  platform::ChildResult measure(const std::vector<std::string>& options) {
    return run(joined(words(kSmallStudy, {"--cache", path("cache").string()}), options));
  }

  double rmse_all(const std::vector<std::string>& options) {
    const platform::ChildResult result = measure(options);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(result.output).at("records").at(0).at("rmse_all");
  }
};

constexpr const char* kNumberAndTexture = R"(
#include "Platform/Platform.hlsl"
float _Shares[3];
TEXTURE2D(_Mask);
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    return _Shares[2] * LOAD_TEXTURE2D(_Mask, int2(0, 0)).x;
}
)";

TEST_F(AdapterCommand, NumbersAreUniformsAndOtherValuesTextures) {
  const std::string file = write("mine.hlsl", kNumberAndTexture).string();
  const double lit = rmse_all({"--adapter", "mine=" + file + ";_Shares=0,0,1;_Mask=white"});
  const double dark = rmse_all({"--adapter", "mine=" + file + ";_Shares=0,0,1;_Mask=black"});
  const double lit_by_no_share = rmse_all({"--adapter", "mine=" + file + ";_Shares=1,1,0;_Mask=white"});
  EXPECT_NE(lit, dark);
  EXPECT_EQ(lit_by_no_share, dark);
}

TEST_F(AdapterCommand, WhatFollowsTheFileIsCheckedBeforeAnythingIsMeasured) {
  const std::string file = write("mine.hlsl", kNumberAndTexture).string();
  for (const auto& [ending, words] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {";_Shares=0,0,1;_Mask=clouds.png", {"_Mask=clouds.png", "neither a number nor", "white"}},
           {";9X", {"'9X' is not a keyword's name"}},
           {";bad keyword", {"'bad keyword' is not a keyword's name"}},
           {";@depth-bias=x", {"@depth-bias: 'x' is not a number"}},
           {";_Shares=0,0,1;_Shares=1,1,1;_Mask=white", {"'_Shares' is given twice"}},
           {";_Shares=0,0;_Mask=white", {"3 numbers", "given 2"}},
           {";_Shares=0,0,1", {"mine.hlsl:4:", "texture '_Mask'"}}}) {
    const auto result = measure({"--adapter", "mine=" + file + ending});
    EXPECT_EQ(result.exit_code, 2) << ending;
    for (const std::string& word : words) EXPECT_THAT(result.errors, HasSubstr(word));
  }
}

TEST_F(AdapterCommand, AFunctionWithoutFetchesHasAReport) {
  const std::string file =
      write("lit.hlsl", "float ShadowVisibility(float3 p, float3 n, float2 pixel) { return 1.0; }\n")
          .string();
  const auto result = measure({"--adapter", "lit=" + file, "--output", path("report").string()});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(read("report/results.json"), HasSubstr("\"fetches_mean\": 0.0"));
}

TEST_F(AdapterCommand, ResultsThatAreNoVisibilityAreCountedByMeasureAndRender) {
  const std::string file =
      write("dark.hlsl",
            "float ShadowVisibility(float3 p, float3 n, float2 pixel) { return sqrt(-1.0 - abs(p.x)); }\n")
          .string();
  const auto told =
      AllOf(testing::ContainsRegex("dark: ([0-9]+) of [0-9]+ results are not finite or not in 0..1"),
            HasSubstr("scene slabs, light 2"));
  const auto measured = measure({"--adapter", "dark=" + file, "--quiet"});
  EXPECT_EQ(measured.exit_code, 1);
  EXPECT_THAT(measured.errors, told);
  const auto rendered =
      run(words("render --size 32x18 --map-size 256 --reference-samples 32 --scene slabs --light 2 --quiet",
                {"--cache", path("cache").string(), "--adapter", "dark=" + file, "--sheet",
                 path("sheet.png").string()}));
  EXPECT_EQ(rendered.exit_code, 1);
  EXPECT_THAT(rendered.errors, told);
  EXPECT_TRUE(std::filesystem::exists(path("sheet.png")));
}

TEST_F(AdapterCommand, APackageAndAssetsOfAProjectAreIncluded) {
  write("game/Packages/com.mine.shadows/package.json", R"({"name": "com.mine.shadows", "version": "1.2.3"})");
  write("game/Packages/com.mine.shadows/Lit.hlsl", "float Lit() { return 1.0; }\n");
  write("game/Assets/Half.hlsl", "float Half() { return 0.5; }\n");
  const std::string file = write("mine.hlsl", R"(
#include "Packages/com.mine.shadows/Lit.hlsl"
#include "Assets/Half.hlsl"
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel) { return Lit() * Half(); }
)")
                               .string();
  EXPECT_GT(rmse_all({"--adapter", "mine=" + file, "--project", path("game").string()}), 0.0);
  const auto without = measure({"--adapter", "mine=" + file});
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_THAT(without.errors, HasSubstrs("mine.hlsl:2", "com.mine.shadows"));
  EXPECT_EQ(measure({"--adapter", "mine=" + file, "--project", path("nowhere").string()}).exit_code, 2);
}

// Messages quote the files that are included. An adapter and a manifest may come from anywhere, and the
// folder that the program is started in may be the user's home.
class DownloadedText : public AdapterCommand {
 protected:
  void SetUp() override {
    AdapterCommand::SetUp();
    write("home/.netrc", "machine git.example password hunter2\n");
  }

  // The program's output, when it is started in the folder `place` of this home.
  platform::ChildResult in_home(const std::string& place, const std::string& arguments) const {
    return shell("cd " + path("home/" + place).string() + " && HOME=" + path("home").string() + " " +
                 PENUMBRA_PROGRAM + " " + arguments + " --cache " + path("cache").string() + " 2>&1");
  }

  static std::string measured(const std::string& what) { return std::string(kSmallStudy) + " " + what; }
};

constexpr const char* kReadsUp =
    "#include \"../../.netrc\"\nfloat ShadowVisibility(float3 p, float3 n, float2 x) { return 1; }\n";

TEST_F(DownloadedText, AnAdapterReadsNothingOfTheHomeFolder) {
  write("home/Downloads/evil/evil.hlsl", kReadsUp);
  write("home/beside.hlsl",
        "#include \".netrc\"\nfloat ShadowVisibility(float3 p, float3 n, float2 x) { return 1; }\n");
  for (const auto& [place, file] : std::vector<std::pair<std::string, std::string>>{
           {".", "Downloads/evil/evil.hlsl"}, {"Downloads/evil", "evil.hlsl"}, {".", "beside.hlsl"}}) {
    const auto result = in_home(place, measured("--adapter a=" + file));
    EXPECT_EQ(result.exit_code, 2) << result.output;
    EXPECT_THAT(result.output, AllOf(HasSubstr("netrc' leads to"), HasSubstr("outside of the project"),
                                     testing::Not(HasSubstr("hunter2"))))
        << place << " " << file;
  }
}

TEST_F(DownloadedText, AManifestReadsNothingOfTheHomeFolder) {
  const std::string manifest =
      R"({"techniques": [{"name": "evil", "title": "Evil", "family": "f", "source": "s",
          "filter": {"file": "FILE", "function": "Filter", "arguments": ["shadowMap"]}}]})";
  const auto with = [&](const std::string& file) {
    return std::string(manifest).replace(manifest.find("FILE"), 4, file);
  };
  write("home/Downloads/evil/evil.technique.json", with("evil.hlsl"));
  write("home/Downloads/evil/evil.hlsl", kReadsUp);
  write("home/beside.technique.json", with(".netrc"));
  for (const auto& [file, words] : std::vector<std::pair<std::string, std::string>>{
           {"Downloads/evil/evil.technique.json", "outside of the project"},
           {"beside.technique.json", "lies outside of"}})
    for (const std::string& command : {measured(""), std::string("validate --target spirv")}) {
      const auto result = in_home(".", command + " --technique-list " + file);
      EXPECT_NE(result.exit_code, 0) << result.output;
      EXPECT_THAT(result.output, AllOf(HasSubstr(words), testing::Not(HasSubstr("hunter2")))) << file;
    }
}

// The technique's file is included by its whole name, so it is no matter that the program's text and the
// user's are both mine.hlsl.
TEST_F(DownloadedText, AnAdapterOfTheFoldersOwnNameIsMeasured) {
  write("home/own/mine.hlsl",
        "#include \"lit.hlsl\"\nfloat ShadowVisibility(float3 p, float3 n, float2 x) { return kLit; }\n");
  write("home/own/lit.hlsl", "static const float kLit = 1.0;\n");
  const auto result = in_home("own", measured("--adapter mine=mine.hlsl"));
  EXPECT_EQ(result.exit_code, 0) << result.output;
}

TEST_F(AdapterCommand, TheCameraStandsWhereItIsTold) {
  const auto seen = [this](const std::vector<std::string>& camera) {
    const platform::ChildResult result = measure(joined({"--technique", "hard"}, camera));
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(result.output).at("records").at(0).at("pixels").get<int>();
  };
  // A camera high above, looking a little aside of straight down, sees the ground in every pixel; one that
  // looks into the sky sees none.
  EXPECT_EQ(seen({"--camera", "0", "8", "0", "0", "0", "0.1", "30"}), 32 * 18);
  EXPECT_EQ(seen({"--camera", "0", "8", "0", "0", "16", "1"}), 0);
  for (const char* camera : {"0 8 0 0 0 0", "0 8 0 0 8 0", "0 8 0 0 0 5 180", "0 8 0"}) {
    const auto result = measure(words("--technique hard --camera " + std::string(camera)));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, HasSubstr("--camera"));
  }
}

}  // namespace
}  // namespace penumbra
