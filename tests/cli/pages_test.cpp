// Every command line that README, the pages and the scripts' comments print is one that the program parses.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "cli/parse_only.h"

namespace penumbra::cli {
namespace {

std::string read(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

// The commands of fenced blocks, where a backslash goes on in the next line, and of lines "Command: `penumbra
// ...`".
std::vector<std::string> commands_of(std::string page) {
  static const std::regex start("^(?:source <\\()?(?:build/release/)?penumbra +(.*)$");
  static const std::regex generated("^Command: `penumbra +([^`]*)`.*$");
  std::vector<std::string> commands;
  page = std::regex_replace(page, std::regex("\\\\\n *"), " ");
  std::istringstream lines(page);
  bool fenced = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) fenced = !fenced;
    std::smatch match;
    if (std::regex_match(line, match, generated) || (fenced && std::regex_match(line, match, start)))
      commands.push_back(match[1]);
  }
  return commands;
}

std::string refusal(const std::string& command) {
  return ParseOnly().refusal(words_of(command));
}

TEST(Pages, PrintOnlyCommandsThatTheProgramParses) {
  const std::filesystem::path root = PENUMBRA_SOURCE_DIR;
  std::vector<std::filesystem::path> pages{root / "README.md"};
  for (const char* folder : {"Documentation~", "docs"})
    for (const auto& entry : std::filesystem::directory_iterator(root / folder))
      if (entry.path().extension() == ".md") pages.push_back(entry.path());
  std::size_t commands = 0;
  for (const std::filesystem::path& page : pages)
    for (const std::string& command : commands_of(read(page))) {
      if (command.find("...") != std::string::npos) continue;  // a form, not a command
      ++commands;
      EXPECT_EQ(refusal(command), "") << page.filename() << ": penumbra " << command;
    }
  EXPECT_GT(commands, 40U);
}

TEST(Pages, WhatDoesNotParseIsFound) {
  EXPECT_THAT(commands_of("```\npenumbra render \\\n  --nonsense 1  # why\n```\npenumbra in text\n"),
              testing::ElementsAre("render  --nonsense 1  # why"));
  EXPECT_NE(refusal("render  --nonsense 1  # why"), "");
  EXPECT_EQ(refusal("render --light 2  # why --nonsense"), "");
  EXPECT_NE(refusal("rende --light 2"), "");
}

}  // namespace
}  // namespace penumbra::cli
