// Compares ProjectVersion.txt's version with the number that Unity gives to shaders.
#include "project/unity_project.h"

#include <gtest/gtest.h>

namespace penumbra::project {
namespace {

int number(const std::string& text) {
  const std::optional<EditorVersion> version = parse_editor_version(text);
  return version ? unity_version_number(*version) : -1;
}

TEST(EditorVersion, NumbersAreThoseOfTheManual) {
  EXPECT_EQ(number("2022.3.0f1"), 202230);
  EXPECT_EQ(number("6000.0.2f1"), 60000002);
  EXPECT_EQ(number("6000.2.3f1"), 60020003);
  EXPECT_EQ(number("6000.0.1234f1"), 60001234);
}

TEST(EditorVersion, PatchAboveNineCarriesAsInGeneratedShaders) {
  EXPECT_EQ(number("2017.4.18f1"), 201758);  // this editor generated the value in shader code
  EXPECT_EQ(number("2022.3.20f1"), 202250);
  EXPECT_EQ(number("5.6.3p1"), 563);
}

TEST(EditorVersion, NewerEditorNeverHasASmallerNumber) {
  const char* const editors[] = {"2019.4.0f1", "2020.3.0f1", "2021.3.0f1",  "2022.3.0f1",
                                 "2023.2.9f1", "6000.0.0f1", "6000.0.58f1", "6000.1.0b3"};
  for (std::size_t i = 1; i < std::size(editors); ++i)
    EXPECT_LT(number(editors[i - 1]), number(editors[i])) << editors[i];
}

TEST(EditorVersion, OtherTextIsNone) {
  for (const char* text : {"", "2022", "2022.3", "2022..1", "a.b.c", "-1.2.3", "2022.3.-1", "99999.1.1",
                           "2022.99999999999999.1", " 2022.3.1"})
    EXPECT_EQ(number(text), -1) << text;
}

}  // namespace
}  // namespace penumbra::project
