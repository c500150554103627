// A study that was interrupted between two techniques, and one that was not, give the same results.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "platform/interrupt.h"
#include "study/kept_records.h"
#include "study/small_study.h"

namespace penumbra::study {
namespace {

namespace fs = std::filesystem;

StudySettings settings(const fs::path& cache) {
  StudySettings settings = SmallStudy(scene::built_in("trees"), 2.0, 64, 36).settings;
  settings.noise_seeds = 2;
  settings.cache = cache;
  return settings;
}

std::size_t kept_in(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    count += entry.path().extension() == std::string(".") + kept_record_kind;
  return count;
}

// Interrupts when the technique's turn comes.
StudyProgress until(const std::string& technique) {
  return [technique](std::string_view stage, double, double, std::string_view) {
    if (stage.ends_with(", " + technique)) throw platform::Interrupted();
  };
}

StudyOutcome run(const std::vector<Subject>& chosen, const StudySettings& settings) {
  return run_study(test_device(), chosen, settings, [](auto&&...) {});
}

void interrupt(const std::vector<Subject>& chosen, const StudySettings& settings,
               const std::string& technique) {
  EXPECT_THROW(run_study(test_device(), chosen, settings, until(technique)), platform::Interrupted);
}

TEST(ContinuedStudy, HasTheResultsOfOneThatWasNotInterrupted) {
  const reference::ScratchFolder whole_cache, cache;
  const std::vector<Subject> chosen =
      library_subjects({"tent-5-plane", "pcss-angular-24-16", "screen-pcss-angular-24-16-masked"});
  const StudyOutcome whole = run(chosen, settings(whole_cache.path()));
  EXPECT_EQ(kept_in(whole_cache.path()), 3U) << "until the results are written";
  whole.kept->drop();
  EXPECT_EQ(kept_in(whole_cache.path()), 0U) << "nothing is kept of a study that is finished";

  interrupt(chosen, settings(cache.path()), chosen[2].name);
  EXPECT_EQ(kept_in(cache.path()), 2U);
  const StudyOutcome continued = run(chosen, settings(cache.path()));
  continued.kept->drop();
  EXPECT_EQ(kept_in(cache.path()), 0U);
  EXPECT_EQ(continued.records, whole.records);
  ASSERT_EQ(continued.pictures.size(), whole.pictures.size());
  for (std::size_t i = 0; i < whole.pictures.size(); ++i) {
    EXPECT_EQ(continued.pictures[i].result, whole.pictures[i].result) << chosen[i].name;
    EXPECT_EQ(continued.pictures[i].fetch_counts, whole.pictures[i].fetch_counts) << chosen[i].name;
    EXPECT_EQ(continued.pictures[i].mask, whole.pictures[i].mask) << chosen[i].name;
  }
}

// No two measurements take the same time.
TEST(ContinuedStudy, TakesWhatWasMeasuredBefore) {
  SmallStudy study(scene::built_in("trees"), 2.0, 64, 36);
  study.settings.timing_repeats = 1;
  const std::vector<Subject> chosen = library_subjects({"hard"});
  const Record first = study.run(chosen).records.at(0);
  EXPECT_EQ(study.run(chosen).records.at(0).time, first.time);
}

// Settings and a technique's values that differ are measured again.
TEST(ContinuedStudy, TakesNothingFromAnotherStudy) {
  const reference::ScratchFolder cache;
  std::vector<Subject> chosen = library_subjects({"pcss-angular-24-16", "hard"});
  interrupt(chosen, settings(cache.path()), "hard");
  ASSERT_EQ(kept_in(cache.path()), 1U);

  StudySettings other = settings(cache.path());
  other.noise_seeds = 3;
  const StudyOutcome of_three = run(chosen, other);
  EXPECT_EQ(of_three.records.at(0).metrics.seeds, 3);
  of_three.kept->drop();
  EXPECT_EQ(kept_in(cache.path()), 1U) << "of the first study";

  chosen[0].title = "another title";
  EXPECT_EQ(run(chosen, settings(cache.path())).records.at(0).title, "another title");
}

// A graph of the test whose pass reads one of two textures.
std::vector<Subject> mixed(const fs::path& folder, const std::string& read, int divisor) {
  std::ofstream(folder / "Mix.compute") << R"(
#pragma kernel Fill
#pragma kernel Mix
RWTexture2D<float> _Out;
Texture2D<float> _In;
RWTexture2D<float> _Visibility;
[numthreads(8,8,1)] void Fill(uint3 id : SV_DispatchThreadID) { _Out[id.xy] = 0.75; }
[numthreads(8,8,1)] void Mix(uint3 id : SV_DispatchThreadID)
{
    uint width, height;
    _In.GetDimensions(width, height);
    _Visibility[id.xy] = _In.Load(int3(0, 0, 0)) * width / 100.0;
}
)";
  std::string text = R"({"graphs": [{"name": "mix", "textures": [{"name": "visibility", "format": "r32f"},
      {"name": "whole", "format": "r32f"}, {"name": "small", "format": "r32f", "divisor": DIVISOR}],
    "passes": [
      {"name": "Whole", "kernel": "Fill", "kind": "compute", "compute": "Mix.compute", "writes": {"_Out": "whole"},
       "groups": {"texels_of": "whole"}},
      {"name": "Small", "kernel": "Fill", "kind": "compute", "compute": "Mix.compute", "writes": {"_Out": "small"},
       "groups": {"texels_of": "small"}},
      {"name": "Mix", "kind": "compute", "compute": "Mix.compute", "reads": {"_In": "READ", "_Other": "OTHER"},
       "writes": {"_Visibility": "visibility"}, "groups": {"texels_of": "visibility"}}],
    "visibility": "visibility"}],
    "techniques": [{"name": "mix", "title": "Mix", "family": "mix", "source": "s", "graph": "mix"}]})";
  const auto set = [&](const std::string& word, const std::string& value) {
    text.replace(text.find(word), word.size(), value);
  };
  set("DIVISOR", std::to_string(divisor));
  set("READ", read);
  set("OTHER", read == "whole" ? "small" : "whole");
  std::ofstream(folder / "Mix.technique.json") << text;
  const techniques::TechniqueList list = techniques::read_technique_list(folder / "Mix.technique.json");
  return {technique_subject(list, list.find("mix"), true), library_subjects({"hard"}).front()};
}

