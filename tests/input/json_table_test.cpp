#include "input/json_table.h"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "input/input_error.h"
#include "input/input_error_matcher.h"

namespace penumbra {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using testing::HasSubstr;
using testing::StartsWith;

LocatedJson read(const std::string& text) {
  return parse_json_table(text, "t.tsv", "rows");
}

int all_digits(const std::string&) {
  return kAllDigits;
}

std::string message_of(const std::string& text) {
  return input_error_of([&] { read(text); });
}

TEST(JsonTable, HasALineForEachElementAndWritesSharedValuesOnce) {
  const char* document = R"({
    "version": 2, "frames": [{"scene": "a", "light": 1}, {"scene": "a", "light": 2}, {"scene": "b"}],
    "rows": [{"name": "x", "map": 2048, "list": [1, 0.123456789]},
             {"name": "y", "map": 2048, "list": []}]})";
  EXPECT_EQ(json_table(document, "rows", [](const std::string&) { return 3; }),
            "# {\"version\": 2,\n"
            "#  \"frames\": [\n"
            "#   {\"scene\":\"a\",\"light\":1}, {\"scene\":\"a\",\"light\":2},\n"
            "#   {\"scene\":\"b\"}],\n"
            "#  \"rows\": {\"map\": 2048}}\n"
            "name\tlist/0\tlist/1\tlist\n"
            "x\t1\t0.123\t\n"
            "y\t\t\t[]\n");
}

TEST(JsonTable, ReadsBackWhatWasWritten) {
  for (
      const char* text : {
          R"({"rows": []})",
          R"({"rows": [{"a": null}]})",
          R"({"rows": [{"a": ""}, {"a": {}}, {"a": []}, {"a": {"b": [[1, 2], {"c": true}]}}]})",
          R"({"rows": [{"a": "1"}, {"a": "null"}, {"a": "=1+1"}, {"a": "#"}, {"a": "\"x\""}, {"a": " x "}]})",
          R"({"rows": [{"a": "line\nend\ttab\u2028\u202e"}, {"a": "é ✓"}], "after": "=x"})",
          R"({"rows": [{"a": -1.5, "b": 1}, {"a": 18446744073709551615, "b": 1}, {"b": 1}]})",
          R"({"rows": [{"a/b": {"~1": 1}}]})",
          R"({"rows": [{"l": [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10]}, {"l": [5]}]})",
      }) {
    const std::string table = json_table(text, "rows", all_digits);
    EXPECT_EQ(read(table).value(), json::parse(text)) << table;
    std::string from_windows;
    for (const char c : table) from_windows += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(read(from_windows).value(), json::parse(text));
  }
}

TEST(JsonTable, NumbersHaveTheDigitsAskedForButForTheExactOnes) {
  const char* document = R"({"rows": [{"a": 0.123456, "b": {"c": 0.123456}}]})";
  const auto digits = [](const std::string& path) { return path == "b/c" ? kAllDigits : 2; };
  EXPECT_THAT(json_table(document, "rows", digits), HasSubstr("\n0.12\t0.123456\n"));
}

TEST(JsonTable, NoCellBeginsAFormula) {
  for (const char* text : {"=1", "+1", "-x", "@x", "'x"}) {
    const std::string table = json_table(ordered_json{{"rows", {{{"a", text}}}}}.dump(), "rows", all_digits);
    EXPECT_THAT(table, HasSubstr("\na\n\"\\u00")) << text;
    EXPECT_EQ(read(table).value()["rows"][0]["a"], text);
  }
}

TEST(JsonTable, RefusesKeysThatCannotHeadAColumn) {
  for (const char* text :
       {R"({"rows": [{"a\tb": 1}]})", R"({"rows": [{"a": {"0": 1}}]})", R"({"rows": [{"": 1}]})"})
    EXPECT_THROW(json_table(text, "rows", all_digits), InputError) << text;
}

