#include "input/json_lines.h"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

TEST(JsonLines, AreOfTheMembersAndTheirElements) {
  EXPECT_EQ(json_lines(R"({"b":[{"x":[1,0.1]},1e-30,-0.0],"a\n":{"d":{},"c":[[2.0]]},"e":[],"f":"g"})"), R"({
 "b": [
  {"x":[1,0.1]},
  1e-30,
  -0.0
 ],
 "a\n": {
  "d": {},
  "c": [[2.0]]
 },
 "e": [],
 "f": "g"
}
)");
  EXPECT_EQ(json_lines("[]"), "[]\n");
}

}  // namespace
}  // namespace penumbra
