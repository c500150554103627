// Tests progress by a clock of the test's own: when a line is due, what it says, and when nothing is said.
#include "cli/progress.h"

#include <gmock/gmock.h>

#include <string>

#include "cli/program.h"
#include "cli/subcommand.h"

namespace penumbra::cli {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ProgressLines : public testing::Test {
 protected:
  ProgressLines() {
    outlet_->bar = false;
    outlet_->now = [this] { return time_; };
    outlet_->write = [this](std::string_view text) { written_.emplace_back(text); };
    outlet_->started = outlet_->last_line = time_;
  }

  std::shared_ptr<ProgressOutlet> outlet_ = std::make_shared<ProgressOutlet>();
  ProgressOutlet::Clock::time_point time_ = ProgressOutlet::Clock::now();
  std::vector<std::string> written_;
};

TEST_F(ProgressLines, OneEveryTenSecondsAndNoneBefore) {
  Progress progress(outlet_, "reference");
  time_ += milliseconds(9999);
  progress.update(1, 40, "rows");
  EXPECT_THAT(written_, IsEmpty());
  time_ += milliseconds(1);
  progress.update(12, 40, "rows");
  progress.update(13, 40, "rows");
  time_ += seconds(9);
  progress.update(14, 40, "rows");
  EXPECT_THAT(written_, ElementsAre("penumbra: reference: 12/40 rows (30 %), 10 s\n"));
  time_ += seconds(61);
  progress.update(39, 40, " rows");
  EXPECT_EQ(written_.back(), "penumbra: reference: 39/40 rows (98 %), 1 min 20 s\n");
}

TEST_F(ProgressLines, ShortStagesShareTheTenSeconds) {
  for (int stage = 0; stage < 5; ++stage) {
    Progress progress(outlet_, "scene " + std::to_string(stage));
    time_ += seconds(4);
    progress.update(1, 1);
  }
  EXPECT_THAT(written_, ElementsAre("penumbra: scene 2: 1/1 (100 %), 12 s\n"));
}

TEST_F(ProgressLines, ATerminalGetsABarThatIsTakenAway) {
  outlet_->bar = true;
  {
    Progress progress(outlet_, "validate");
    time_ += seconds(1);
    progress.update(0, 10, "shaders");
  }
  ASSERT_EQ(written_.size(), 2U);
  EXPECT_THAT(written_[0], HasSubstr("validate [....."));
  EXPECT_EQ(written_[1], "\r\x1b[K");
}

TEST_F(ProgressLines, QuietHasNoOutlet) {
  Context context;
  EXPECT_NE(context.progress(), nullptr);
  context.quiet = true;
  EXPECT_EQ(context.progress(), nullptr);
  Progress progress(context.progress(), "validate");
  progress.update(1, 2);
}

}  // namespace
}  // namespace penumbra::cli
