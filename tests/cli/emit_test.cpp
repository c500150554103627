// Tests penumbra emit: what is checked in is what the manifests say, and a copy of a technique is that
// technique.
#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/program.h"
#include "fxc/at_hand.h"
#include "techniques/parameter_packing.h"
#include "techniques/technique_call.h"
#include "techniques/technique_list.h"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const fs::path root = PENUMBRA_SOURCE_DIR;
const fs::path added = root / "tests/techniques/added";

class Emit : public ProgramTest {
 protected:
  // The manifest has a filter with parameters, and passes before it.
  std::string write_means() const {
    for (const char* name : {"Means.hlsl", "Means.shader", "MeansPasses.hlsl", "Means.technique.json"})
      fs::copy_file(added / name, path(name));
    return path("Means.technique.json").string();
  }

  platform::ChildResult emit_in_package(const std::string& options) const {
    return shell("cd " + path("").string() + " && " PENUMBRA_PROGRAM " emit " + options);
  }
};

TEST_F(Emit, WhatIsCheckedInIsUpToDate) {
  std::vector<std::string> lists{root.string()};
  for (const auto& entry : fs::directory_iterator(added))
    if (entry.path().string().ends_with(".technique.json")) lists.push_back(entry.path().string());
  EXPECT_EQ(lists.size(), 5U);
  for (const std::string& list : lists) {
    const auto result = expect_success({"emit", "--check", "--technique-list", list});
    EXPECT_EQ(result.output, "") << "write them anew: penumbra emit --technique-list " << list;
  }
}

TEST_F(Emit, OfAManifestWithALibraryOnlyItsOwnHlslIsWritten) {
  write("package.json", "{}");
  write("Shaders/Box.hlsl", "// box\n");
  write("Shaders/Box.technique.json", R"({"techniques": [{"name": "box", "title": "Box", "family": "box",
    "source": "Nobody 1900", "filter": {"file": "Box.hlsl", "function": "F"}}]})");
  const std::string manifest = write("study/Ring.technique.json", R"({"library": "..",
    "structs": [{"name": "RingParameters", "doc": "d", "fields": [
      {"name": "taps", "type": "int", "unit": "1", "doc": "d", "default": 3}]}],
    "techniques": [{"name": "ring", "title": "Ring", "like": "box",
      "filter": {"file": "../Shaders/Box.hlsl", "function": "F", "parameters": "RingParameters"}}]})")
                                   .string();
  const auto written = expect_success({"emit", "--technique-list", manifest});
  EXPECT_EQ(written.output, path("study/Parameters/RingParameters.hlsl").lexically_normal().string() + "\n");
}

TEST_F(Emit, WritesOnlyWhatChangesAndACheckNamesItsFirstDifferingLine) {
  const std::string manifest = write_means();
  const auto file = [&](const std::string& name) { return path(name).lexically_normal().string(); };
  const std::string hlsl = file("Parameters/MeansParameters.hlsl");
  const std::string csharp = file("Runtime/Parameters/MeansParameters.cs");
  const std::vector<std::string> emit{"emit", "--technique-list", manifest};
  const std::vector<std::string> check{"emit", "--technique-list", manifest, "--check"};
  EXPECT_EQ(run(check).exit_code, 1);
  EXPECT_FALSE(fs::exists(hlsl));
  const auto written = expect_success(emit);
  EXPECT_EQ(written.output, file("Runtime/Techniques/Means.txt") + "\n" + hlsl + "\n" + csharp + "\n");
  EXPECT_EQ(run(check).exit_code, 0);

  const std::string right = read("Parameters/MeansParameters.hlsl");
  std::string wrong = right;
  wrong.replace(wrong.find("struct MeansParameters"), 22, "struct\tMeansParameters");
  write("Parameters/MeansParameters.hlsl", wrong);
  fs::remove(csharp);
  const auto found = run(check);
  EXPECT_EQ(found.exit_code, 1);
  const auto line =
      1 + std::count(right.begin(), right.begin() + static_cast<long>(right.find("struct M")), '\n');
  EXPECT_EQ(found.output, hlsl + ":" + std::to_string(line) +
                              ": 'struct\tMeansParameters' would be 'struct MeansParameters'\n" + csharp +
                              ":1: there is no such file\n");
  EXPECT_EQ(read("Parameters/MeansParameters.hlsl"), wrong) << "a check writes nothing";
  EXPECT_EQ(run(emit).output, hlsl + "\n" + csharp + "\n");
  EXPECT_EQ(read("Parameters/MeansParameters.hlsl"), right);
  const auto nothing = run(emit);
  EXPECT_EQ(nothing.output, "");
  EXPECT_THAT(nothing.errors, HasSubstr("up to date"));

  write("Parameters/MeansParameters.hlsl", right + "\n// more");
  EXPECT_THAT(run(check).output, HasSubstr(": '' would be the end of the file\n"));
  write("Parameters/MeansParameters.hlsl", right.substr(0, right.size() - 1));
  EXPECT_THAT(run(check).output,
              HasSubstr(": the end of the file without a line break would be the end of the file\n"));
}