// The programs of both graphs are the same.
TEST(ContinuedStudy, TakesNothingOfAnotherGraph) {
  const reference::ScratchFolder cache, files;
  const auto rmse = [&](const std::string& read, int divisor, const fs::path& kept_in) {
    return run(mixed(files.path(), read, divisor), settings(kept_in)).records.at(0).metrics.rmse_all;
  };
  interrupt(mixed(files.path(), "whole", 2), settings(cache.path()), "hard");
  for (const auto& [read, divisor] : {std::pair("small", 2), std::pair("small", 4), std::pair("whole", 2)}) {
    const reference::ScratchFolder empty;
    EXPECT_EQ(rmse(read, divisor, cache.path()), rmse(read, divisor, empty.path())) << read << divisor;
  }
}

// A user's function that answers with its picture's one texel.
TEST(ContinuedStudy, TakesNothingOfAnotherPicture) {
  const reference::ScratchFolder cache, files;
  std::ofstream(files.path() / "a.hlsl")
      << "Texture2D<float4> _Tex;\n"
         "float ShadowVisibility(float3 p, float3 n, float2 x) { return _Tex.Load(int3(0, 0, 0)).x; }\n";
  const auto of = [&](std::uint8_t value) {
    resolve::Adapter adapter;
    adapter.name = "a";
    adapter.file = files.path() / "a.hlsl";
    adapter.textures = {{"_Tex", {1, 1, {value, value, value, 255}}}};
    return std::vector<Subject>{adapter_subject(adapter, true), library_subjects({"hard"}).front()};
  };
  interrupt(of(255), settings(cache.path()), "hard");
  const reference::ScratchFolder empty;
  const auto rmse = [&](const fs::path& folder) {
    return run(of(0), settings(folder)).records.at(0).metrics.rmse_all;
  };
  EXPECT_EQ(rmse(cache.path()), rmse(empty.path()));
}

// The picture with unlimited samples is kept for ever; the programs of both graphs are the same.
TEST(ContinuedStudy, SplitsTheErrorByItsOwnUnlimitedPicture) {
  const reference::ScratchFolder cache, files;
  const fs::path added = fs::path(PENUMBRA_SOURCE_DIR) / "tests/techniques/added";
  fs::copy(added, files.path(), fs::copy_options::recursive);
  const auto split = [&](int divisor, const fs::path& folder) {
    nlohmann::json manifest = nlohmann::json::parse(std::ifstream(added / "Means.technique.json"));
    for (nlohmann::json& texture : manifest["graphs"][0]["textures"]) texture["divisor"] = divisor;
    manifest["techniques"][0]["unlimited"] = {{"scale", 1.0}};
    std::ofstream(files.path() / "Means.technique.json") << manifest;
    const techniques::TechniqueList list =
        techniques::read_technique_list(files.path() / "Means.technique.json");
    StudySettings splitting = settings(folder);
    splitting.split_error = true;
    const std::vector<Subject> subjects{technique_subject(list, list.find("means"), true)};
    return run(subjects, splitting).records.at(0).metrics.split;
  };
  const ErrorSplit first = split(1, cache.path());
  const reference::ScratchFolder empty;
  const ErrorSplit second = split(4, cache.path());
  EXPECT_EQ(second, split(4, empty.path()));
  EXPECT_NE(second, first);
}

TEST(ContinuedStudy, HasPicturesOnlyWhereTheyAreWanted) {
  const reference::ScratchFolder cache;
  const std::vector<Subject> chosen = library_subjects({"tent-5", "hard"});
  StudySettings figures = settings(cache.path());
  figures.pictures = false;
  const StudyOutcome without = run(chosen, figures);
  for (const PictureRow& row : without.pictures) EXPECT_TRUE(row.result.empty() && row.technique.empty());
  interrupt(chosen, figures, "hard");
  const StudyOutcome with = run(chosen, settings(cache.path()));
  EXPECT_EQ(with.records, without.records);
  for (const PictureRow& row : with.pictures) EXPECT_FALSE(row.result.empty()) << row.technique;
}

// A picture of a lit scene needs each technique's own answer.
TEST(ContinuedStudy, KeepsNothingWhereAnswersArePassedOn) {
  const reference::ScratchFolder cache;
  StudySettings passing = settings(cache.path());
  int answers = 0;
  passing.answered = [&](const SubjectAnswer&) { ++answers; };
  const std::vector<Subject> chosen = library_subjects({"tent-5", "hard"});
  interrupt(chosen, passing, "hard");
  EXPECT_EQ(kept_in(cache.path()), 0U);
  run(chosen, passing);
  EXPECT_EQ(answers, 3);
}

}  // namespace
}  // namespace penumbra::study
