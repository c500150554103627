#include "input/located_json.h"

#include <sys/resource.h>

#include <filesystem>
#include <fstream>

#include "input/input_error_matcher.h"

namespace penumbra {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::size_t peak_resident_bytes() {
  rusage usage{};
  EXPECT_EQ(::getrusage(RUSAGE_SELF, &usage), 0);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

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

TEST(LocatedJson, KnowsThePlacesOfArraysElementsAndOfOddKeys) {
  const LocatedJson document =
      LocatedJson::parse("[[1,\n 2], {\"a/b~\": {\"\": 3}},\n  {\"a\": {}, \"b\": 4}]", "f.json");
  EXPECT_EQ(document.where(LocatedJson::Pointer("")), "f.json:1:1");
  EXPECT_EQ(document.where(LocatedJson::Pointer("/0/1")), "f.json:2:3") << "an element's end";
  EXPECT_EQ(document.where(LocatedJson::Pointer("/1/a~1b~0/")), "f.json:2:16");
  EXPECT_EQ(document.where(LocatedJson::Pointer("/2/b")), "f.json:3:13");
  EXPECT_EQ(document.where(LocatedJson::Pointer("/2/c")), "f.json");
  EXPECT_EQ(document.where(LocatedJson::Pointer("/2/a/c")), "f.json");
}

// A place does not hold the keys of what it is in.
TEST(LocatedJson, MemoryGrowsWithTheTextNotWithItsDepth) {
  const std::string key(2000, 'k');
  std::string text;
  for (int i = 0; i < 100; ++i) text += "{\"" + key + "\":";
  text += "[";
  for (int i = 0; i < 20000; ++i) text += "1,";
  text += "1]" + std::string(100, '}');
  const std::size_t before = peak_resident_bytes();
  const LocatedJson document = LocatedJson::parse(text, "f.json");
  LocatedJson::Pointer last;
  for (int i = 0; i < 100; ++i) last /= key;
  EXPECT_EQ(document.where(last / 20000), "f.json:1:" + std::to_string(text.size() - 100));
  EXPECT_LT(peak_resident_bytes() - before, std::size_t{100} << 20U) << "of a text of 240 kB";
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