TEST_F(Emit, ParametersOfAnEarlierManifestAreNotMeasuredWith) {
  const std::string manifest = write_means();
  ASSERT_EQ(run({"emit", "--technique-list", manifest}).exit_code, 0);
  const std::vector<std::string> check{"emit", "--single-file", "means", "--technique-list", manifest};
  EXPECT_EQ(run(check).exit_code, 0);
  nlohmann::json changed = nlohmann::json::parse(read("Means.technique.json"));
  nlohmann::json& fields = changed["structs"][0]["fields"];
  std::reverse(fields.begin(), fields.end());
  write("Means.technique.json", changed.dump());
  for (const char* command : {"validate", "measure", "render", "cost", "emit"}) {
    std::vector<std::string> arguments{command, "--technique-list", manifest};
    if (arguments[0] == "emit") arguments = check;
    const auto refused = run(arguments);
    EXPECT_EQ(refused.exit_code, 2) << command;
    EXPECT_THAT(refused.errors, testing::ContainsRegex(
                                    "MeansParameters.hlsl:[0-9]+: was not made of Means.technique.json as "
                                    "it is now\n  write it again: penumbra emit --technique-list .*/Means"))
        << command;
  }
  write("Parameters/MeansParameters.hlsl", "// by hand\n");
  EXPECT_THAT(run(check).errors, Not(HasSubstr("was not made of")));
}

// The package is as it is embedded in a project, without the repository's tests, and the user is in its
// folder.
TEST_F(Emit, APackageHasTheFeaturesTablesToo) {
  for (const char* folder : {"ShaderLibrary", "Shaders"})
    fs::copy(root / folder, path(folder), fs::copy_options::recursive);
  EXPECT_EQ(emit_in_package("--check").exit_code, 1);
  const auto result = emit_in_package("");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, AllOf(HasSubstr("Runtime/Settings/ShadowTechnique.cs\n"),
                                   HasSubstr("Runtime/Techniques/Techniques.txt\n"), Not(HasSubstr(".hlsl")),
                                   Not(HasSubstr(".json"))));
  for (const auto& entry : fs::recursive_directory_iterator(path("Runtime"))) {
    if (!entry.is_regular_file()) continue;
    const fs::path name = entry.path().lexically_relative(path(""));
    std::ostringstream text;
    text << std::ifstream(root / name, std::ios::binary).rdbuf();
    EXPECT_EQ(read(name.string()), text.str()) << name;
  }
  EXPECT_FALSE(fs::exists(path("tests")));
  EXPECT_EQ(emit_in_package("--check").exit_code, 0);
}

