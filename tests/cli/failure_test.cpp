// Each kind of exception becomes an exit code and words.
#include "cli/command_line.h"

#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>
#include <new>
#include <stdexcept>

#include "has_substrs.h"
#include "input/input_error.h"
#include "platform/interrupt.h"

namespace penumbra::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

template <typename Exception>
Failure failure_after(const Exception& exception) {
  return failure_of(std::make_exception_ptr(exception));
}

TEST(Failure, InputIsTwoAndTheEnvironmentThree) {
  EXPECT_EQ(failure_after(InputError("a.json:1", "is wrong", "mend it")).code, 2);
  EXPECT_EQ(failure_after(InputError("a.json:1", "is wrong", "mend it")).message,
            "a.json:1: is wrong\n  mend it");
  EXPECT_EQ(failure_after(EnvironmentError("no device")).code, 3);
  EXPECT_EQ(failure_after(std::bad_alloc()).code, 3);
  EXPECT_EQ(failure_after(std::filesystem::filesystem_error("cannot copy", "from", std::error_code())).code,
            2);
  EXPECT_EQ(failure_after(platform::Interrupted()).code, 130);
}

TEST(Failure, EverythingElseIsOurMistakeAndAsksForAReport) {
  const Failure failure = failure_after(std::logic_error("a raster pass without a target"));
  EXPECT_EQ(failure.code, 70);
  EXPECT_THAT(failure.message, HasSubstrs("a raster pass without a target", "please report it"));
  EXPECT_EQ(failure_after(3).code, 70);
  EXPECT_THAT(failure_after(InputError("", "is wrong")).message, Not(HasSubstr("report")));
}

template <typename Exception>
[[noreturn]] void throws(const Exception& exception) {
  throw exception;
}

template <typename Exception>
void end_with(const Exception& exception) noexcept {
  answer_uncaught_exceptions();
  throws(exception);
}

TEST(FailureDeathTest, MemoryThatRunsOutWhereNothingMayThrowIsAnswered) {
  EXPECT_EXIT(end_with(std::bad_alloc()), testing::ExitedWithCode(3), "^penumbra: out of memory");
  EXPECT_EXIT(end_with(std::logic_error("a mistake")), testing::KilledBySignal(SIGABRT), "");
}

}  // namespace
}  // namespace penumbra::cli
