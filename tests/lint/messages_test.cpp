// The rules find what the first lines of a file say (found/), with its place and rule, and nothing else
// (silent/).
#include <gtest/gtest.h>

#include "lint/linted_shader.h"
#include "shaders/expected_messages.h"

namespace penumbra::lint {
namespace {

class LintMessages : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(LintMessages, AreThoseOfTheFirstLines) {
  shaders::Messages messages(GetParam());
  for (const shaders::CompileRequest& request : shaders::requests_for(GetParam()))
    messages.add(lint(request));
  EXPECT_EQ(messages.text(), shaders::expected_of(GetParam()).messages) << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Found, LintMessages, testing::ValuesIn(shaders::files_of("lint/found", ".hlsl")),
                         shaders::name_of_file);
INSTANTIATE_TEST_SUITE_P(Silent, LintMessages, testing::ValuesIn(shaders::files_of("lint/silent", ".hlsl")),
                         shaders::name_of_file);

}  // namespace
}  // namespace penumbra::lint
