// The table in Documentation~/preparation.md has one row for every pass, in the order they run in.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "preparation/prepare.h"

namespace penumbra::preparation {
namespace {

TEST(PreparationDocumentation, NamesEveryPassInItsOrder) {
  std::ifstream file(PENUMBRA_SOURCE_DIR "/Documentation~/preparation.md");
  ASSERT_TRUE(file.good());
  std::vector<std::string> documented;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("| `", 0) != 0) continue;
    documented.push_back(line.substr(3, line.find('`', 3) - 3));
    EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 5) << line;
  }
  std::vector<std::string> names;
  for (const Pass& pass : passes()) names.emplace_back(pass.name);
  EXPECT_EQ(documented, names);
}

}  // namespace
}  // namespace penumbra::preparation
