// The rules find what the first lines of a file say (found/), with its place and rule, and nothing else
// (silent/).
#include <gtest/gtest.h>

#include "lint/linted_shader.h"
#include "lint/suppression.h"
#include "lint/text_rules.h"
#include "shaders/expected_messages.h"
#include "shaders/source_memory.h"

namespace penumbra::lint {
namespace {

void add(const shaders::CompileRequest& request, shaders::Messages& messages) {
  messages.add(lint(request));
  shaders::SourceMemory memory;
  const shaders::PreprocessedSource source = shaders::expand(request, memory);
  messages.add(
      without_suppressed(text_findings(source.text, request.file.string(), source.sources), source.sources));
}

class LintMessages : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(LintMessages, AreThoseOfTheFirstLines) {
  shaders::Messages messages(GetParam());
  for (const shaders::CompileRequest& request : shaders::requests_for(GetParam())) add(request, messages);
  messages.remove_repeated();  // the text of all entry points is one
  EXPECT_EQ(messages.text(), shaders::expected_of(GetParam()).messages) << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Found, LintMessages, testing::ValuesIn(shaders::files_of("lint/found", ".hlsl")),
                         shaders::name_of_file);
INSTANTIATE_TEST_SUITE_P(Silent, LintMessages, testing::ValuesIn(shaders::files_of("lint/silent", ".hlsl")),
                         shaders::name_of_file);

}  // namespace
}  // namespace penumbra::lint