TEST_F(Emit, OptionsThatExcludeEachOtherAreRefused) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"emit", "-o", path("a.hlsl").string()}, {"emit", "--check", "--single-file", "tent-5"}})
    EXPECT_EQ(run(arguments).exit_code, 2) << arguments.back();
  expect_bad_input({"emit", "--single-file", "tiled-pcss"},
                   HasSubstr("'tiled-pcss' draws its visibility by passes"));
  EXPECT_THAT(run({"emit", "--single-file", "tent5"}).errors, HasSubstr("'tent-5'"));
}

TEST_F(Emit, ACopyHasTheVisibilityOfTheTechnique) {
  const techniques::TechniqueList list = techniques::read_technique_list(root);
  const techniques::Technique& technique = list.find("pcss-angular-24-16");
  ASSERT_EQ(run({"emit", "--single-file", technique.name, "-o", path("Copied.hlsl").string()}).exit_code, 0);
  fs::copy(root / "tests/cli/CopyAdapter.hlsl", path("Adapter.hlsl"));
  std::string adapter = "copy=" + path("Adapter.hlsl").string() +
                        ";@depth-bias=" + std::to_string(technique.bias.depth) +
                        ";@normal-bias=" + std::to_string(technique.bias.normal) +
                        ";@soft-quality=" + technique.bias.soft_quality;
  for (const techniques::ParameterStruct* parameters : list.structs_of(technique)) {
    const std::vector<std::array<float, 4>> vectors = techniques::packed(*parameters, technique.values);
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      adapter += ";" + techniques::uniform_name(*parameters, i) + "=";
      for (const float value : vectors[i]) adapter += std::to_string(value) + ",";
      adapter.pop_back();
    }
  }
  const auto measured = expect_success(
      words("measure --scene trees --light 2 --cascades 1 --map-size 256 --size 64x36 --reference-samples 32 "
            "--seeds 1 --timing-repeats 0 --no-split",
            {"--technique", technique.name, "--adapter", adapter, "--cache", path("cache").string()}));
  const nlohmann::json records = nlohmann::json::parse(measured.output).at("records");
  ASSERT_EQ(records.size(), 2U);
  EXPECT_GT(records[0].at("rmse_all"), 0.0);
  EXPECT_EQ(records[0].at("rmse_all"), records[1].at("rmse_all"));
  EXPECT_EQ(records[0].at("fetches_mean"), records[1].at("fetches_mean"));
}

constexpr const char* kCaller = R"(ShadowTile _Tile;
float4 Main(float3 shadowCoord : TEXCOORD0, float4 more : TEXCOORD1) : SV_Target
{
    ShadowReceiver receiver;
    receiver.shadowCoord = shadowCoord;
    receiver.depthGradient = more.xy;
    receiver.rotation = more.zw;
    return ResolveTechnique(receiver, _Tile, 0);
}
)";

// Techniques that differ in values alone have one program.
TEST_F(Emit, FxcTakesEveryCopy) {
  PENUMBRA_NEEDS_FXC();
  const std::string variants = (root / "tests/study/StudyVariants.technique.json").string();
  const techniques::TechniqueList list = techniques::read_technique_list(variants);
  std::set<std::string> programs;
  std::vector<std::string> validate{"validate", "--target", "d3d11", "--no-lint", "--no-cache"};
  for (const techniques::Technique& technique : list.techniques) {
    if (technique.graph.filter_pass() == nullptr) continue;
    if (!programs.insert(techniques::emit_technique_call(list, technique).source()).second) continue;
    const std::string copy = technique.name + ".copy.hlsl";
    expect_success(
        {"emit", "--technique-list", variants, "--single-file", technique.name, "-o", path(copy).string()});
    validate.push_back(
        write(technique.name + ".hlsl", "#pragma target 5.0\n#include \"" + copy + "\"\n" + kCaller)
            .string());
  }
  const auto result = run_with_fxc(validate);
  EXPECT_EQ(result.exit_code, 0) << result.output << result.errors;
}

}  // namespace
}  // namespace penumbra
