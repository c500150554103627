#include "validation/engine.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "input/input_error.h"
#include "validation/validation_units.h"

namespace penumbra::validation {
namespace {

using shaders::ShaderFiles;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

EngineOptions with_processes(unsigned jobs = 2, const char* mode = worker_mode) {
  EngineOptions options;
  options.jobs = jobs;
  options.worker_arguments = {mode};
  return options;
}

std::vector<VariantStatus> statuses(const UnitResult& result) {
  std::vector<VariantStatus> list;
  for (const TargetResult& target : result.targets) list.push_back(target.status);
  return list;
}

constexpr auto passed = VariantStatus::passed;
constexpr auto failed = VariantStatus::failed;
constexpr auto unreached = VariantStatus::unreached;
constexpr auto unchecked = VariantStatus::unchecked;

// There are two files over one include, with keywords that matter, that do not, and that break.
class Engine : public testing::Test {
 protected:
  Engine() {
    files_.write("Shared.hlsl", "float Shared(float2 u) { return u.x; }\n");
    files_.write("Extra.hlsl", "float Extra(float2 u) { return u.y; }\n");
    const std::string body =
        "#include \"Shared.hlsl\"\n#ifdef EXTRA\n#include \"Extra.hlsl\"\n#endif\n"
        "float4 Main(float2 u : TEXCOORD0) : SV_Target\n{\n#ifdef BROKEN\n    return missing;\n#endif\n"
        "#ifdef EXTRA\n    return Extra(u);\n#endif\n    return Shared(u);\n}\n";
    for (const char* name : {"A.hlsl", "B.hlsl"}) {
      files_.write(name, body);
      for (const std::vector<std::string>& keywords :
           std::vector<std::vector<std::string>>{{}, {"EXTRA"}, {"UNUSED"}, {"BROKEN"}})
        units_.push_back(fragment_unit(files_.path(name), keywords));
    }
  }

  EngineRun run(const EngineOptions& options = {}) const { return run_units(units_, options); }
  EngineOptions cached(EngineOptions options = {}) const {
    options.cache = files_.path("cache");
    return options;
  }

