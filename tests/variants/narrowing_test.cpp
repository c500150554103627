#include "variants/narrowing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "input/input_error_matcher.h"
#include "variants/program_text.h"

namespace penumbra::variants {
namespace {

using testing::ElementsAre;

TEST(Narrowing, TakesAwayWhatAnyOfItsPlacesDoes) {
  const std::string text =
      "#pragma multi_compile _ A\n#pragma multi_compile _ B\n#pragma multi_compile _ DEBUG_DISPLAY\n";
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "penumbra-narrowing.json";
  std::ofstream(file) << R"({"urp": {"debug_display": false}})";
  const auto left = [&](const NarrowingInput& input) {
    return texts_of(KeywordSpace(pragmas_of(text), read_narrowing(input)).whole_program());
  };
  EXPECT_EQ(left({}).size(), 8U);
  EXPECT_EQ(left({file, {}, {}}).size(), 4U);
  EXPECT_EQ(left({{}, {}, {"+A", "-B"}}).size(), 2U);
  EXPECT_THAT(left({file, {}, {"+A", "-B"}}), ElementsAre("A"));
  std::filesystem::remove(file);
}

TEST(Narrowing, WhatIsWrongIsSaidOfItsPlace) {
  expect_input_error(
      [] {
        read_narrowing({{}, {}, {"A"}});
      },
      "--keywords: 'A' does not say whether it is on or off\n"
      "  write +NAME (always on), -NAME (never on) or A|B (only these of their set)");
}

}  // namespace
}  // namespace penumbra::variants
