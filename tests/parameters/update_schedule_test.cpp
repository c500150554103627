#include "parameters/update_schedule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "input/input_error.h"

namespace penumbra::parameters {
namespace {

TEST(UpdateSchedule, DrawsEachCascadeOnceInItsPeriod) {
  const UpdateSchedule schedule = update_schedule(std::vector{1, 2, 4, 8});
  for (int cascade = 0; cascade < 4; ++cascade) {
    const int period = schedule.periods[static_cast<std::size_t>(cascade)];
    int since = schedule.age(cascade, -100);
    for (int frame = -99; frame < 100; ++frame) {
      const bool due = schedule.is_due(cascade, frame);
      since = due ? 0 : since + 1;
      ASSERT_EQ(schedule.age(cascade, frame), since) << cascade << ", " << frame;
      ASSERT_LT(since, period);
      ASSERT_EQ((schedule.due(frame) >> cascade & 1) != 0, due);
    }
  }
  EXPECT_DOUBLE_EQ(schedule.mean_due(), 1.875);
  EXPECT_EQ(schedule.most_due(), 2);
  EXPECT_DOUBLE_EQ(schedule.largest_age_degrees(3, 0.005), 0.035);
  EXPECT_EQ(schedule.largest_age_degrees(0, 0.005), 0.0);
}

// The largest number of cascades in a frame that the best phases give, by trying every combination of phases.
int fewest_possible(const std::vector<int>& periods) {
  int fewest = static_cast<int>(periods.size());
  int combinations = 1;
  for (const int period : periods) combinations *= period;
  for (int combination = 0; combination < combinations; ++combination) {
    int rest = combination;
    int most = 0;
    std::vector<int> phases;
    for (const int period : periods) {
      phases.push_back(rest % period);
      rest /= period;
    }
    for (int frame = 0; frame < 8; ++frame) {
      int due = 0;
      for (std::size_t i = 0; i < periods.size(); ++i) due += frame % periods[i] == phases[i] ? 1 : 0;
      most = std::max(most, due);
    }
    fewest = std::min(fewest, most);
  }
  return fewest;
}

TEST(UpdateSchedule, NoOtherPhasesNeedFewerCascadesInAFrame) {
  const std::vector<int> choices{1, 2, 4, 8};
  for (const int a : choices)
    for (const int b : choices)
      for (const int c : choices)
        for (const int d : choices)
          for (const std::vector<int>& periods :
               {std::vector{a}, std::vector{a, b}, std::vector{a, b, c}, std::vector{a, b, c, d}})
            ASSERT_EQ(update_schedule(periods).most_due(), fewest_possible(periods))
                << testing::PrintToString(periods);
}

TEST(UpdateSchedule, HasNoOtherCascades) {
  for (const int cascade : {-1, 2, 4}) {
    EXPECT_THROW(update_schedule(std::vector{1, 2}).is_due(cascade, 0), std::out_of_range) << cascade;
    EXPECT_THROW(UpdateSchedule{}.largest_age_degrees(cascade, 1.0), std::out_of_range) << cascade;
  }
}

TEST(UpdateSchedule, RefusesOtherPeriods) {
  for (const std::vector<int>& periods : {std::vector<int>{}, std::vector{1, 1, 1, 1, 1}, std::vector{0},
                                          std::vector{-2}, std::vector{3}, std::vector{1, 128}}) {
    try {
      update_schedule(periods);
      FAIL() << testing::PrintToString(periods);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::AnyOf(testing::HasSubstr("powers of two from 1 to 64"),
                                               testing::HasSubstr("one to four cascades")));
    }
  }
}

}  // namespace
}  // namespace penumbra::parameters