  ShaderFiles files_;
  std::vector<CompileUnit> units_;
};

// The message is at its line, instead of what SPIRV-Cross says of the text it emits.
TEST_F(Engine, WhatOneTargetCannotExpressIsItsFailureAlone) {
  files_.write("Wave.hlsl",
               "float4 Main(float u : TEXCOORD0) : SV_Target\n{\n    return WaveActiveSum(u);\n}\n");
  units_ = {fragment_unit(files_.path("Wave.hlsl"))};
  for (int i = 0; i < 2; ++i) {  // the second time from the cache
    const EngineRun result = run(cached());
    ASSERT_THAT(statuses(result.results[0]), ElementsAre(passed, passed, failed));
    const std::vector<hlsl::Diagnostic>& said = result.results[0].targets[2].diagnostics;
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said[0].line, 3);
    EXPECT_THAT(said[0].message, HasSubstr("wave functions need shader model 6.0"));
    EXPECT_EQ(result.results[0].cached, i == 1);
  }
}

TEST_F(Engine, ResultsDoNotDependOnHowTheyCameAbout) {
  const std::vector<std::string> expected = told(run());
  ASSERT_EQ(expected.size(), 8U);
  for (const unsigned jobs : {1U, 2U, 8U}) {
    EngineOptions threads;
    threads.jobs = jobs;
    EXPECT_EQ(told(run(threads)), expected) << jobs << " threads";
    EXPECT_EQ(told(run(with_processes(jobs))), expected) << jobs << " processes";
    const EngineOptions keeping = cached(with_processes(jobs));
    EXPECT_EQ(told(run(keeping)), expected) << jobs << " processes, cold";
    const EngineRun warm = run(keeping);
    EXPECT_EQ(told(warm), expected) << jobs << " processes, warm";
    EXPECT_EQ(cached_count(warm), 8U);
    EXPECT_EQ(warm.compiled, 0U);
    std::filesystem::remove_all(files_.path("cache"));
  }
}

// A text for different targets is two units; the second may find what the first has just kept.
TEST_F(Engine, ResultsOfTheSameRunAreNotCached) {
  files_.write("Broken.hlsl", "float4 Main() : SV_Target { return missing; }\n");
  units_.clear();
  const CompileUnit whole = fragment_unit(files_.path("Broken.hlsl"));
  for (const std::string& target : whole.targets) {
    units_.push_back(whole);
    units_.back().targets = {target};
  }
  EXPECT_EQ(cached_count(run(cached())), 0U);
  EXPECT_EQ(cached_count(run(cached())), units_.size());
}

TEST_F(Engine, StatusesAreByTarget) {
  const EngineRun result = run();
  EXPECT_THAT(statuses(result.results[0]), ElementsAre(passed, passed, passed));
  EXPECT_THAT(statuses(result.results[3]), ElementsAre(failed, unreached, unreached));
  EXPECT_THAT(result.results[3].targets[0].diagnostics.at(0).message, HasSubstr("missing"));
  EXPECT_EQ(result.results[3].targets[0].diagnostics.at(0).line, 8);
}

TEST_F(Engine, EachTextIsCompiledOnceAndEachModuleTriedOnce) {
  for (const EngineOptions& options : {EngineOptions{}, with_processes(4)}) {
    const EngineRun result = run(options);
    // UNUSED makes the text of no keyword; the two files differ in their names only, so their modules are
    // one.
    EXPECT_EQ(result.unique_texts, 6U);
    EXPECT_EQ(result.compiled, 6U);
    EXPECT_EQ(result.unique_modules, 2U);
    EXPECT_EQ(result.results[0].text_key, result.results[2].text_key);
    EXPECT_EQ(result.results[0].module_key, result.results[4].module_key);
  }
}

TEST_F(Engine, AChangedIncludeCostsItsDependentsAlone) {
  const EngineOptions options = cached();
  run(options);
  files_.write("Extra.hlsl", "float Extra(float2 u) { return u.y * 3.0; }\n");
  EngineRun second = run(options);
  EXPECT_EQ(second.compiled, 2U);
  EXPECT_EQ(cached_count(second), 6U);
  EXPECT_FALSE(second.results[1].cached);
  EXPECT_EQ(told(second), told(run()));
  files_.write("Shared.hlsl", "float Shared(float2 u) { return u.x * 2.0; }\n");
  second = run(options);
  EXPECT_EQ(second.compiled, 6U);
  EXPECT_EQ(told(second), told(run()));
  EXPECT_EQ(run(options).compiled, 0U);
}

TEST_F(Engine, WhatChangesNoTextCostsNoCompilation) {
  const EngineOptions options = cached();
  run(options);
  files_.write("Shared.hlsl", "float Shared(float2 u) { return u.x; } // said at length\n");
  const EngineRun second = run(options);
  EXPECT_EQ(second.compiled, 0U);
  EXPECT_EQ(told(second), told(run()));
  files_.write("Shared.hlsl", "float Shared(float2 u) { return u.x; } // said at length\r\n");
  EXPECT_EQ(cached_count(run(options)), 8U) << "line endings are no change";
}

TEST_F(Engine, AMessageQuotesTheLineAsItIsNow) {
  units_ = {units_[3]};
  const EngineOptions options = cached();
  run(options);
  std::ostringstream text;
  text << std::ifstream(files_.path("A.hlsl")).rdbuf();
  std::string changed = text.str();
  changed.replace(changed.find("missing;"), 8, "missing; // why?");
  files_.write("A.hlsl", changed);
  const EngineRun second = run(options);
  EXPECT_EQ(second.results[0].targets[0].diagnostics.at(0).source_line, "    return missing; // why?");
  EXPECT_EQ(told(second), told(run()));
  EXPECT_EQ(told(run(options)), told(run())) << "and the entry is the new one";
}

TEST_F(Engine, AFileThatAppearsEarlierInTheSearchIsRead) {
  files_.write("late/Wide.hlsl", "float Wide() { return 1.0; }\n");
  files_.write("C.hlsl", "#include \"Wide.hlsl\"\nfloat4 Main() : SV_Target { return Wide(); }\n");
  units_ = {fragment_unit(files_.path("C.hlsl"))};
  units_[0].compile.include_directories = {files_.path("early"), files_.path("late")};
  const EngineOptions options = cached();
  EXPECT_EQ(statuses(run(options).results[0])[0], passed);
  EXPECT_EQ(cached_count(run(options)), 1U);
  files_.write("early/Wide.hlsl", "float Wide() { return nothing; }\n");
  const EngineRun second = run(options);
  EXPECT_EQ(cached_count(second), 0U);
  EXPECT_EQ(statuses(second.results[0])[0], failed);
  std::filesystem::remove(files_.path("early/Wide.hlsl"));
  EXPECT_EQ(statuses(run(options).results[0])[0], passed);
}

TEST_F(Engine, AnIncludeThatWasMissingIsLookedForAgain) {
  files_.write("C.hlsl", "#include \"Later.hlsl\"\nfloat4 Main() : SV_Target { return Later(); }\n");
  units_ = {fragment_unit(files_.path("C.hlsl"))};
  const EngineOptions options = cached();
  EXPECT_EQ(statuses(run(options).results[0])[0], failed);
  files_.write("Later.hlsl", "float Later() { return 1.0; }\n");
  EXPECT_EQ(statuses(run(options).results[0])[0], passed);
}

TEST_F(Engine, AFileThatOnlyTheEditorHasLeavesTheUnitUnchecked) {
  files_.write("C.hlsl", "#include \"UnityCG.cginc\"\nfloat4 Main() : SV_Target { return 1; }\n");
  units_ = {fragment_unit(files_.path("C.hlsl"))};
  const UnitResult result = run().results[0];
  EXPECT_THAT(result.unchecked, HasSubstr("'UnityCG.cginc' ships only with the Unity editor"));
  EXPECT_THAT(statuses(result), ElementsAre(unchecked, unchecked, unchecked));
}

TEST_F(Engine, AnIncludeFoundInAnotherCaseIsLookedForEveryTime) {
  files_.write("C.hlsl", "#include \"shared.hlsl\"\nfloat4 Main() : SV_Target { return Shared(0); }\n");
  units_ = {fragment_unit(files_.path("C.hlsl"))};
  const EngineOptions options = cached();
  EXPECT_EQ(statuses(run(options).results[0])[0], passed);
  files_.write("SHARED.hlsl", "");
  EXPECT_EQ(statuses(run(options).results[0])[0], failed) << "two files are as good as each other";
}

TEST_F(Engine, EverythingThatDecidesAnAnswerIsPartOfItsKey) {
  const EngineOptions options = cached();
  units_ = {units_[0]};
  run(options);
  const auto is_known = [&](CompileUnit unit) { return run_units({unit}, options).results[0].cached; };
  CompileUnit changed = units_[0];
  changed.compile.entry = "Other";
  EXPECT_FALSE(is_known(changed));
  changed = units_[0];
  changed.compile.stage = hlsl::Stage::vertex;
  EXPECT_FALSE(is_known(changed));
  changed = units_[0];
  changed.compile.optimise = false;
  changed.targets = {"spirv"};
  EXPECT_FALSE(is_known(changed));
  changed = units_[0];
  changed.targets = {"spirv", "msl23", "glsl450"};
  EXPECT_FALSE(is_known(changed));
  changed = units_[0];
  changed.compile.prepare = true;
  EXPECT_FALSE(is_known(changed));
  changed = units_[0];
  changed.shader = "named otherwise in the report";
  EXPECT_TRUE(is_known(changed));
}

TEST_F(Engine, AFileThatCannotBeReadIsBadInput) {
  units_.push_back(fragment_unit(files_.path("gone.hlsl")));
  EXPECT_THROW(run(), InputError);
  EXPECT_THROW(run(with_processes()), InputError);
}

TEST_F(Engine, WithoutAFolderForTheCacheNothingIsKept) {
  EngineOptions options;
  options.cache = files_.write("a-file", "x") / "cache";
  const EngineRun first = run(options);
  EXPECT_EQ(told(first), told(run({})));
  EXPECT_EQ(cached_count(run(options)), 0U);
}

TEST_F(Engine, ProgressReachesTheTotalColdAndWarm) {
  EngineOptions options = cached(with_processes());
  std::vector<std::size_t> seen;
  options.progress = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 8U);
    seen.push_back(done);
  };
  for (int i = 0; i < 2; ++i) {
    seen.clear();
    run(options);
    EXPECT_THAT(seen, ElementsAre(1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U));
  }
}

