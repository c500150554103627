// Compares the list of rules with the page that explains them.
#include "lint/rule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace penumbra::lint {
namespace {

std::string page() {
  std::ifstream stream(std::filesystem::path(PENUMBRA_SOURCE_DIR) / "docs" / "lint.md");
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

struct Section {
  std::string name;
  std::string text;
};

std::vector<Section> sections() {
  std::vector<Section> all;
  std::istringstream lines(page());
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("### ", 0) == 0) all.push_back({line.substr(4), {}});
    if (!all.empty()) all.back().text += line + "\n";
  }
  return all;
}

TEST(Rules, NamesAreKebabCaseAndUnique) {
  std::set<std::string> names;
  for (const RuleInfo& rule : rules()) {
    EXPECT_EQ(rule.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string::npos) << rule.name;
    EXPECT_TRUE(names.insert(rule.name).second) << rule.name;
    EXPECT_FALSE(rule.summary.empty()) << rule.name;
    EXPECT_FALSE(rule.source.empty()) << rule.name;
    EXPECT_EQ(find_rule(rule.name), &rule);
  }
  EXPECT_EQ(find_rule("no-such-rule"), nullptr);
}

TEST(Rules, ThePageHasOneSectionForEachInOrder) {
  std::vector<std::string> expected;
  for (const RuleInfo& rule : rules()) expected.push_back(rule.name);
  std::vector<std::string> written;
  for (const Section& section : sections()) written.push_back(section.name);
  EXPECT_EQ(written, expected);
}

TEST(Rules, EachSectionShowsAnExampleAndHowToSuppressIt) {
  for (const Section& section : sections()) {
    const RuleInfo* rule = find_rule(section.name);
    ASSERT_NE(rule, nullptr) << section.name;
    EXPECT_NE(section.text.find("```"), std::string::npos) << section.name;
    EXPECT_NE(section.text.find("Source: "), std::string::npos) << section.name;
    if (rule->name != "unknown-rule" && rule->name != "not-checked") {
      EXPECT_NE(section.text.find("=" + rule->name), std::string::npos) << section.name;
    }
  }
}

}  // namespace
}  // namespace penumbra::lint
