// The table of preparation in docs/validating.md has one row for every pass, in the order they run in.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "preparation/prepare.h"

namespace penumbra::preparation {
namespace {

TEST(PreparationDocumentation, NamesEveryPassInItsOrder) {
  std::ifstream file(PENUMBRA_SOURCE_DIR "/docs/validating.md");
  ASSERT_TRUE(file.good());
  std::vector<std::string> documented;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("##")) inside = line == "## Preparation";
    if (!inside || !line.starts_with("| `")) continue;
    documented.push_back(line.substr(3, line.find('`', 3) - 3));
    EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 5) << line;
  }
  std::vector<std::string> names;
  for (const Pass& pass : passes()) names.emplace_back(pass.name);
  EXPECT_EQ(documented, names);
}

}  // namespace
}  // namespace penumbra::preparation