// Expects all that is whole in `bad` beside `index` to be as in `good`.
void expect_others_unharmed(const EngineRun& bad, const EngineRun& good, std::size_t index) {
  ASSERT_EQ(bad.results.size(), good.results.size());
  for (std::size_t i = 0; i < bad.results.size(); ++i)
    EXPECT_TRUE(i == index || told(bad.results[i]) == told(good.results[i])) << i;
}

class Isolation : public Engine {
 protected:
  Isolation() {
    files_.write("C.hlsl",
                 "#include \"Shared.hlsl\"\nfloat4 Main(float2 u : U) : SV_Target\n{\n"
                 "    return Shared(u) + KEPT_IN_THE_TEXT;\n}\n");
    units_.insert(units_.begin() + 1, fragment_unit(files_.path("C.hlsl"), {"KEPT_IN_THE_TEXT"}));
    options_ = with_processes(2, misbehaving_mode);
    options_.keep = files_.path("kept");
  }

  // Runs with the second unit misbehaving; every other is as it would be without.
  EngineRun run_with(const std::string& how) {
    const EngineRun good = run();
    std::vector<CompileUnit> units = units_;
    units[1] = misbehaving(units[1], how);
    const EngineRun bad = run_units(units, options_);
    expect_others_unharmed(bad, good, 1);
    return bad;
  }

