// Processes that share a cache, one of which is killed at random, over and over: no answer is ever wrong.
#include "validation/cache_processes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>
#include <thread>

#include "platform/terminal.h"
#include "validation/validation_units.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): not every system declares it

namespace penumbra::validation {
namespace {

constexpr int units_of_a_salt = 4;
constexpr std::size_t most_of_a_salt = 12;  // entries in the cache
constexpr const char* shader =
    "float4 Main(float2 u : TEXCOORD0) : SV_Target\n{\n#if PLACE % 2\n    return missing_SALT;\n#endif\n"
    "    return u.xyxy * SALT + PLACE;\n}\n";

// Every salt has four texts of its own, two of which fail.
std::vector<CompileUnit> salted_units(const std::filesystem::path& file, int first, int last) {
  std::vector<CompileUnit> units;
  for (int salt = first; salt <= last; ++salt) {
    for (int place = 0; place < units_of_a_salt; ++place) {
      CompileUnit unit = fragment_unit(file);
      unit.compile.defines = {{"SALT", std::to_string(salt)},
                              {"missing_SALT", "missing_" + std::to_string(salt)},
                              {"PLACE", std::to_string(place)}};
      units.push_back(std::move(unit));
    }
  }
  return units;
}

EngineOptions keeping(const std::filesystem::path& cache) {
  EngineOptions options;
  options.cache = cache;
  return options;
}

// Expects answers that are right by what the shader says, not by another run.
void expect_right(const EngineRun& run, int first) {
  for (const UnitResult& result : run.results) {
    const int salt = first + static_cast<int>(result.unit) / units_of_a_salt;
    const bool fails = result.unit % 2 == 1;
    EXPECT_EQ(result.targets[0].status, fails ? VariantStatus::failed : VariantStatus::passed);
    if (fails) {
      ASSERT_EQ(result.targets[0].diagnostics.size(), 1U);
      EXPECT_THAT(result.targets[0].diagnostics[0].message,
                  testing::HasSubstr("missing_" + std::to_string(salt) + "'"));
    }
  }
}

pid_t start_cache_user(const std::filesystem::path& cache, const std::filesystem::path& file, int first,
                       int last) {
  std::vector<std::string> words{platform::program_path().string(),
                                 cache_user_mode,
                                 cache.string(),
                                 file.string(),
                                 std::to_string(first),
                                 std::to_string(last)};
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t process = 0;
  EXPECT_EQ(::posix_spawn(&process, argv[0], nullptr, nullptr, argv.data(), environ), 0);
  return process;
}

std::size_t files_in(const std::filesystem::path& folder) {
  std::size_t count = 0;
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error))
    ++count;
  return count;
}

// Waits until that many files are in the folder. It goes by what is done and not by time: how long work takes
// depends on what else the machine does.
void wait_for_files(const std::filesystem::path& folder, std::size_t count) {
  const auto hang = std::chrono::steady_clock::now() + std::chrono::minutes(5);
  while (files_in(folder) < count) {
    ASSERT_LT(std::chrono::steady_clock::now(), hang) << "nobody writes to the cache";
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

TEST(CacheProcesses, OneOfTwoKilledAHundredTimesNoAnswerIsWrong) {
  const shaders::ShaderFiles files;
  const std::filesystem::path file = files.write("f.hlsl", shader);
  const std::filesystem::path cache = files.path("cache");
  std::mt19937 random(20240);
  run_units(salted_units(file, 0, 0), keeping(cache));
  for (int salt = 1; salt < 101; ++salt) {
    // The victim writes this salt's entries while we do, and reads those that the last victim left; then it
    // goes on with entries of its own until it is killed.
    const int first = salt - 1;
    const pid_t victim = start_cache_user(cache, file, first, salt);
    ASSERT_NO_FATAL_FAILURE(wait_for_files(cache, files_in(cache) + random() % most_of_a_salt));
    EngineRun beside;
    std::thread we([&] { beside = run_units(salted_units(file, first, salt), keeping(cache)); });
    wait_for_files(cache, files_in(cache) + random() % most_of_a_salt);
    ::kill(victim, SIGKILL);
    we.join();
    expect_right(beside, first);
    int status = 0;
    ::waitpid(victim, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << "it works until it is killed";
  }
  const std::vector<CompileUnit> all = salted_units(file, 0, 100);
  const EngineRun kept = run_units(all, keeping(cache));
  expect_right(kept, 0);
  EXPECT_EQ(told(kept), told(run_units(all, {})));
  EXPECT_GT(cached_count(kept), all.size() * 9 / 10);
}

}  // namespace

int use_cache(int argc, char** argv) {
  if (argc != 6) return 2;
  EngineOptions options = keeping(argv[2]);
  options.worker_arguments = {worker_mode};
  const int first = std::atoi(argv[4]);
  const int last = std::atoi(argv[5]);
  const pid_t test = ::getppid();
  run_units(salted_units(argv[3], first, last), options);
  for (int salt = 1000 * last; ::getppid() == test; ++salt)
    run_units(salted_units(argv[3], salt, salt), options);
  return 0;
}

}  // namespace penumbra::validation
