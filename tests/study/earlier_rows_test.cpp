// Rows of earlier results stand beside new ones only where both saw the same pictures.
#include "study/earlier_rows.h"

#include <gmock/gmock.h>

#include "input/input_error_matcher.h"
#include "study/synthetic_study.h"

namespace penumbra::study {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::vector<std::string> kTents{"bilinear", "tent-5x5"};

Results now() {
  return synthetic::results({"pcss-24-16", "pcss-64-64"});
}

Results before() {
  Results results = synthetic::results({"bilinear", "tent-5x5", "pcss-24-16"});
  results.commit = "0123456789abcdef";
  results.command = "penumbra measure --technique bilinear";
  return results;
}

std::string problem(const Results& earlier, const std::vector<std::string>& rows = kTents) {
  Results results = now();
  const std::string error = input_error_of([&] { add_earlier_rows(results, earlier, rows, "before.json"); });
  EXPECT_EQ(results, now()) << "nothing was added";
  return error;
}

TEST(EarlierRows, AreAddedBehindTheOthersWithHowTheyWereMeasured) {
  Results results = now();
  add_earlier_rows(results, before(), kTents, "before.json");
  const std::size_t own = now().records.size();
  ASSERT_EQ(results.records.size(), 2 * own);
  for (std::size_t i = own; i < results.records.size(); ++i)
    EXPECT_THAT(results.records[i].technique, testing::AnyOf("bilinear", "tent-5x5"));
  ASSERT_EQ(results.earlier.size(), 1U);
  EXPECT_EQ(results.earlier[0].techniques, kTents);
  EXPECT_EQ(results.earlier[0].commit, "0123456789abcdef");
  EXPECT_EQ(parse_results(to_json(results), "again.json"), results);
  EXPECT_EQ(results.earlier[0].command, "penumbra measure --technique bilinear");
}

// A table of results has fewer digits than a run.
TEST(EarlierRows, OfATableStandBesideNewOnes) {
  Results measured = before();
  for (Record& record : measured.records) record.reference.noise_floor = 0.006597053252417021;
  Results results = now();
  for (Record& record : results.records) record.reference.noise_floor = 0.006597053252417021;
  add_earlier_rows(results, parse_results(to_table(measured), "before.tsv"), kTents, "before.tsv");
  EXPECT_EQ(results.records.size(), 2 * now().records.size());
}

TEST(EarlierRows, TakenASecondTimeKeepTheRunThatMeasuredThem) {
  Results first = now();
  first.commit = "fedcba9876543210";
  add_earlier_rows(first, before(), kTents, "before.json");
  Results second = synthetic::results({"moments-32"});
  add_earlier_rows(second, first, {"tent-5x5", "pcss-64-64"}, "first.json");
  ASSERT_EQ(second.earlier.size(), 2U);
  EXPECT_EQ(second.earlier[0].techniques, std::vector<std::string>{"tent-5x5"});
  EXPECT_EQ(second.earlier[0].commit, "0123456789abcdef");
  EXPECT_EQ(second.earlier[1].techniques, std::vector<std::string>{"pcss-64-64"});
  EXPECT_EQ(second.earlier[1].commit, "fedcba9876543210");
}

TEST(EarlierRows, OfOtherPicturesAreRefused) {
  Results other = before();
  other.frames[0].width += 1;
  EXPECT_THAT(problem(other), AllOf(HasSubstr("before.json"), HasSubstr("has another picture or light there"),
                                    HasSubstr("measure all techniques in one run")));
  other = before();
  other.frames.erase(other.frames.begin());
  EXPECT_THAT(problem(other), HasSubstr("was not measured there"));
}

TEST(EarlierRows, OfOtherMapsOrReferencesAreRefused) {
  Results other = before();
  for (Record& record : other.records) record.map_size *= 2;
  EXPECT_THAT(problem(other), HasSubstr("was measured there with a map of "));
  other = before();
  for (Record& record : other.records) record.reference.samples += 1;
  EXPECT_THAT(problem(other), HasSubstr("rays per pixel, here with"));
  other = before();
  for (Record& record : other.records) record.metrics.penumbra_pixels += 1;
  EXPECT_THAT(problem(other), HasSubstr("was measured there with"));
}

TEST(EarlierRows, OfAnotherCompilerAreRefused) {
  Results earlier = before();
  earlier.front_end = "FXC 10.0";
  EXPECT_THAT(problem(earlier), AllOf(HasSubstr("compiled by FXC 10.0, those here are by glslang"),
                                      HasSubstr("the same --front-end")));
}

TEST(EarlierRows, ThatAreUnknownOrMeasuredAgainAreRefused) {
  EXPECT_THAT(problem(before(), {"tent-5x6"}),
              AllOf(HasSubstr("it has no technique 'tent-5x6'"), HasSubstr("did you mean 'tent-5x5'?")));
  EXPECT_THAT(problem(before(), {"pcss-24-16"}), HasSubstr("'pcss-24-16' was measured again"));
}

}  // namespace
}  // namespace penumbra::study
