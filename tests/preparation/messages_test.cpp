// Sources that Unity's compilers refuse (refused/) give the messages in their first lines, at their places,
// and those that they take (taken/) give none.
#include <gtest/gtest.h>

#include "shaders/expected_messages.h"

namespace penumbra::preparation {
namespace {

class PreparationMessages : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(PreparationMessages, AreThoseOfTheFirstLines) {
  shaders::expect_messages_of(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Refused, PreparationMessages,
                         testing::ValuesIn(shaders::files_of("preparation/refused", ".hlsl")),
                         shaders::name_of_file);
INSTANTIATE_TEST_SUITE_P(Taken, PreparationMessages,
                         testing::ValuesIn(shaders::files_of("preparation/taken", ".hlsl")),
                         shaders::name_of_file);

}  // namespace
}  // namespace penumbra::preparation
