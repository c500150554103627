// Runs the built program as a person runs it, in a folder of its own.
#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "has_substrs.h"
#include "platform/child_process.h"

namespace penumbra {

class ProgramTest : public testing::Test {
 public:
  using Words = std::vector<std::string>;

  // The options of a study that takes a second.
  static constexpr const char* kSmallStudy =
      "measure --size 32x18 --map-size 256 --reference-samples 32 --scene slabs --light 2 --no-split --seeds "
      "1 "
      "--timing-repeats 0";

  // The words of a command, which blanks part, and then those that may hold blanks.
  static Words words(const std::string& command, const Words& more = {}) {
    std::istringstream stream(command);
    return joined({std::istream_iterator<std::string>(stream), {}}, more);
  }
  static Words joined(Words first, const Words& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
  }

  // The program runs without FXC, which not every machine has, so that it says the same on all of them.
  static platform::ChildResult run(std::vector<std::string> arguments) {
    return run_program(PENUMBRA_PROGRAM, std::move(arguments));
  }

  // The program runs with FXC where it is found.
  static platform::ChildResult run_with_fxc(std::vector<std::string> arguments) {
    return run_program(PENUMBRA_PROGRAM, std::move(arguments), {});
  }

  static platform::ChildResult expect_success(const std::vector<std::string>& arguments) {
    platform::ChildResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << testing::PrintToString(arguments) << result.errors;
    return result;
  }

  static void expect_bad_input(const std::vector<std::string>& arguments,
                               const testing::Matcher<std::string>& says) {
    const platform::ChildResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 2) << testing::PrintToString(arguments) << result.errors;
    EXPECT_THAT(result.errors, says) << testing::PrintToString(arguments);
  }

  static platform::ChildResult shell(const std::string& command) {
    return run_program("/bin/bash", {"-c", command});
  }

 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              (std::string("penumbra-") + info->test_suite_name() + "-" + info->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    std::filesystem::permissions(folder_, std::filesystem::perms::all);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(path(name).parent_path());
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  std::string read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path(name), std::ios::binary).rdbuf();
    return text.str();
  }

  // Every name in the folder, hidden ones too: what a failed run may not leave behind.
  std::vector<std::string> listing() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }

 private:
  using Environment = std::vector<std::pair<std::string, std::string>>;

  static platform::ChildResult run_program(const std::string& program, std::vector<std::string> arguments,
                                           Environment environment = {{"PENUMBRA_FXC", "off"}}) {
    platform::ChildCommand command;
    command.program = program;
    command.arguments = std::move(arguments);
    command.environment = std::move(environment);
    command.timeout = std::chrono::minutes(25);  // a limit for what hangs, however busy the machine is
    return platform::run_child(command);
  }

  std::filesystem::path folder_;
};

}  // namespace penumbra
