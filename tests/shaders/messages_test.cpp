// HLSL that is refused (refused/) gives the messages in its first lines, at their places, and what is taken
// (taken/) gives none. It is compiled without preparation, which finds some of the mistakes by itself.
#include <gtest/gtest.h>

#include "shaders/expected_messages.h"

namespace penumbra::shaders {
namespace {

class ShaderMessages : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(ShaderMessages, AreThoseOfTheFirstLines) {
  expect_messages_of(GetParam(), false);
}

INSTANTIATE_TEST_SUITE_P(Refused, ShaderMessages, testing::ValuesIn(files_of("shaders/refused", ".hlsl")),
                         name_of_file);
INSTANTIATE_TEST_SUITE_P(Taken, ShaderMessages, testing::ValuesIn(files_of("shaders/taken", ".hlsl")),
                         name_of_file);

}  // namespace
}  // namespace penumbra::shaders
