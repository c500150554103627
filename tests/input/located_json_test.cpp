#include "input/located_json.h"

#include <filesystem>
#include <fstream>

#include "input/input_error_matcher.h"

namespace penumbra {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST(LocatedJson, KnowsTheLineAndColumnOfEveryKey) {
  const LocatedJson document =
      LocatedJson::parse("{\n  \"a\": 1,\n  \"list\": [\n    {\"deep\": true}]\n}", "f.json");
  EXPECT_EQ(document.where(LocatedJson::Pointer("/a")), "f.json:2:3");
  EXPECT_EQ(document.where(LocatedJson::Pointer("/list")), "f.json:3:3");
  EXPECT_EQ(document.where(LocatedJson::Pointer("/list/0/deep")), "f.json:4:6");
}

TEST(LocatedJson, AgreesWithTheLibrarysOwnParser) {
  const std::string text =
      R"({"s": "\u00e9\n", "n": [-1.5e3, 7, 18446744073709551615], "e": {}, "z": null, "b": [[]]})";
  EXPECT_EQ(LocatedJson::parse(text, "x").value(), nlohmann::json::parse(text));
}

TEST(LocatedJson, EmptyTextIsNamedAsSuch) {
  expect_input_error([] { LocatedJson::parse(" \n", "f.json"); },
                     AllOf(StartsWith("f.json: "), HasSubstr("empty")));
}

TEST(LocatedJson, ASyntaxErrorPointsAtItsLine) {
  expect_input_error([] { LocatedJson::parse("{\n  \"a\": 1\n  \"b\": 2\n}", "f.json"); },
                     AllOf(StartsWith("f.json:3:"), HasSubstr("not valid JSON")));
  expect_input_error([] { LocatedJson::parse("{\"a\": [1, 2", "f.json"); }, StartsWith("f.json:1:"));
}

TEST(LocatedJson, ADuplicateKeyIsRefusedAtItsSecondPlace) {
  expect_input_error([] { LocatedJson::parse("{\"a\": 1,\n\"a\": 2}", "f.json"); },
                     AllOf(StartsWith("f.json:2:1"), HasSubstr("twice")));
}

TEST(LocatedJson, DeepNestingIsRefusedNotCrashedOn) {
  const std::string deep(100000, '[');
  expect_input_error([&] { LocatedJson::parse(deep, "f.json"); }, HasSubstr("nested deeper"));
}

TEST(LocatedJson, MissingFilesAndFoldersAreNamed) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  expect_input_error([&] { LocatedJson::read(folder); }, HasSubstr("is a folder"));
  expect_input_error([&] { LocatedJson::read(folder / "penumbra-no-such.json"); },
                     HasSubstr("cannot be opened"));
}

TEST(LocatedJson, AByteOrderMarkIsSkipped) {
  EXPECT_EQ(LocatedJson::parse("\xEF\xBB\xBF{\"a\": 1}", "f").value()["a"], 1);
}

}  // namespace
}  // namespace penumbra
