// A technique of the user's own is its files alone: validate, measure and cost take them as they are.
#include "cli/program.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "scene/scene.h"

namespace penumbra {
namespace {

using testing::HasSubstr;

std::string added(const std::string& name) {
  return std::string(PENUMBRA_SOURCE_DIR) + "/tests/techniques/added/" + name + ".technique.json";
}

class TechniqueListCommand : public ProgramTest {
 protected:
  // The results of a small study of trees.
  static nlohmann::json measured(const std::string& options) {
    const auto result = expect_success(
        words("measure --light 2 --reference-samples 32 --timing-repeats 0 --no-split " + options));
    return nlohmann::json::parse(result.output);
  }
};

TEST_F(TechniqueListCommand, PassesOverTheMapAndAFilterAreValidatedMeasuredAndCosted) {
  const auto valid = run({"validate", "--technique-list", added("Means"), "--no-cache"});
  EXPECT_EQ(valid.exit_code, 0) << valid.output;
  EXPECT_THAT(valid.output, HasSubstr("20 variants for 5 targets: 100 results"));

  const nlohmann::json record =
      measured("--scene trees --map-size 128 --size 32x16 --technique-list " + added("Means"))
          .at("records")
          .at(0);
  EXPECT_EQ(record.at("technique"), "means");
  EXPECT_EQ(record.at("fetches_mean"), 1.0);
  // There are 1 + 5 + 5 fetches for each of 128 x 128 texels, and 4 for each of 64 x 64.
  EXPECT_EQ(record.at("preprocess_fetches_per_pixel"), (11.0 * 128 * 128 + 4.0 * 64 * 64) / (32 * 16));

  const nlohmann::json& rows = record.at("passes").at(1);
  EXPECT_EQ(rows.at("pass"), "Rows");
  EXPECT_EQ(rows.at("runs"), "cascade");
  EXPECT_EQ(rows.at("fetches_per_pixel"), 5.0 * 128 * 128 / (32 * 16));
  EXPECT_EQ(rows.at("texels_written_per_pixel"), 128.0 * 128 / (32 * 16));
  EXPECT_EQ(rows.at("fetches_per_cascade"), 5.0 * 64 * 64);
  EXPECT_EQ(rows.at("invocations_per_pixel"), 128.0 * 128 / (32 * 16));
  EXPECT_EQ(rows.at("bytes_read_per_pixel"), 4 * 5.0 * 128 * 128 / (32 * 16)) << "single texels of r32f";
  EXPECT_EQ(rows.at("bytes_written_per_pixel"), 4 * 128.0 * 128 / (32 * 16));
  EXPECT_EQ(rows.at("draws"), 4.0) << "a tile for each cascade";
  EXPECT_FALSE(rows.contains("dispatches") || rows.contains("groups") || rows.contains("barriers_per_group"));
  double operations = 0.0;
  for (const nlohmann::json& pass : record.at("passes"))
    operations += pass.at("operations_per_pixel").get<double>();
  EXPECT_GT(rows.at("operations_per_pixel"), 0.0);
  EXPECT_DOUBLE_EQ(record.at("operations_per_pixel").get<double>(), operations);

  const auto cost = expect_success({"cost", "--technique-list", added("Means"), "--family", "navi21"});
  for (const char* pass : {"means: Depths", "means: Rows", "means: Columns", "means: Mips"})
    EXPECT_THAT(cost.output, HasSubstr(pass));
}

TEST_F(TechniqueListCommand, TheLibrarysTechniquesAreMeasuredBesideOnesOwn) {
  const nlohmann::json records =
      measured("--scene trees --map-size 128 --size 32x16 --technique means,tent-5 --technique-list " +
               added("Means"))
          .at("records");
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].at("technique"), "means");
  EXPECT_EQ(records[1].at("technique"), "tent-5");
  EXPECT_EQ(records[1].at("fetches_mean"), 9.0);
  EXPECT_GT(records[1].at("operations_per_pixel"), 9.0) << "a filter alone";
}

TEST_F(TechniqueListCommand, AllStandsForEveryTechniqueAndScene) {
  std::set<std::string> scenes;
  const nlohmann::json results =
      measured("--scene all --map-size 128 --size 16x9 --technique all --technique-list " + added("Means"));
  for (const nlohmann::json& record : results.at("records")) {
    EXPECT_EQ(record.at("technique"), "means");
    scenes.insert(record.at("scene"));
  }
  EXPECT_EQ(scenes.size(), scene::scene_names().size());
}

