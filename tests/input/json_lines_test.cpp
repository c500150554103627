#include "input/json_lines.h"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

TEST(JsonLines, AreOfTheMembersAndTheirElements) {
  const auto json = nlohmann::ordered_json::parse(
      R"({"b": [{"x": [1, 0.1]}, 1e-30], "a\n": {"d": {}, "c": [[2.0]]}, "e": [], "f": "g"})");
  EXPECT_EQ(json_lines(json), R"({
 "b": [
  {"x":[1,0.1]},
  1e-30
 ],
 "a\n": {
  "d": {},
  "c": [[2.0]]
 },
 "e": [],
 "f": "g"
}
)");
  EXPECT_EQ(nlohmann::ordered_json::parse(json_lines(json)), json);
  EXPECT_EQ(json_lines(nlohmann::ordered_json::array()), "[]\n");
}

}  // namespace
}  // namespace penumbra
