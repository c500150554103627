// A worker's answer arrives as it was, and bytes that are no answer are refused.
#include "platform/worker_answer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "input/input_error.h"

namespace penumbra::platform {
namespace {

std::string answer_to(const InputError& error) {
  return answer_or_input_error([&]() -> std::string { throw error; });
}

std::string what_is_thrown(const std::string& bytes) {
  try {
    taken_answer(bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

TEST(WorkerAnswer, ArrivesAsItWas) {
  for (const std::string text : {"", "i", "several\nlines"})
    EXPECT_EQ(taken_answer(answer_or_input_error([&] { return text; })), text);
}

TEST(WorkerAnswer, AnInputErrorArrivesWithItsRemedy) {
  for (const InputError& error : {InputError("a.obj:3", "has no faces"),
                                  InputError("a.obj", "has no faces", "export it again\n  as glTF")})
    EXPECT_EQ(what_is_thrown(answer_to(error)), error.what());
}

TEST(WorkerAnswer, BytesThatAreNoneAreRefused) {
  for (const std::string bytes : {"", "x", "textx", "i", "\n  i", "\n  a way outi"})
    EXPECT_THROW(taken_answer(bytes), std::invalid_argument) << testing::PrintToString(bytes);
}

}  // namespace
}  // namespace penumbra::platform