  static std::string read(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  EngineOptions options_;
};

TEST_F(Isolation, ACrashWhileCompilingFailsTheUnit) {
  const UnitResult result = run_with("crash@spirv").results[1];
  EXPECT_THAT(statuses(result), ElementsAre(failed, unreached, unreached));
  EXPECT_EQ(result.targets[0].diagnostics.at(0).message, "the compiler crashed with SIGABRT");
  EXPECT_EQ(result.targets[0].diagnostics.at(0).rule, compiler_crash);
  EXPECT_EQ(result.targets[0].diagnostics.at(0).file, files_.path("C.hlsl").string());
}

TEST_F(Isolation, ACrashInATargetLeavesTheOtherTargets) {
  const UnitResult result = run_with("crash@msl23").results[1];
  EXPECT_THAT(statuses(result), ElementsAre(passed, failed, passed));
  EXPECT_THAT(result.module_key, testing::Not(IsEmpty()));
  EXPECT_THAT(result.targets[1].reproduction, HasSubstr(files_.path("kept").string()));
}

TEST_F(Isolation, TheTextThatCrashesIsWrittenOut) {
  const std::string file = run_with("crash@spirv").results[1].targets[0].reproduction;
  const std::string text = read(file);
  EXPECT_THAT(text, HasSubstr("// spirv: the compiler crashed with SIGABRT.\n"));
  EXPECT_THAT(text, HasSubstr("C.hlsl; entry Main, stage fragment\n"));
  EXPECT_THAT(text, HasSubstr("KEPT_IN_THE_TEXT=1"));
  EXPECT_THAT(text, HasSubstr("--entry Main --stage fragment --target spirv\n"));
  EXPECT_THAT(text, HasSubstr("float Shared(")) << "includes are in it";
  CompileUnit again = fragment_unit(file);
  EXPECT_EQ(statuses(run_units({again}, {}).results[0])[0], passed) << "it is a shader by itself";
}

TEST_F(Isolation, ACrashOfThePreprocessorLeavesTheSource) {
  const UnitResult result = run_with("crash@preprocess").results[1];
  EXPECT_THAT(statuses(result), ElementsAre(failed, unreached, unreached));
  EXPECT_THAT(read(result.targets[0].reproduction), HasSubstr("#include \"Shared.hlsl\""));
}

// A second try would take twice the time limit.
TEST_F(Isolation, ATextThatCannotBeMadeIsTriedOnce) {
  const std::string pipe = files_.path("pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int descriptor = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK);
  ASSERT_EQ(::write(descriptor, "xxx", 3), 3);
  EXPECT_THAT(statuses(run_with("crash-counted:" + pipe + "@preprocess").results[1]),
              ElementsAre(failed, unreached, unreached));
  std::array<char, 4> left{};
  EXPECT_EQ(::read(descriptor, left.data(), left.size()), 2);
  ::close(descriptor);
}

TEST_F(Isolation, AHangEndsAtItsTime) {
  options_.limits.time = std::chrono::seconds(10);  // what comes before it needs a hundredth of this
  const UnitResult result = run_with("hang@spirv").results[1];
  EXPECT_EQ(
      result.targets[0].diagnostics.at(0).message,
      "the compiler took longer than 10 s; simplify the shader, or raise --time-limit and --memory-limit");
}

TEST_F(Isolation, AnEaterOfMemoryEndsAtItsLimit) {
  options_.limits.memory = std::size_t{768} << 20U;
  const UnitResult result = run_with("eat@hlsl50").results[1];
  EXPECT_THAT(statuses(result), ElementsAre(passed, passed, failed));
  EXPECT_EQ(result.targets[2].diagnostics.at(0).message,
            "the compiler took more than 768 MiB of memory; simplify the shader, or raise --time-limit and "
            "--memory-limit");
  EXPECT_EQ(result.targets[2].diagnostics.at(0).rule, compiler_limit);
}

TEST_F(Isolation, AMistakeOfTheProgramIsToldAsSuch) {
  const UnitResult result = run_with("throw@spirv").results[1];
  EXPECT_EQ(result.targets[0].diagnostics.at(0).message, "the compiler failed: a mistake");
  EXPECT_EQ(result.targets[0].diagnostics.at(0).rule, compiler_crash);
}

TEST_F(Isolation, AWorkerThatIsKilledEveryTimeFailsItsUnit) {
  const UnitResult result = run_with("kill@spirv").results[1];
  EXPECT_EQ(result.targets[0].diagnostics.at(0).message, "the compiler was killed externally by SIGKILL");
}

TEST_F(Isolation, AWorkerThatIsKilledOnceIsForgiven) {
  const std::string pipe = files_.path("once").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int descriptor = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK);
  ASSERT_EQ(::write(descriptor, "x", 1), 1);
  const UnitResult result = run_with("kill-once:" + pipe + "@msl23").results[1];
  EXPECT_THAT(statuses(result), ElementsAre(passed, passed, passed));
  char byte = 0;
  EXPECT_EQ(::read(descriptor, &byte, 1), -1) << "no worker was killed";
  ::close(descriptor);
}

TEST_F(Isolation, UnitsOfOneTextShareItsCrash) {
  units_ = {units_[1], units_[1], units_[2]};
  units_[0] = misbehaving(units_[0], "crash@spirv");
  units_[1] = misbehaving(units_[1], "crash@spirv");
  units_[1].compile.defines.emplace_back("UNUSED", "1");
  options_.jobs = 1;
  const EngineRun result = run_units(units_, options_);
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_THAT(statuses(result.results[i]), ElementsAre(failed, unreached, unreached));
    EXPECT_EQ(result.results[i].targets[0].reproduction, result.results[0].targets[0].reproduction);
  }
  EXPECT_EQ(statuses(result.results[2])[0], passed);
}