TEST(JsonTable, KnowsThePlaceOfEveryValue) {
  const LocatedJson document =
      read("# {\"rows\": {\n#  \"deep/shared\": 1}}\nname\tdeep/own\nx\t12\ny\t13\n");
  EXPECT_EQ(document.where(LocatedJson::Pointer("/rows/1/name")), "t.tsv:5:1");
  EXPECT_EQ(document.where(LocatedJson::Pointer("/rows/1/deep/own")), "t.tsv:5:3");
  EXPECT_EQ(document.where(LocatedJson::Pointer("/rows/1/deep/shared")), "t.tsv:2:4");
  EXPECT_EQ(document.value()["rows"][1], json::parse(R"({"name": "y", "deep": {"own": 13, "shared": 1}})"));
}

TEST(JsonTable, SaysWhereATableIsBroken) {
  const std::string head = "# {\"rows\": {}}\n";
  const std::vector<std::pair<std::string, std::string>> broken{
      {"# {\"rows\": {}\na\n1\n", "t.tsv:2:1: not valid JSON"},
      {"# []\na\n1\n", "t.tsv:1:1: the head must be one JSON object"},
      {"# {}\na\n1\n", "t.tsv: the head has no object 'rows'"},
      {"# {\"rows\": []}\na\n1\n", "t.tsv: the head has no object 'rows'"},
      {"# {\"rows\": {\"a\": [1]}}\nb\n1\n", "t.tsv:1:13: 'a' must be one value"},
      {"# {\"rows\": {\"a\": 1}}\na\n1\n", "t.tsv:2:1: the column 'a' appears twice"},
      {head, "t.tsv:2:1: the line with the names of the columns is missing"},
      {head + "a\tb\n1\n", "t.tsv:3:1: the line has 1 cells, and 2 columns are named"},
      {head + "a\tb\n1\t1\n\n2\t2\n", "t.tsv:4:1: an empty line in the table"},
      {head + "a\ta\n1\t1\n", "t.tsv:2:3: the column 'a' appears twice"},
      {head + "a\ta/b\n1\t2\n", "t.tsv:3:1: 'a' has a value and parts"},
      {head + "a//b\n1\n", "t.tsv:2:1: 'a//b' is no path of a value"},
      {head + "a/0\ta/x\n1\t2\n", "'a/x' cannot stand beside 'a/0'"},
      {head + "a/0\ta/2\n1\t2\n", "'a/2' cannot stand beside 'a/0'"},
      {head + "a/0\ta/1\n\t2\n", "t.tsv:3:1: 'a' lacks element 0 of 1"},
      {head + "a\n[1]\n", "t.tsv:3:1: the cell must be one value"},
      {head + "a\n\"x\n", "t.tsv:3:1: the cell begins with a quote and is no JSON text"},
      {head + "a\nx\xFF\n", "t.tsv:3:1: the cell is not UTF-8, or not one line of text"},
      {head + "a\tb", "t.tsv:2:1: the file ends within this line, which has no line break: it was cut off"},
      {head + "a\tb\n1\t2\n3\t4", "t.tsv:4:1: the file ends within this line"},
      {head + "a\nx\x01\n", "t.tsv:3:1: the cell is not UTF-8, or not one line of text"},
  };
  for (const auto& [text, message] : broken) EXPECT_THAT(message_of(text), HasSubstr(message)) << text;
}

// A value that all rows share costs its file one place, and the reader one for each row.
TEST(JsonTable, IsNotMadeLargerThanItsText) {
  std::string head = "# {\"rows\": {\"a\": 1";
  for (int i = 0; i < 1000; ++i) head += ", \"a" + std::to_string(i) + "\": 1";
  std::string rows = "b\n";
  for (int i = 0; i < 200; ++i) rows += "1\n";
  EXPECT_THAT(message_of(head + "}}\n" + rows), HasSubstr("the table has more values than characters"));
  std::string deep = "a";
  for (int i = 0; i < 300; ++i) deep += "/a";
  EXPECT_THAT(message_of("# {\"rows\": {}}\n" + deep + "\n1\n"), HasSubstr("nested deeper than 200 levels"));
}

}  // namespace
}  // namespace penumbra