TEST_F(TechniqueListCommand, MapsThatATechniqueCannotDivideAreRefusedBeforeTheFirstPicture) {
  const auto refused = run(
      {"measure", "--technique", "tent-5,single-loop-32-planes", "--scene", "trees", "--map-size", "202"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors,
              HasSubstrs("'single-loop-32-planes' makes a texel of 'depthPlanes' of 4 x 4 texels",
                         "a cascade's tile of 101 texels is no multiple of 4",
                         "choose a map size that is a multiple of 8"));
  EXPECT_EQ(refused.output, "");
  measured("--technique single-loop-32-planes,tiled-pcss --scene trees --map-size 200 --size 32x16");
}

TEST_F(TechniqueListCommand, TitlesLeadToNames) {
  const auto variance = run({"measure", "--technique", "vsm"});
  EXPECT_EQ(variance.exit_code, 2);
  EXPECT_THAT(variance.errors,
              HasSubstr("unknown technique 'vsm'\n  did you mean 'variance-32', 'variance-16'"));
  EXPECT_THAT(run({"measure", "--technique", "evsm"}).errors, HasSubstr("'exponential-variance-32'"));
  EXPECT_THAT(run({"measure", "--technique", "tent"}).errors, HasSubstr("did you mean 'tent-"));
  EXPECT_THAT(run({"measure", "--technique", "zzzzzz"}).errors, HasSubstr("--list-techniques"));
}

TEST_F(TechniqueListCommand, KernelsAreValidatedMeasuredAndCosted) {
  const auto valid = run({"validate", "--technique-list", added("Blocks"), "--no-cache"});
  EXPECT_EQ(valid.exit_code, 0) << valid.output;
  EXPECT_THAT(valid.output, HasSubstr("8 variants for 5 targets: 40 results"));
  measured("--scene trees --map-size 128 --size 32x16 --technique-list " + added("Blocks"));
  const auto cost = expect_success({"cost", "--technique-list", added("Blocks"), "--family", "navi21"});
  for (const char* kernel : {"blocks: Mark", "blocks: Collect", "blocks: Sum", "blocks: Shade"})
    EXPECT_THAT(cost.output, HasSubstr(kernel));
}

TEST_F(TechniqueListCommand, PassesOfCastersAreValidatedMeasuredAndCosted) {
  const auto valid = run({"validate", "--technique-list", added("Layers"), "--no-cache"});
  EXPECT_EQ(valid.exit_code, 0) << valid.output;
  // There are two passes of two stages with and without alpha test, and the filter's two; in both directions
  // of depth.
  EXPECT_THAT(valid.output, HasSubstr("20 variants for 5 targets: 100 results"));

  const nlohmann::json record =
      measured("--scene trees --map-size 128 --size 32x16 --technique-list " + added("Layers"))
          .at("records")
          .at(0);
  EXPECT_EQ(record.at("technique"), "layers");
  const nlohmann::json& layers = record.at("passes").at(0);
  EXPECT_EQ(layers.at("pass"), "Layers");
  EXPECT_EQ(layers.at("runs"), "cascade");
  EXPECT_GT(layers.at("texels_written_per_pixel"), 0.0);

  const auto cost = expect_success({"cost", "--technique-list", added("Layers"), "--family", "navi21"});
  for (const char* pass : {"layers: Layers", "layers: Nearest"}) EXPECT_THAT(cost.output, HasSubstr(pass));
}

TEST_F(TechniqueListCommand, TheFirstExampleOfThePageIsMeasuredAsItStands) {
  std::ostringstream text;
  text << std::ifstream(PENUMBRA_SOURCE_DIR "/docs/add-technique.md").rdbuf();
  const std::string page = text.str();
  const auto first_block = [&](const std::string& fence) {
    const std::size_t begin = page.find(fence) + fence.size();
    return page.substr(begin, page.find("```", begin) - begin);
  };
  write("Ring.hlsl", first_block("```hlsl\n"));
  const std::string manifest = write("Ring.technique.json", first_block("```json\n")).string();
  expect_success({"emit", "--technique-list", manifest});
  const auto valid = run({"validate", "--technique-list", manifest, "--no-cache"});
  EXPECT_EQ(valid.exit_code, 0) << valid.output;
  const nlohmann::json records =
      measured("--technique all --scene contact-boxes --size 96x54 --seeds 1 --technique-list " + manifest)
          .at("records");
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].at("technique"), "ring-8");
  EXPECT_EQ(records[0].at("fetches_mean"), 8.0);
  EXPECT_EQ(records[1].at("fetches_mean"), 16.0);
}

TEST_F(TechniqueListCommand, AMistakeIsNamedAtItsLine) {
  const std::string manifest =
      write("a.technique.json", "{\"techniques\": [\n {\"name\": \"a\", \"tilte\": \"A\"}]}").string();
  for (const char* subcommand : {"validate", "measure", "render", "cost"}) {
    const auto result = run({subcommand, "--technique-list", manifest});
    EXPECT_EQ(result.exit_code, 2) << subcommand;
    EXPECT_THAT(result.errors,
                HasSubstrs("a.technique.json:2:", "unknown key 'tilte'", "did you mean 'title'?"))
        << subcommand;
  }
}

}  // namespace
}  // namespace penumbra