TEST_F(Isolation, CrashesAreNotKept) {
  options_ = cached(options_);
  units_ = {misbehaving(units_[1], "crash@msl23")};
  EXPECT_THAT(statuses(run_units(units_, options_).results[0]), ElementsAre(passed, failed, passed));
  EXPECT_THAT(statuses(run_units(units_, options_).results[0]), ElementsAre(passed, failed, passed));
  options_.worker_arguments = {worker_mode};  // the compiler is mended
  EXPECT_THAT(statuses(run_units(units_, options_).results[0]), ElementsAre(passed, passed, passed));
}

TEST(Shards, TogetherAreTheWholeAndShareNothing) {
  std::vector<CompileUnit> units;
  for (int file = 0; file < 40; ++file)
    for (const char* keyword : {"A", "B", "C", "D", "E"})
      units.push_back(fragment_unit("folder/" + std::to_string(file) + ".hlsl", {keyword}));
  for (const unsigned count : {1U, 2U, 7U}) {
    std::vector<std::size_t> all;
    for (unsigned index = 1; index <= count; ++index) {
      const std::vector<std::size_t> own = units_of_shard(units, {index, count});
      EXPECT_TRUE(std::is_sorted(own.begin(), own.end()));
      EXPECT_GT(own.size() * count, units.size() / 2) << "balanced";
      EXPECT_LT(own.size() * count, units.size() * 2) << "balanced";
      all.insert(all.end(), own.begin(), own.end());
    }
    std::sort(all.begin(), all.end());
    ASSERT_EQ(all.size(), units.size());
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i], i);
  }
}

TEST(Shards, DoNotDependOnOrderOthersOrThePlaceOfTheCheckout) {
  std::vector<CompileUnit> units;
  for (int file = 0; file < 30; ++file)
    units.push_back(fragment_unit("here/shaders/" + std::to_string(file) + ".hlsl"));
  const auto names = [](const std::vector<CompileUnit>& from) {
    std::vector<std::string> list;
    for (const std::size_t place : units_of_shard(from, {2, 3}))
      list.push_back(std::filesystem::path(from[place].file).filename().string());
    std::sort(list.begin(), list.end());
    return list;
  };
  const std::vector<std::string> expected = names(units);
  std::vector<CompileUnit> reversed(units.rbegin(), units.rend());
  EXPECT_EQ(names(reversed), expected);
  std::vector<CompileUnit> elsewhere = units;
  for (CompileUnit& unit : elsewhere) unit.file.replace(0, 4, "/builds/17/project");
  EXPECT_EQ(names(elsewhere), expected);
  std::vector<CompileUnit> fewer(units.begin(), units.begin() + 20);
  for (const std::string& name : names(fewer)) EXPECT_THAT(expected, testing::Contains(name));
}

TEST_F(Engine, AShardHasItsResultsInOrder) {
  const EngineRun whole = run();
  std::vector<std::string> joined(whole.results.size());
  for (const unsigned index : {1U, 2U, 3U}) {
    EngineOptions options;
    options.shard = {index, 3};
    for (const UnitResult& result : run(options).results) joined[result.unit] = told(result);
  }
  EXPECT_EQ(joined, told(whole));
}

}  // namespace
}  // namespace penumbra::validation
