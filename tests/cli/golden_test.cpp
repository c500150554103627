// Other implementations are compared with what penumbra constants --golden writes.
#include "cli/program.h"

namespace penumbra {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class Golden : public ProgramTest {};

TEST_F(Golden, TheSameCountAndSeedGiveTheSameBytes) {
  const auto first = run({"constants", "--golden", "3", "--seed", "9"});
  EXPECT_EQ(first.exit_code, 0);
  EXPECT_THAT(first.errors, IsEmpty());
  EXPECT_THAT(first.output, HasSubstr("\"written_by\": \"penumbra constants --golden 3 --seed 9\""));
  EXPECT_EQ(run({"constants", "--golden", "3", "--seed", "9", "-o", path("out.json").string()}).exit_code, 0);
  EXPECT_EQ(read("out.json"), first.output);
  EXPECT_NE(run({"constants", "--golden", "3", "--seed", "10"}).output, first.output);
}

TEST_F(Golden, NothingThatDescribesASetupGoesWithIt) {
  for (const char* other : {"--fov=2", "--cascades=2", "--light=2", "--map-size=64"}) {
    const auto result = run({"constants", "--golden", "3", other});
    EXPECT_EQ(result.exit_code, 2) << other;
    EXPECT_THAT(result.errors, HasSubstr(std::string(other).substr(0, std::string(other).find('='))));
    EXPECT_THAT(result.errors, HasSubstr("--golden"));
  }
  EXPECT_EQ(run({"constants", "--golden", "3", "--format", "json"}).exit_code, 2);
  EXPECT_EQ(run({"constants", "--golden", "3", "--matrices", "dump.json"}).exit_code, 2);
}

TEST_F(Golden, BadCountsAndALoneSeedAreRefused) {
  for (const char* count : {"0", "-1", "100001", "many"}) {
    expect_bad_input({"constants", "--golden", count}, HasSubstr("--golden"));
  }
  expect_bad_input({"constants", "--seed", "1"}, HasSubstr("--golden"));
}

}  // namespace
}  // namespace penumbra
