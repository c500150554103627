#include "input/input_error_matcher.h"
#include "input/located_json.h"

namespace penumbra {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

TEST(JsonObject, ReadsEveryTypeAndFallsBackWhenAbsent) {
  const LocatedJson document = LocatedJson::parse(
      R"({"n": 1.5, "i": 3, "b": true, "t": "x", "v": [1, 2, 3], "s": ["p", "q"], "o": {"k": 7}})", "f");
  JsonObject object(document);
  EXPECT_EQ(object.number("n", 0.0), 1.5);
  EXPECT_EQ(object.integer("i", 0), 3);
  EXPECT_TRUE(object.boolean("b", false));
  EXPECT_EQ(object.text("t", ""), "x");
  EXPECT_THAT(object.numbers("v", 3), ElementsAre(1, 2, 3));
  EXPECT_THAT(object.texts("s"), ElementsAre("p", "q"));
  EXPECT_EQ(object.object("o").integer("k", 0), 7);
  EXPECT_EQ(object.number("absent", 2.5), 2.5);
  EXPECT_EQ(object.object("absent object").number("k", 4.0), 4.0);
  EXPECT_NO_THROW(object.finish());
}

TEST(JsonObject, WrongTypesAreNamedAtTheirPlace) {
  const LocatedJson document =
      LocatedJson::parse("{\n\"n\": \"x\",\n\"i\": 1.5,\n\"v\": [1, 2],\n\"o\": 3}", "f");
  JsonObject object(document);
  expect_input_error([&] { object.number("n", 0.0); }, AllOf(StartsWith("f:2:1"), HasSubstr("a string")));
  expect_input_error([&] { object.integer("i", 0); }, AllOf(StartsWith("f:3:1"), HasSubstr("whole number")));
  expect_input_error([&] { object.numbers("v", 3); }, AllOf(StartsWith("f:4:1"), HasSubstr("3 numbers")));
  expect_input_error([&] { object.object("o"); }, AllOf(StartsWith("f:5:1"), HasSubstr("a number")));
  expect_input_error([&] { object.boolean("n", true); }, HasSubstr("true or false"));
  expect_input_error([&] { object.texts("v"); }, HasSubstr("only strings"));
}

TEST(JsonObject, NumbersBeyondDoubleAreRefused) {
  const std::string text = "{\"n\": 1e999}";
  expect_input_error(
      [&] {
        const LocatedJson document = LocatedJson::parse(text, "f");
        JsonObject(document).number("n", 0.0);
      },
      StartsWith("f:1:"));
}

TEST(JsonObject, UnknownKeysAreRefusedWithTheNearest) {
  const LocatedJson document = LocatedJson::parse("{\"cascades\": 4,\n\"resoluton\": 1024}", "f");
  JsonObject object(document);
  object.integer("cascades", 1);
  object.integer("resolution", 2048);
  expect_input_error(
      [&] { object.finish(); },
      AllOf(StartsWith("f:2:1"), HasSubstr("unknown key 'resoluton'"), HasSubstr("'resolution'?")));
}

TEST(JsonObject, ADocumentThatIsNoObjectIsRefused) {
  const LocatedJson document = LocatedJson::parse("[1]", "f");
  expect_input_error([&] { JsonObject object(document); }, HasSubstr("found an array"));
}

}  // namespace
}  // namespace penumbra
